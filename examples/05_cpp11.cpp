// For solvers in C++11 or 14, which the headers of the runtime (C++17) are not for: the C
// interface, held by what C++11 has. A disc of fluid in two dimensions, whose rim is surface.
#include <meniscus/meniscus.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

namespace {

void demand(int status) {
    if (status != MENISCUS_OK)
        throw std::runtime_error(meniscus_last_error());
}

struct Destroy {
    void operator()(meniscus_surface* surface) const { meniscus_destroy(surface); }
};
using Surface = std::unique_ptr<meniscus_surface, Destroy>;

Surface create(const meniscus_options& options, int dimension) {
    meniscus_surface* surface = nullptr;
    demand(meniscus_create(&surface, &options, dimension, MENISCUS_DOUBLE));
    return Surface(surface);
}

struct Fluid {
    double support_radius;
    std::vector<double> positions;
    std::vector<std::uint64_t> offsets;
    std::vector<std::uint32_t> neighbors;

    std::uint32_t count() const { return static_cast<std::uint32_t>(positions.size() / 2); }

    double distance(std::uint32_t i, std::uint32_t j) const {
        return std::hypot(positions[2 * i] - positions[2 * j],
                          positions[2 * i + 1] - positions[2 * j + 1]);
    }

    meniscus_particles particles() const {
        meniscus_particles all = meniscus_particles();
        all.size = sizeof all;
        all.count = count();
        all.positions = positions.data();
        all.support_radius = support_radius;
        all.offsets = offsets.data();
        all.offset_bits = 64;
        all.neighbors = neighbors.data();
        return all;
    }
};

/// Of a radius of so many spacings of 1.
Fluid disc(int radius) {
    Fluid fluid;
    fluid.support_radius = 2;
    for (int x = -radius; x <= radius; ++x)
        for (int y = -radius; y <= radius; ++y)
            if (x * x + y * y <= radius * radius) {
                fluid.positions.push_back(x);
                fluid.positions.push_back(y);
            }
    fluid.offsets.push_back(0);
    for (std::uint32_t i = 0; i < fluid.count(); ++i) {
        for (std::uint32_t j = 0; j < fluid.count(); ++j)
            if (i != j && fluid.distance(i, j) < fluid.support_radius)
                fluid.neighbors.push_back(j);
        fluid.offsets.push_back(fluid.neighbors.size());
    }
    return fluid;
}

int run() {
    const Fluid fluid = disc(12);
    const meniscus_particles particles = fluid.particles();
    meniscus_options options;
    demand(meniscus_options_init(&options, sizeof options));
    options.surface_tension = 0.072;
    demand(meniscus_spacing_ratio(fluid.support_radius, 1, 2, &options.spacing_ratio));
    const Surface surface = create(options, 2);
    demand(meniscus_check(surface.get(), &particles)); // while the solver is new
    demand(meniscus_step(surface.get(), &particles));

    std::vector<std::uint8_t> classes(fluid.count());
    std::vector<double> normals(fluid.positions.size());
    demand(meniscus_scatter(surface.get(), classes.data(), nullptr, normals.data(), nullptr,
                            nullptr, 0));
    int at_surface = 0;
    bool is_as_expected = true;
    for (std::uint32_t i = 0; i < fluid.count(); ++i) {
        if (classes[i] != MENISCUS_AT_SURFACE)
            continue;
        ++at_surface;
        const double x = fluid.positions[2 * i], y = fluid.positions[2 * i + 1];
        const double along = (normals[2 * i] * x + normals[2 * i + 1] * y) / std::hypot(x, y);
        is_as_expected = is_as_expected && std::hypot(x, y) > 10 && along > 0.8;
    }
    std::printf("%d of %d particles at the surface\n", at_surface, static_cast<int>(fluid.count()));
    return is_as_expected && at_surface > 50 ? 0 : 1;
}

} // namespace

int main() {
    try {
        return run();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
