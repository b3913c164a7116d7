// Makes the shipped samples from SPlisHSPlasH's legacy VTK files: positions only, with support
// radius, particle spacing, time and scene from the scenes.json beside them. Usage:
//   make_samples FOLDER_WITH_SCENES_JSON OUTPUT_FOLDER STATE...
#include <meniscus/data/formats/snapshot_formats.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>

#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

int main(int argument_count, char** arguments) {
    try {
        if (argument_count < 4)
            throw std::runtime_error("usage: make_samples FOLDER OUTPUT_FOLDER STATE...");
        const std::filesystem::path folder = arguments[1];
        const auto scenes = nlohmann::json::parse(std::ifstream(folder / "scenes.json"));
        for (int a = 3; a < argument_count; ++a) {
            const std::string state = arguments[a];
            const auto& entry = scenes.at(state + ".vtk");
            meniscus::Snapshot snapshot =
                meniscus::legacy_vtk_format().read(folder / (state + ".vtk"));
            snapshot.point_data.clear();
            snapshot.support_radius = entry.at("support_radius").get<double>();
            snapshot.particle_spacing = 2 * entry.at("particle_radius").get<double>();
            snapshot.time = entry.at("time").get<double>();
            snapshot.scene = entry.at("scene").get<std::string>();
            snapshot.provenance["solver"] =
                "SPlisHSPlasH 2.16, " + entry.at("pressure_solver").get<std::string>();
            write_vtkhdf(snapshot, std::filesystem::path(arguments[2]) / (state + ".vtkhdf"));
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_samples: %s\n", error.what());
        return 1;
    }
}
