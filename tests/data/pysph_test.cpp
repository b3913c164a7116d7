// samples/pysph_dam_break.hdf5 is PySPH's own output with fewer particles (see cut_pysph.py there).
// What is expected of it is read with HDF5 itself.
#include "hdf5_folder.hpp"

#include <meniscus/data/particles/snapshot.hpp>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

const fs::path sample = fs::path(MENISCUS_TEST_SAMPLES) / "pysph_dam_break.hdf5";
const fs::path shared = fs::path(MENISCUS_SHARED_SNAPSHOTS) / "pysph";

/// All values of a dataset, as HDF5 gives them.
std::vector<double> values_in(const fs::path& file, const std::string& path) {
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(opened, path.c_str(), H5P_DEFAULT);
    const hid_t space = H5Dget_space(dataset);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    H5Dclose(dataset);
    H5Fclose(opened);
    return values;
}

/// The three properties of an array, as vectors.
Positions vectors_in(const fs::path& file, const std::string& array,
                     const std::array<const char*, 3>& names) {
    Positions vectors;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto values = values_in(file, "/particles/" + array + "/arrays/" + names[axis]);
        vectors.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            vectors[i][axis] = values[i];
    }
    return vectors;
}

Positions positions_in(const fs::path& file, const std::string& array) {
    return vectors_in(file, array, {"x", "y", "z"});
}

std::vector<double> flattened(const Positions& vectors) {
    std::vector<double> values;
    for (const auto& vector : vectors)
        values.insert(values.end(), vector.begin(), vector.end());
    return values;
}

class Pysph : public Hdf5Folder {
protected:
    Pysph() : Hdf5Folder("state.hdf5") {}

    void SetUp() override {
        Hdf5Folder::SetUp();
        fs::copy_file(sample, file);
        fs::permissions(file, fs::perms::owner_write, fs::perm_options::add);
    }

    void put(const std::string& property, const std::vector<double>& values) const {
        replace<double>(("/particles/" + property).c_str(), H5T_NATIVE_DOUBLE, {values.size()},
                        values);
    }

    void copy(const char* from, const char* to) const {
        edit([&](hid_t opened) {
            ASSERT_GE(H5Ocopy(opened, from, opened, to, H5P_DEFAULT, H5P_DEFAULT), 0);
        });
    }

    void move(const char* from, const char* to) const {
        copy(from, to);
        remove(from);
    }
};

TEST_F(Pysph, ReadsTheFluidUnderOurNames) {
    const Snapshot snapshot = read_snapshot(file);
    const std::string arrays = "/particles/fluid/arrays/";
    EXPECT_EQ(snapshot.positions, positions_in(file, "fluid"));
    EXPECT_EQ(snapshot.position_precision, Precision::float64);
    EXPECT_EQ(snapshot.dimension, 2);
    ASSERT_NE(find_array(snapshot, "velocity"), nullptr);
    EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
    EXPECT_EQ(as_doubles(*find_array(snapshot, "velocity")),
              flattened(vectors_in(file, "fluid", {"u", "v", "w"})));
    EXPECT_EQ(scalar_values(snapshot, "density"), values_in(file, arrays + "rho"));
    EXPECT_EQ(scalar_values(snapshot, "mass"), values_in(file, arrays + "m"));
    EXPECT_EQ(scalar_values(snapshot, "pressure"), values_in(file, arrays + "p"));
    EXPECT_EQ(scalar_values(snapshot, "pid"), values_in(file, arrays + "pid"));
    for (const char* none : {"id", "gid", "tag", "phase", "x", "u", "rho", "m", "p", "h", "arho"})
        EXPECT_EQ(find_array(snapshot, none), nullptr) << none;
    EXPECT_FALSE(snapshot.particle_spacing);
    EXPECT_EQ(snapshot.provenance.at("fluid_arrays"), "fluid");
}

TEST_F(Pysph, ReadsTheBoundary) {
    const Snapshot snapshot = read_snapshot(file);
    EXPECT_EQ(snapshot.boundary, positions_in(file, "boundary"));
    EXPECT_EQ(snapshot.provenance.at("boundary_arrays"), "boundary");
}

TEST_F(Pysph, ReadsTheTime) {
    double time = 0;
    edit([&](hid_t opened) {
        const hid_t t = H5Aopen_by_name(opened, "/solver_data", "t", H5P_DEFAULT, H5P_DEFAULT);
        H5Aread(t, H5T_NATIVE_DOUBLE, &time);
        H5Aclose(t);
    });
    EXPECT_EQ(read_snapshot(file).time, time);
    edit([&](hid_t opened) { H5Adelete_by_name(opened, "/solver_data", "t", H5P_DEFAULT); });
    EXPECT_FALSE(read_snapshot(file).time);
}

TEST_F(Pysph, TheSupportRadiusIsTwiceTheSmoothingLength) {
    const auto h = values_in(file, "/particles/fluid/arrays/h");
    std::vector<double> radii(h);
    std::transform(h.begin(), h.end(), radii.begin(), [](double x) { return 2 * x; });
    const Snapshot varying = read_snapshot(file);
    EXPECT_FALSE(varying.support_radius);
    EXPECT_EQ(scalar_values(varying, "support_radius"), radii);
    expect_mentions(varying.provenance.at("support_radius_from"),
                    {"2 x", "smoothing length", " to ", "--support-radius"});

    put("fluid/arrays/h", std::vector<double>(h.size(), 0.0169));
    const Snapshot constant = read_snapshot(file);
    EXPECT_EQ(constant.support_radius, 2 * 0.0169);
    EXPECT_EQ(find_array(constant, "support_radius"), nullptr);
    expect_mentions(constant.provenance.at("support_radius_from"), {"2 x", "h of 0.0169 m"});
}

TEST_F(Pysph, NoSupportRadiusIsMadeUp) {
    const std::size_t count = read_snapshot(file).size();
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        std::vector<double> h(count, 0.1);
        h[1] = bad;
        put("fluid/arrays/h", h);
        const Snapshot snapshot = read_snapshot(file);
        EXPECT_FALSE(snapshot.support_radius);
        EXPECT_EQ(find_array(snapshot, "support_radius"), nullptr);
        EXPECT_EQ(snapshot.provenance.count("support_radius_from"), 0U);
    }
    remove("/particles/fluid/arrays/h");
    EXPECT_FALSE(read_snapshot(file).support_radius);
}

TEST_F(Pysph, CopiesOfOtherProcessesAreLeftOutAndGhostsCover) {
    for (const char* array : {"fluid", "boundary"}) {
        std::vector<double> tags(positions_in(file, array).size());
        tags[0] = 1; // another process's
        tags[2] = 2; // a ghost
        put(array + std::string("/arrays/tag"), tags);
    }
    const Snapshot snapshot = read_snapshot(file);
    Positions fluid = positions_in(file, "fluid");
    Positions walls = positions_in(file, "boundary");
    Positions boundary = {fluid[2]}; // the fluid's ghost, the walls, and their ghost
    boundary.insert(boundary.end(), walls.begin() + 3, walls.end());
    boundary.insert(boundary.begin() + 1, walls[1]);
    boundary.push_back(walls[2]);
    fluid.erase(fluid.begin() + 2);
    fluid.erase(fluid.begin());
    EXPECT_EQ(snapshot.positions, fluid);
    EXPECT_EQ(snapshot.boundary, boundary);
    auto density = values_in(file, "/particles/fluid/arrays/rho");
    density.erase(density.begin() + 2);
    density.erase(density.begin());
    EXPECT_EQ(scalar_values(snapshot, "density"), density);
}

TEST_F(Pysph, IdsAreKeptWhereTheyTellParticlesApart) {
    std::vector<double> ids(read_snapshot(file).size());
    std::iota(ids.begin(), ids.end(), 17);
    put("fluid/arrays/gid", ids);
    EXPECT_EQ(scalar_values(read_snapshot(file), "id"), ids);
}

TEST_F(Pysph, PropertiesOfSeveralValuesAreKept) {
    std::vector<double> matrices(9 * read_snapshot(file).size());
    std::iota(matrices.begin(), matrices.end(), 0);
    put("fluid/arrays/matrix", matrices);
    const Snapshot snapshot = read_snapshot(file);
    ASSERT_NE(find_array(snapshot, "matrix"), nullptr);
    EXPECT_EQ(find_array(snapshot, "matrix")->components, 9);
    EXPECT_EQ(as_doubles(*find_array(snapshot, "matrix")), matrices);
}

TEST_F(Pysph, SeveralFluidsArePhases) {
    const Snapshot one = read_snapshot(file);
    put("fluid/arrays/only_here", std::vector<double>(one.size(), 1));
    copy("/particles/fluid", "/particles/oil");
    remove("/particles/oil/arrays/only_here");
    const Snapshot two = read_snapshot(file);
    ASSERT_EQ(two.size(), 2 * one.size());
    EXPECT_TRUE(std::equal(one.positions.begin(), one.positions.end(), two.positions.begin()));
    EXPECT_TRUE(std::equal(one.positions.begin(), one.positions.end(),
                           two.positions.begin() + static_cast<std::ptrdiff_t>(one.size())));
    std::vector<double> phases(one.size(), 0);
    phases.insert(phases.end(), one.size(), 1);
    EXPECT_EQ(scalar_values(two, "phase"), phases);
    EXPECT_EQ(find_array(two, "only_here"), nullptr);
    EXPECT_EQ(scalar_values(two, "density").size(), two.size());
    EXPECT_EQ(two.provenance.at("fluid_arrays"), "fluid, oil");
    EXPECT_EQ(two.boundary, one.boundary);
}

TEST_F(Pysph, WallsAreToldByTheirNames) {
    const std::size_t fluid = positions_in(file, "fluid").size();
    const std::size_t other = positions_in(file, "boundary").size();
    std::string name = "boundary";
    for (const char* wall : {"solid", "Wall_left", "tank", "obstacle", "channel", "rigid_bodies"}) {
        move(("/particles/" + name).c_str(), ("/particles/" + std::string(wall)).c_str());
        name = wall;
        const Snapshot snapshot = read_snapshot(file);
        EXPECT_EQ(snapshot.size(), fluid) << wall;
        EXPECT_EQ(snapshot.boundary.size(), other) << wall;
    }
    for (const char* liquid : {"oil", "tank_water", "gas_2", "inlet", "airfoil"}) {
        move(("/particles/" + name).c_str(), ("/particles/" + std::string(liquid)).c_str());
        name = liquid;
        if (name == "airfoil")
            break;
        const Snapshot snapshot = read_snapshot(file);
        EXPECT_EQ(snapshot.size(), fluid + other) << liquid;
        EXPECT_TRUE(snapshot.boundary.empty()) << liquid;
        EXPECT_EQ(find_array(snapshot, "phase") == nullptr, name == "inlet") << liquid;
    }
    expect_mentions(reading_error(), {"/particles/airfoil", "--fluid airfoil", "--walls airfoil"});
    ReadChoices choices;
    choices.walls = {"airfoil"};
    EXPECT_EQ(read_snapshot(file, choices).boundary.size(), other);
    choices = {};
    choices.fluid = {"airfoil"};
    EXPECT_EQ(read_snapshot(file, choices).size(), other);
    choices = {};
    choices.ignored = {"airfoil"};
    EXPECT_EQ(read_snapshot(file, choices).size(), fluid);
    EXPECT_TRUE(read_snapshot(file, choices).boundary.empty());
    choices.ignored = {"brick"};
    expect_mentions(error_of<InputError>([&] { read_snapshot(file, choices); }),
                    {"'brick'", "airfoil, fluid"});
    put("airfoil/arrays/body_id", std::vector<double>(other, 0)); // which rigid bodies have
    EXPECT_EQ(read_snapshot(file).boundary.size(), other);
}

TEST_F(Pysph, AnArrayThatIsAloneIsFluid) {
    remove("/particles/fluid");
    const Snapshot snapshot = read_snapshot(file);
    EXPECT_EQ(snapshot.positions, positions_in(file, "boundary"));
    EXPECT_TRUE(snapshot.boundary.empty());
}

TEST_F(Pysph, WhatIsNotStoredInTwoDimensionsIsZero) {
    for (const char* array : {"fluid", "boundary"})
        remove(("/particles/" + std::string(array) + "/arrays/z").c_str());
    put("fluid/arrays/w", {}); // as PySPH writes what it does not store
    const Snapshot snapshot = read_snapshot(file);
    EXPECT_EQ(snapshot.dimension, 2);
    EXPECT_EQ(snapshot.positions, positions_in(sample, "fluid"));
    EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
}

TEST_F(Pysph, ThreeDimensionsAreToldByTheWallsToo) {
    const std::size_t walls = positions_in(file, "boundary").size();
    std::vector<double> z(walls);
    std::iota(z.begin(), z.end(), 0);
    put("boundary/arrays/z", z);
    EXPECT_EQ(read_snapshot(file).dimension, 3);
}

TEST_F(Pysph, FilesWithoutFluidAreRefused) {
    const std::size_t count = read_snapshot(file).size();
    put("fluid/arrays/tag", std::vector<double>(count, 2));
    expect_mentions(reading_error(), {"state.hdf5", "fluid particles", "none in the arrays fluid"});
    move("/particles/fluid", "/particles/tank");
    expect_mentions(reading_error(), {"fluid particles", "boundary, tank, which are walls"});
    remove("/particles/tank");
    remove("/particles/boundary");
    expect_mentions(reading_error(), {"fluid particles"});
}

TEST_F(Pysph, WrongPropertiesAreNamed) {
    const std::size_t count = read_snapshot(file).size();
    put("fluid/arrays/rho", std::vector<double>(count + 1));
    expect_mentions(reading_error(), {"/particles/fluid/arrays/rho", "values"});
    remove("/particles/fluid/arrays/rho");
    put("fluid/arrays/y", std::vector<double>(2 * count));
    expect_mentions(reading_error(), {"/particles/fluid/arrays/y", "one value a particle"});
    replace<char>("/particles/fluid/arrays/y", H5T_C_S1, {count}, std::vector<char>(count));
    expect_mentions(reading_error(), {"/particles/fluid/arrays/y", "another type"});
    replace<double>("/particles/fluid/arrays/y", H5T_NATIVE_DOUBLE, {count, 1},
                    std::vector<double>(count));
    expect_mentions(reading_error(), {"/particles/fluid/arrays/y"});
    remove("/particles/fluid/arrays/x");
    expect_mentions(reading_error(), {"/particles/fluid/arrays/x", "found none"});
    remove("/particles/fluid/arrays");
    expect_mentions(reading_error(), {"/particles/fluid/arrays"});
}

TEST_F(Pysph, SizesThatNoFileHoldsAreRefused) {
    edit([&](hid_t opened) {
        H5Ldelete(opened, "/particles/fluid/arrays/x", H5P_DEFAULT);
        const hsize_t particles = 1'000'000'000'000'000'000;
        const hid_t space = H5Screate_simple(1, &particles, nullptr);
        const hid_t dataset = H5Dcreate2(opened, "/particles/fluid/arrays/x", H5T_NATIVE_DOUBLE,
                                         space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        ASSERT_GE(dataset, 0);
        H5Dclose(dataset);
        H5Sclose(space);
    });
    expect_mentions(reading_error(), {"/particles/fluid/arrays/x", "1000000000000000000"});
}

TEST_F(Pysph, WhatCrashesHdf5IsReadOrRefused) {
    // Found by fuzzing; what version 1.10.8 does is in their names.
    for (const char* name : {"hdf5_divides_by_zero.hdf5", "hdf5_takes_all_memory.vtkhdf",
                             "hdf5_reads_far_beyond.vtkhdf"}) {
        try {
            read_snapshot(fs::path(MENISCUS_TEST_SAMPLES) / name);
        } catch (const InputError& error) {
            expect_mentions(error.what(), {name});
        }
    }
}

TEST_F(Pysph, ChunksOfLessThanTheirSizeAreRefused) {
    const std::size_t count = read_snapshot(file).size();
    for (const bool deflated : {true, false}) {
        edit([&](hid_t opened) {
            H5Ldelete(opened, "/particles/fluid/arrays/rho", H5P_DEFAULT);
            const hsize_t extent = count;
            const hid_t space = H5Screate_simple(1, &extent, nullptr);
            const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
            H5Pset_chunk(creation, 1, &extent);
            if (deflated)
                H5Pset_deflate(creation, 1);
            const hid_t dataset =
                H5Dcreate2(opened, "/particles/fluid/arrays/rho", H5T_NATIVE_DOUBLE, space,
                           H5P_DEFAULT, creation, H5P_DEFAULT);
            const std::vector<double> half(count / 2);
            std::vector<Bytef> bytes(1000);
            uLongf size = bytes.size();
            compress(bytes.data(), &size, reinterpret_cast<const Bytef*>(half.data()),
                     half.size() * sizeof(double));
            const hsize_t offset = 0;
            EXPECT_GE(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, &offset, size, bytes.data()), 0);
            H5Dclose(dataset);
            H5Pclose(creation);
            H5Sclose(space);
        });
        expect_mentions(reading_error(), {"/particles/fluid/arrays/rho", "whole chunks"});
    }
}

TEST_F(Pysph, TruncatedFilesAreRefused) {
    const std::string whole = bytes_of(file);
    for (std::size_t length = 0; length < whole.size(); length += 127) {
        write("state.hdf5", std::string_view(whole).substr(0, length));
        expect_mentions(reading_error(), {"state.hdf5"});
    }
}

TEST_F(Pysph, DamagedFilesAreReadOrRefused) {
    const std::string whole = bytes_of(file);
    for (std::size_t i = 0; i < whole.size(); i += 61) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(~damaged[i]);
        write("state.hdf5", damaged);
        try {
            read_snapshot(file);
        } catch (const InputError& error) {
            expect_mentions(error.what(), {"state.hdf5"});
        }
    }
}

TEST_F(Pysph, AUsersBlockMayComeFirst) {
    const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(creation, 2048);
    const hid_t with_block =
        H5Fcreate((folder / "block.hdf5").c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT);
    edit([&](hid_t opened) {
        H5Ocopy(opened, "/particles", with_block, "/particles", H5P_DEFAULT, H5P_DEFAULT);
        H5Ocopy(opened, "/solver_data", with_block, "/solver_data", H5P_DEFAULT, H5P_DEFAULT);
    });
    H5Fclose(with_block);
    H5Pclose(creation);
    EXPECT_EQ(read_snapshot(folder / "block.hdf5").positions, positions_in(file, "fluid"));
}

TEST_F(Pysph, ReadsTheSharedFiles) {
    if (!fs::exists(shared))
        GTEST_SKIP() << "no " << shared;
    for (const char* name : {"dam_break_2d_04000", "dam_break_2d_08000", "elliptical_drop_00100"}) {
        const fs::path real = (shared / name).concat(".hdf5");
        const Snapshot snapshot = read_snapshot(real);
        EXPECT_EQ(snapshot.positions, positions_in(real, "fluid")) << name;
        EXPECT_EQ(snapshot.dimension, 2) << name;
        const bool is_drop = name[0] == 'e';
        EXPECT_EQ(snapshot.boundary, is_drop ? Positions() : positions_in(real, "boundary"));
        EXPECT_EQ(snapshot.support_radius.has_value(), is_drop); // constant there
        if (is_drop) {
            EXPECT_EQ(snapshot.support_radius,
                      2 * values_in(real, "/particles/fluid/arrays/h").at(0));
        }
    }
}

} // namespace
} // namespace meniscus
