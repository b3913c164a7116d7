// Writes the files that read_with_vtk.py opens with VTK: every number type, three components, a
// name with punctuation, two and three dimensions, both precisions, and the smallest sizes. Value
// c of particle i is 10 i + c throughout, so that the reader can tell what belongs where.
#include <meniscus/data/formats/vtkhdf.hpp>

#include <cstdio>
#include <exception>

namespace {

template <class Number>
void add(meniscus::Snapshot& snapshot, const char* name, int components = 1) {
    std::vector<Number> values;
    for (std::size_t i = 0; i < snapshot.size(); ++i)
        for (int c = 0; c < components; ++c)
            values.push_back(static_cast<Number>(10 * i + static_cast<std::size_t>(c)));
    meniscus::set_array(snapshot, {name, components, std::move(values)});
}

meniscus::Snapshot sample(std::size_t particles, int dimension) {
    meniscus::Snapshot snapshot;
    snapshot.dimension = dimension;
    snapshot.position_precision =
        dimension == 2 ? meniscus::Precision::float32 : meniscus::Precision::float64;
    for (std::size_t i = 0; i < particles; ++i) {
        const auto x = static_cast<double>(10 * i);
        snapshot.positions.push_back({x, x + 1, dimension == 2 ? 0 : x + 2});
    }
    add<std::int8_t>(snapshot, "int8");
    add<std::uint8_t>(snapshot, "uint8");
    add<std::int16_t>(snapshot, "int16");
    add<std::uint16_t>(snapshot, "uint16");
    add<std::int32_t>(snapshot, "int32");
    add<std::uint32_t>(snapshot, "uint32");
    add<std::int64_t>(snapshot, "int64");
    add<std::uint64_t>(snapshot, "uint64");
    add<float>(snapshot, "Surf.Class_(SurfZR20)");
    add<double>(snapshot, "uncovered_fraction");
    add<float>(snapshot, "velocity", 3);
    snapshot.support_radius = 0.08;
    snapshot.particle_spacing = 0.04;
    snapshot.time = 0.3;
    snapshot.scene = "sample";
    snapshot.provenance["method"] = "exact";
    return snapshot;
}

} // namespace

int main(int argc, char** argv) {
    try {
        const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
        std::filesystem::create_directories(folder);
        for (const std::size_t particles : {0, 1, 12, 20'000}) {
            for (const int dimension : {2, 3}) {
                const std::string name =
                    std::to_string(dimension) + "d_" + std::to_string(particles) + ".vtkhdf";
                meniscus::write_vtkhdf(sample(particles, dimension), folder / name);
            }
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
