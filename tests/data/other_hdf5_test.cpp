// HDF5 layouts of other programs: GADGET, H5Part, and VTKHDF that we do not write ourselves.
#include "expected_errors.hpp"
#include "hdf5_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>

#include <fstream>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

class OtherHdf5 : public Hdf5Folder {
protected:
    OtherHdf5() : Hdf5Folder("other.hdf5") {}

    void SetUp() override {
        Hdf5Folder::SetUp();
        H5Fclose(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    }

    void add_group(const char* name) const {
        edit([&](hid_t opened) {
            H5Gclose(H5Gcreate2(opened, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        });
    }

    void add(const char* name, const std::vector<hsize_t>& extents,
             const std::vector<double>& values) const {
        edit([&](hid_t opened) {
            const hid_t space =
                H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
            const hid_t dataset = H5Dcreate2(opened, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                                             H5P_DEFAULT, H5P_DEFAULT);
            if (!values.empty())
                H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
            H5Dclose(dataset);
            H5Sclose(space);
        });
    }

    void add_attribute(const char* group, const char* name, hid_t type, const void* value,
                       hsize_t count = 1) const {
        edit([&](hid_t opened) {
            const hid_t space = H5Screate_simple(1, &count, nullptr);
            const hid_t attribute = H5Acreate_by_name(opened, group, name, type, space, H5P_DEFAULT,
                                                      H5P_DEFAULT, H5P_DEFAULT);
            H5Awrite(attribute, type, value);
            H5Aclose(attribute);
            H5Sclose(space);
        });
    }

    const Positions positions = {{0, 0, 1}, {2, 0, 3}, {4, 5, 6}};
    const std::vector<double> coordinates = {0, 0, 1, 2, 0, 3, 4, 5, 6};
};

TEST_F(OtherHdf5, GasOfGadgetIsTheFluid) {
    add_group("Header");
    const double time = 0.5;
    add_attribute("Header", "Time", H5T_NATIVE_DOUBLE, &time);
    add_group("PartType0");
    add_group("PartType1");
    add("PartType0/Coordinates", {3, 3}, coordinates);
    add("PartType0/Velocities", {3, 3}, coordinates);
    add("PartType0/Masses", {3}, {1, 2, 3});
    add("PartType0/Metals", {3, 2, 2}, std::vector<double>(12));
    const Snapshot snapshot = read_snapshot(file);
    EXPECT_EQ(snapshot.positions, positions);
    EXPECT_EQ(snapshot.time, 0.5);
    EXPECT_EQ(as_doubles(*find_array(snapshot, "velocity")), coordinates);
    EXPECT_EQ(scalar_values(snapshot, "mass"), (std::vector<double>{1, 2, 3}));
    ASSERT_EQ(snapshot.notes.size(), 3U);
    expect_mentions(snapshot.notes[0], {"'Metals'"});
    expect_mentions(snapshot.notes[1], {"PartType1"});
    remove("/PartType0/Coordinates");
    add("PartType0/Coordinates", {9}, coordinates);
    expect_mentions(reading_error(), {"/PartType0/Coordinates", "x 3 coordinates"});
}

TEST_F(OtherHdf5, TheLastStepOfH5PartIsRead) {
    for (const char* step : {"Step#9", "Step#10"}) {
        const std::string group = step;
        add_group(step);
        add((group + "/x").c_str(), {2}, {group.size() * 1.0, 2});
        add((group + "/y").c_str(), {2}, {3, 4});
        add((group + "/z").c_str(), {2}, {5, 6});
        add((group + "/vx").c_str(), {2}, {1, 2});
        add((group + "/vy").c_str(), {2}, {1, 2});
        add((group + "/vz").c_str(), {2}, {1, 2});
    }
    const Snapshot snapshot = read_snapshot(file);
    EXPECT_EQ(snapshot.positions, (Positions{{7, 3, 5}, {2, 4, 6}}));
    EXPECT_NE(find_array(snapshot, "velocity"), nullptr);
    ASSERT_EQ(snapshot.notes.size(), 1U);
    expect_mentions(snapshot.notes[0], {"last of 2 states", "Step#10"});
    ReadChoices first;
    first.frame = 0;
    EXPECT_EQ(read_snapshot(file, first).positions, (Positions{{6, 3, 5}, {2, 4, 6}}));
    expect_mentions(read_snapshot(file, first).notes.at(0), {"state 0 of 0 to 1", "Step#9"});
    first.frame = 2;
    expect_mentions(error_of<InputError>([&] { read_snapshot(file, first); }),
                    {"other.hdf5", "--frame 2", "0 to 1", "2 states"});
    remove("/Step#10/y");
    expect_mentions(reading_error(), {"/Step#10/y"});
}

TEST_F(OtherHdf5, TheLastStateOfLagrangeBenchIsRead) {
    add_group("00000");
    add("00000/position", {1, 1, 2}, {7, 7});
    add("00000/particle_type", {1}, {0});
    add_group("00001");
    add("00001/position", {2, 4, 2}, {9, 9, 9, 9, 9, 9, 9, 9, 1, 2, 3, 4, 5, 6, 7, 8});
    add("00001/particle_type", {4}, {0, 1, 3, -1});
    Snapshot snapshot = read_snapshot(file);
    EXPECT_EQ(snapshot.positions, (Positions{{1, 2, 0}}));
    EXPECT_EQ(snapshot.boundary, (Positions{{3, 4, 0}, {5, 6, 0}}));
    EXPECT_EQ(snapshot.dimension, 2);
    ASSERT_EQ(snapshot.notes.size(), 3U);
    expect_mentions(snapshot.notes[0], {"metadata.json"});
    expect_mentions(snapshot.notes[1], {"last of 3 states", "state 1 of trajectory 00001"});
    expect_mentions(snapshot.notes[2], {"1 particles are fluid, 2 walls, 1 ignored"});

    ReadChoices choices;
    choices.fluid = {"particle_type=3"};
    EXPECT_EQ(read_snapshot(file, choices).positions, (Positions{{5, 6, 0}}));

    const Positions expected[] = {{{7, 7, 0}}, {{9, 9, 0}}, {{1, 2, 0}}};
    for (std::uint64_t frame = 0; frame < 3; ++frame) {
        ReadChoices one;
        one.frame = frame;
        snapshot = read_snapshot(file, one);
        EXPECT_EQ(snapshot.positions, expected[frame]);
        EXPECT_EQ(snapshot.provenance["frame"], std::to_string(frame));
        expect_mentions(snapshot.notes[1], {"of 0 to 2", frame == 0 ? "state 0 of trajectory 00000"
                                                                    : "of trajectory 00001"});
    }
    ReadChoices fourth;
    fourth.frame = 3;
    expect_mentions(error_of<InputError>([&] { read_snapshot(file, fourth); }),
                    {"other.hdf5", "--frame 3", "0 to 2", "3 states"});

    std::ofstream(folder / "metadata.json")
        << R"({"dx": 0.5, "bounds": [[0, 8], [1, 9]], "periodic_boundary_conditions": [true, false]})";
    snapshot = read_snapshot(file);
    EXPECT_EQ(snapshot.particle_spacing, 0.5);
    EXPECT_EQ(snapshot.provenance["periodic"], "x=0.0:8.0");

    remove("/00001/particle_type");
    add("00001/particle_type", {3}, {0, 1, 3});
    expect_mentions(reading_error(), {"/00001/particle_type", "4 values"});
    remove("/00001/position");
    add("00001/position", {4, 2}, {1, 2, 3, 4, 5, 6, 7, 8});
    expect_mentions(reading_error(), {"/00001/position", "states x particles"});
}

TEST_F(OtherHdf5, PolyDataAndSeriesOfOneStepAreVtkhdf) {
    add_group("VTKHDF");
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 8);
    add_attribute("VTKHDF", "Type", type, "PolyData");
    H5Tclose(type);
    const std::int64_t version[] = {2, 0};
    add_attribute("VTKHDF", "Version", H5T_NATIVE_INT64, version, 2);
    add("VTKHDF/NumberOfPoints", {1}, {3});
    add("VTKHDF/Points", {3, 3}, coordinates);
    add_group("VTKHDF/Polygons");
    add("VTKHDF/Polygons/NumberOfCells", {1}, {0});
    add_group("VTKHDF/Steps");
    std::int64_t steps = 1;
    add_attribute("VTKHDF/Steps", "NSteps", H5T_NATIVE_INT64, &steps);
    add("VTKHDF/Steps/Values", {1}, {0.25});
    const Snapshot snapshot = read_snapshot(file);
    EXPECT_EQ(snapshot.positions, positions);
    EXPECT_EQ(snapshot.time, 0.25);
    replace<double>("/VTKHDF/Polygons/NumberOfCells", H5T_NATIVE_DOUBLE, {1}, {1.0});
    expect_mentions(reading_error(), {"Polygons", "mesh"});
    replace<double>("/VTKHDF/Polygons/NumberOfCells", H5T_NATIVE_DOUBLE, {1}, {0.0});
    edit([&](hid_t opened) { H5Adelete_by_name(opened, "/VTKHDF/Steps", "NSteps", H5P_DEFAULT); });
    steps = 0;
    add_attribute("VTKHDF/Steps", "NSteps", H5T_NATIVE_INT64, &steps);
    expect_mentions(reading_error(), {"NSteps", "positive"});
}

TEST_F(OtherHdf5, AnyStepOfAVtkhdfSeriesIsRead) {
    add_group("VTKHDF");
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 16);
    add_attribute("VTKHDF", "Type", type, "UnstructuredGrid");
    H5Tclose(type);
    const std::int64_t version[] = {2, 2};
    add_attribute("VTKHDF", "Version", H5T_NATIVE_INT64, version, 2);
    // Step 0 has two particles in two partitions, step 1 one; w is the same array for both.
    add("VTKHDF/NumberOfPoints", {3}, {1, 1, 1});
    add("VTKHDF/Points", {3, 3}, coordinates);
    add("VTKHDF/Types", {3}, {1, 1, 1});
    add_group("VTKHDF/PointData");
    add("VTKHDF/PointData/v", {3}, {7, 8, 9});
    add("VTKHDF/PointData/w", {2}, {5, 6});
    add_group("VTKHDF/Steps");
    const std::int64_t steps = 2;
    add_attribute("VTKHDF/Steps", "NSteps", H5T_NATIVE_INT64, &steps);
    add("VTKHDF/Steps/Values", {2}, {0.25, 0.5});
    add("VTKHDF/Steps/NumberOfParts", {2}, {2, 1});
    add("VTKHDF/Steps/PartOffsets", {2}, {0, 2});
    add("VTKHDF/Steps/PointOffsets", {2}, {0, 2});
    add_group("VTKHDF/Steps/PointDataOffsets");
    add("VTKHDF/Steps/PointDataOffsets/w", {2}, {0, 0});
    const auto read = [&](std::uint64_t frame) {
        ReadChoices choices;
        choices.frame = frame;
        return read_snapshot(file, choices);
    };
    const Snapshot last = read_snapshot(file);
    EXPECT_EQ(last.positions, (Positions{{4, 5, 6}}));
    EXPECT_EQ(last.time, 0.5);
    EXPECT_EQ(scalar_values(last, "v"), (std::vector<double>{9}));
    EXPECT_EQ(scalar_values(last, "w"), (std::vector<double>{5}));
    expect_mentions(last.notes.at(0), {"last of 2 states"});
    const Snapshot first = read(0);
    EXPECT_EQ(first.positions, (Positions{{0, 0, 1}, {2, 0, 3}}));
    EXPECT_EQ(first.time, 0.25);
    EXPECT_EQ(scalar_values(first, "v"), (std::vector<double>{7, 8}));
    EXPECT_EQ(scalar_values(first, "w"), (std::vector<double>{5, 6}));
    EXPECT_EQ(first.provenance.at("frame"), "0");
    expect_mentions(error_of<InputError>([&] { read(2); }), {"--frame 2", "0 to 1"});

    replace<double>("/VTKHDF/Steps/PointOffsets", H5T_NATIVE_DOUBLE, {2}, {0, 3});
    expect_mentions(reading_error(), {"/VTKHDF/Points", "4 rows"});
    replace<double>("/VTKHDF/Steps/PartOffsets", H5T_NATIVE_DOUBLE, {2}, {0, 3});
    expect_mentions(reading_error(), {"NumberOfPoints", "more than 3"});
    remove("/VTKHDF/Steps/PartOffsets");
    expect_mentions(reading_error(), {"PartOffsets"});
    replace<double>("/VTKHDF/Types", H5T_NATIVE_DOUBLE, {3}, {1, 1, 10});
    replace<double>("/VTKHDF/Steps/PartOffsets", H5T_NATIVE_DOUBLE, {2}, {0, 2});
    replace<double>("/VTKHDF/Steps/PointOffsets", H5T_NATIVE_DOUBLE, {2}, {0, 2});
    expect_mentions(reading_error(), {"cell type 10", "mesh"});
}

} // namespace
} // namespace meniscus
