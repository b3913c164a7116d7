// Files in the shapes that other programs really write, from file to right answer by the command as
// a stranger runs it. They lie beside the project where it is developed, and are skipped elsewhere.
#include "command.hpp"

#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>
#include <sstream>

namespace meniscus {
namespace {

const Path cases = Path(MENISCUS_SHARED_SNAPSHOTS) / ".." / "cases";

struct Case {
    const char* file;
    Words options;
    std::size_t particles;
    int surface;      ///< -1: whatever
    const char* said; ///< among what is printed
};

const Words h_2d = {"--support-radius", "0.0567"};
const Words h_some = {"--support-radius", "0.1"};

const Case right[] = {
    {"a02_field_text.vtk", h_some, 512, -1, "512 particles in 3D"},
    {"a03_point_text.vtk", h_some, 512, -1, "'material' is text"},
    {"a04_particles.vtu", {"--support-radius", "0.07"}, 512, 296, ""},
    {"a04_particles.vtp", {"--support-radius", "0.07"}, 512, 296, ""},
    {"a06_no_last_newline.vtk", h_some, 216, -1, ""},
    {"a11_dsph_2d.vtk", h_2d, 1000, -1, "2D in the plane xz, taken as x, y"},
    {"a12_dsph_all.vtk", {"--support-radius", "0.0693"}, 1440, 144, "768 walls"},
    {"a13_empty_sections.vtk", h_some, 216, -1, ""},
    {"b01_paraview_xz.csv", h_2d, 600, 96, "2D in the plane xz"},
    {"b01_paraview_xz_no_y.csv", h_2d, 600, 96, "2D in the plane xz"},
    {"b02_partvtk_2d_comma.csv", h_2d, 600, 96, "2D in the plane xz"},
    {"b03_empty_type.csv", h_some, 343, -1, "'Type', 'Mk'"},
    {"b07_no_last_newline.csv", h_some, 343, -1, ""},
    {"b09_ids.csv", h_some, 343, -1, ""},
    {"b10_houdini.csv", h_some, 343, -1, ""},
    {"b11_ascii.ply", h_some, 343, -1, ""},
    {"b11_lammps.dump", h_some, 343, -1, "periodic"},
    {"b11_ovito.xyz", h_some, 343, -1, ""},
    {"b11_positions.npy", h_some, 343, -1, ""},
    {"b13_flat_noise.csv", {"--support-radius", "0.105"}, 400, -1, "2D: z is the same but"},
    {"c01_wall_named_boundary.hdf5", {}, 600, 30, "walls: boundary"},
    {"c01_wall_named_dam.hdf5", {"--walls", "dam"}, 600, 30, "walls: dam"},
    {"c01_wall_named_bed.hdf5", {"--walls", "bed"}, 600, 30, "walls: bed"},
    {"c02_inlet_outlet.hdf5", {}, 400, 20, "inlet, outlet as more of fluid"},
    {"c03_periodic.hdf5", {"--periodic", "0.8,0.8"}, 256, 0, "copies cover"},
    {"c03_periodic.hdf5", {"--periodic", "x=0:0.8"}, 256, 32, "copies cover"},
    {"c03_periodic_ghosts.hdf5", {}, 256, 0, "228 ghosts"},
    {"c07_gadget.hdf5", h_some, 343, -1, "units of the file"},
    {"c07_h5part.h5", h_some, 343, -1, "last of 2 states"},
    {"c08_one_step.vtkhdf", h_some, 343, -1, ""},
    {"c08_polydata.vtkhdf", h_some, 343, -1, ""},
    {"d01_particle_primitive.bgeo", h_some, 343, -1, ""},
};

class Cases : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        if (!std::filesystem::exists(cases))
            GTEST_SKIP() << "no " << cases;
    }

    /// Runs a scene of the cases, and returns its log.
    [[nodiscard]] Path log_of_run(const std::string& scene) const {
        succeed({"simulate", cases / ("scene_" + scene + ".json"), "-o", folder / scene});
        return folder / scene / (scene + "_log.csv");
    }
};

TEST_F(Cases, AreReadRightly) {
    for (const Case& one : right) {
        const std::string printed =
            succeed(Words{"label", cases / one.file, "-o", folder / "labels"} + one.options);
        expect_mentions(printed, {"particles in", one.said});
        const Snapshot labelled =
            read_vtkhdf(folder / "labels" / Path(one.file).stem().concat(".vtkhdf"));
        const auto surface = scalar_values(labelled, "surface");
        EXPECT_EQ(surface.size(), one.particles) << one.file;
        if (one.surface >= 0) {
            EXPECT_EQ(std::accumulate(surface.begin(), surface.end(), 0.), one.surface) << one.file;
        }
        std::filesystem::remove_all(folder / "labels");
    }
}

TEST_F(Cases, ACrowdInOnePlaceIsClassifiedInLittleMemory) {
    const Words words = {"classify",
                         cases / "g01_parked_8000.csv",
                         "--support-radius",
                         "0.04",
                         "--model",
                         Path(MENISCUS_MODELS) / "splishsplash_d13.json",
                         "-o",
                         folder / "out"};
    const Outcome outcome =
        run(Words{"sh", "-c", "ulimit -v 1000000; exec \"$@\"", "sh"} + program + words);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    expect_mentions(outcome.output, {"9000 particles", "h is 2.00 spacings"});
}

TEST_F(Cases, WallsByOtherNamesAreAskedFor) {
    for (const char* name : {"dam", "bed"})
        fail(2, {"label", cases / (std::string("c01_wall_named_") + name + ".hdf5"), "-o", folder},
             {name, "--fluid", "--walls", "--ignore"});
}

TEST_F(Cases, FluidAndWallsInOneFileOrTwoAreTheSame) {
    const Words radius = {"--support-radius", "0.0693"};
    succeed(Words{"label", cases / "a12_dsph_all.vtk", "-o", folder / "one"} + radius);
    succeed(Words{"label", cases / "a12_dsph_fluid.vtk", "--boundary", cases / "a12_dsph_bound.vtk",
                  "-o", folder / "two"} +
            radius);
    EXPECT_EQ(scalar_values(read_vtkhdf(folder / "one" / "a12_dsph_all.vtkhdf"), "surface"),
              scalar_values(read_vtkhdf(folder / "two" / "a12_dsph_fluid.vtkhdf"), "surface"));
}

/// The numbers of a column of a run's log.
std::vector<double> column_of(const Path& log, const std::string& name) {
    std::ifstream file(log);
    const auto cells_of = [](const std::string& line) {
        std::vector<std::string> cells;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, ',');)
            cells.push_back(cell);
        return cells;
    };
    std::string line;
    std::getline(file, line);
    const auto names = cells_of(line);
    const auto place = std::find(names.begin(), names.end(), name) - names.begin();
    std::vector<double> numbers;
    while (std::getline(file, line))
        numbers.push_back(std::stod(cells_of(line).at(place)));
    return numbers;
}

TEST_F(Cases, FluidAtRestAtWallsGainsNoEnergy) {
    for (const char* scene : {"layer2d", "sessile2d", "cup"}) {
        SCOPED_TRACE(scene);
        const Path log = log_of_run(scene);
        const auto kinetic = column_of(log, "kinetic_energy");
        const auto potential = column_of(log, "potential_energy");
        const auto area = column_of(log, "surface_area");
        const auto energy = [&](std::size_t frame) {
            return kinetic[frame] + potential[frame] + 0.072 * area[frame];
        };
        for (std::size_t frame = 1; frame < kinetic.size(); ++frame)
            EXPECT_LT(energy(frame), 1.01 * energy(0)) << frame;
    }
}

TEST_F(Cases, FluidInAWallIsRefused) {
    fail(2, {"simulate", cases / "scene_immersed.json", "-o", folder},
         {"'immersed'", "fluid[0]", "walls[1]", "spacings apart"});
}

/// What leaves it is counted (tests/sph/leaving_test.cpp), and ends no run.
TEST_F(Cases, ATankThatThrowsUpSprayRunsToItsEnd) {
    const auto log = log_of_run("tank");
    const auto particles = column_of(log, "particles");
    EXPECT_EQ(particles.front(), 1000);
    EXPECT_GE(particles.back(), 990);
    EXPECT_NEAR(column_of(log, "time").back(), 1, 1e-9);
}

TEST_F(Cases, AScenesSnapshotKeepsItsVelocities) {
    const auto kinetic = column_of(log_of_run("snap"), "kinetic_energy");
    EXPECT_NEAR(kinetic.front(), 16, 1e-3);
}

TEST_F(Cases, VelocitiesAreFoundUnderTheirNames) {
    for (const char* file : {"g05_Vel_0.vtk", "g05_v_0.vtk", "g05_velocity_0.vtk"}) {
        succeed({"label", cases / file, "--support-radius", "0.05", "-o", folder / "labels"});
        const Snapshot labelled =
            read_vtkhdf(folder / "labels" / Path(file).stem().concat(".vtkhdf"));
        EXPECT_NE(find_array(labelled, "velocity"), nullptr) << file;
    }
}

} // namespace
} // namespace meniscus
