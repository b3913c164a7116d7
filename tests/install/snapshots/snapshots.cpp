// Writes a block of particles, labels it and reads it back.
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <algorithm>
#include <cstdio>

int main(int /*argument_count*/, char** arguments) {
    meniscus::Snapshot snapshot;
    snapshot.support_radius = 1;
    for (int z = 0; z < 10; ++z)
        for (int y = 0; y < 10; ++y)
            for (int x = 0; x < 10; ++x)
                snapshot.positions.push_back({0.45 * x, 0.45 * y, 0.45 * z});
    meniscus::LabelOptions options;
    options.samples = 1000;
    const auto labels = meniscus::label_particles(snapshot, 1, options);
    meniscus::add_labels(snapshot, labels, 1, options);
    meniscus::write_vtkhdf(snapshot, arguments[1]);

    const auto surface = meniscus::scalar_values(meniscus::read_snapshot(arguments[1]), "surface");
    const auto count = std::count(surface.begin(), surface.end(), 1);
    std::printf("%td of %zu particles are surface\n", count, surface.size());
    return count > 0 && count < 1000 ? 0 : 1;
}
