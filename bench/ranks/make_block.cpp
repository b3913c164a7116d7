// make_block EDGE FILE: a state of EDGE^3 particles to measure large states by, a cube whose layers
// are shifted against each other. Written as it is made, so that it may be larger than memory.
#include <meniscus/data/formats/vtkhdf.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace {

meniscus::Positions rows_of_cube(std::uint64_t edge, std::uint64_t first, std::uint64_t count) {
    meniscus::Positions positions(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t x = (first + i) % edge;
        const std::uint64_t y = (first + i) / edge % edge;
        const std::uint64_t z = (first + i) / edge / edge;
        positions[i] = {0.5 * static_cast<double>(x) + 0.05 * static_cast<double>((3 * y + z) % 5),
                        0.5 * static_cast<double>(y) + 0.03 * static_cast<double>((2 * x + z) % 7),
                        0.5 * static_cast<double>(z)};
    }
    return positions;
}

} // namespace

int main(int argument_count, char** arguments) {
    const std::uint64_t edge = argument_count == 3 ? std::strtoull(arguments[1], nullptr, 10) : 0;
    if (edge == 0) {
        std::fputs("usage: make_block EDGE FILE\n", stderr);
        return 2;
    }
    try {
        meniscus::FetchedSnapshot cube;
        cube.frame.support_radius = 1; // m, two spacings
        cube.frame.particle_spacing = 0.5;
        cube.frame.position_precision = meniscus::Precision::float32;
        cube.size = edge * edge * edge;
        cube.positions = [edge](std::uint64_t first, std::uint64_t count) {
            return rows_of_cube(edge, first, count);
        };
        meniscus::write_vtkhdf(cube, arguments[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_block: %s\n", error.what());
        return 3;
    }
    return 0;
}
