#include "hdf5_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>

#include <hdf5.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Number>
void add_extremes(Snapshot& snapshot, const std::string& name) {
    using Limits = std::numeric_limits<Number>;
    std::vector<Number> values(snapshot.size(), Limits::lowest());
    for (std::size_t i = 0; i < values.size(); i += 2)
        values[i] = Limits::max();
    set_array(snapshot, {name, 1, std::move(values)});
}

Snapshot sample(std::size_t particles, int dimension = 3) {
    Snapshot snapshot;
    snapshot.dimension = dimension;
    for (std::size_t i = 0; i < particles; ++i) {
        const double x = 0.1 * static_cast<double>(i);
        snapshot.positions.push_back({x, -x / 3, dimension == 2 ? 0 : x * x});
    }
    add_extremes<std::int8_t>(snapshot, "int8");
    add_extremes<std::uint8_t>(snapshot, "uint8");
    add_extremes<std::int16_t>(snapshot, "int16");
    add_extremes<std::uint16_t>(snapshot, "uint16");
    add_extremes<std::int32_t>(snapshot, "int32");
    add_extremes<std::uint32_t>(snapshot, "uint32");
    add_extremes<std::int64_t>(snapshot, "int64");
    add_extremes<std::uint64_t>(snapshot, "uint64");
    add_extremes<float>(snapshot, "float");
    add_extremes<double>(snapshot, "Surf.Class_(SurfZR20)");
    set_array(snapshot, {"velocity", 3, std::vector<float>(3 * particles, 0.1F)});
    set_array(snapshot, {"support_radius", 1, std::vector<double>(particles, 0.07)});
    snapshot.support_radius = 0.08;
    snapshot.particle_spacing = 0.04;
    snapshot.time = 0.3;
    snapshot.scene = "Wassertropfen über Öl";
    snapshot.provenance = {{"method", "monte-carlo"}, {"samples", "50000"}};
    return snapshot;
}

void expect_same(const Snapshot& found, const Snapshot& wanted) {
    EXPECT_EQ(found.dimension, wanted.dimension);
    EXPECT_EQ(found.positions, wanted.positions);
    EXPECT_EQ(found.position_precision, wanted.position_precision);
    EXPECT_EQ(found.boundary, wanted.boundary);
    EXPECT_EQ(found.support_radius, wanted.support_radius);
    EXPECT_EQ(found.particle_spacing, wanted.particle_spacing);
    EXPECT_EQ(found.time, wanted.time);
    EXPECT_EQ(found.scene, wanted.scene);
    EXPECT_EQ(found.provenance, wanted.provenance);
    ASSERT_EQ(found.point_data.size(), wanted.point_data.size());
    for (const PointArray& array : wanted.point_data) {
        const PointArray* same = find_array(found, array.name);
        ASSERT_NE(same, nullptr) << array.name;
        EXPECT_EQ(same->components, array.components) << array.name;
        EXPECT_EQ(same->values, array.values) << array.name;
    }
}

class Vtkhdf : public Hdf5Folder {
protected:
    Vtkhdf() : Hdf5Folder("state.vtkhdf") {}

    Snapshot written_and_read(const Snapshot& snapshot) const {
        write_vtkhdf(snapshot, file);
        return read_snapshot(file);
    }

    void replace_counts(const char* path, const std::vector<std::int64_t>& counts) const {
        replace(path, H5T_NATIVE_INT64, {counts.size()}, counts);
    }
};

TEST_F(Vtkhdf, KeepsEverythingInThreeDimensions) {
    expect_same(written_and_read(sample(7)), sample(7));
}

TEST_F(Vtkhdf, KeepsEverythingInTwoDimensions) {
    expect_same(written_and_read(sample(7, 2)), sample(7, 2));
}

TEST_F(Vtkhdf, KeepsTheSmallestSnapshots) {
    for (const std::size_t particles : {0, 1, 2}) {
        for (const int dimension : {2, 3}) {
            expect_same(written_and_read(sample(particles, dimension)),
                        sample(particles, dimension));
        }
    }
    Snapshot bare;
    expect_same(written_and_read(bare), bare);
}

TEST_F(Vtkhdf, KeepsSeveralChunks) {
    expect_same(written_and_read(sample(300'001)), sample(300'001));
}

TEST_F(Vtkhdf, KeepsSinglePrecision) {
    Snapshot snapshot = sample(100);
    snapshot.position_precision = Precision::float32;
    for (auto& position : snapshot.positions)
        for (double& x : position)
            x = static_cast<float>(x);
    expect_same(written_and_read(snapshot), snapshot);
}

TEST_F(Vtkhdf, HeaderIsAllButTheParticles) {
    const Snapshot snapshot = sample(40);
    write_vtkhdf(snapshot, folder / "whole.vtkhdf");
    const Snapshot header = read_vtkhdf_header(folder / "whole.vtkhdf");
    EXPECT_EQ(header.size(), 0U);
    EXPECT_EQ(header.dimension, snapshot.dimension);
    EXPECT_EQ(header.time, snapshot.time);
    EXPECT_EQ(header.support_radius, snapshot.support_radius);
    EXPECT_EQ(header.scene, snapshot.scene);
    EXPECT_EQ(header.provenance, snapshot.provenance);
    EXPECT_EQ(header.point_data.size(), snapshot.point_data.size());
    EXPECT_NE(find_array(header, "velocity"), nullptr);
    const std::string bytes = bytes_of(folder / "whole.vtkhdf");
    write("cut.vtkhdf", bytes.substr(0, bytes.size() / 2));
    EXPECT_THROW(read_vtkhdf_header(folder / "cut.vtkhdf"), InputError);
}

TEST_F(Vtkhdf, KeepsTheBoundary) {
    for (const std::size_t particles : {1, 100'000}) { // stored as they are, and in several chunks
        Snapshot snapshot = sample(3);
        snapshot.boundary = sample(particles).positions;
        expect_same(written_and_read(snapshot), snapshot);
    }
}

TEST_F(Vtkhdf, ABoundaryOfTheWrongShapeOrTypeIsNamed) {
    write_vtkhdf(sample(3), file);
    const char* path = "/meniscus/boundary";
    replace<double>(path, H5T_NATIVE_DOUBLE, {3}, {1, 2, 3});
    expect_mentions(reading_error(), {path, "particles x 3", "found 3"});
    replace<double>(path, H5T_NATIVE_DOUBLE, {3, 2}, {1, 2, 3, 4, 5, 6});
    expect_mentions(reading_error(), {path, "particles x 3", "found 3 x 2"});
    replace<float>(path, H5T_NATIVE_FLOAT, {1, 3}, {1, 2, 3});
    expect_mentions(reading_error(), {path, "expected double"});
    replace<char>(path, H5T_C_S1, {1, 3}, {'a', 'b', 'c'});
    expect_mentions(reading_error(), {path, "another type"});
    remove(path);
    edit([&](hid_t opened) {
        const hsize_t dimensions[] = {hsize_t{1} << 59, 3};
        const hid_t space = H5Screate_simple(2, dimensions, nullptr);
        const hid_t dataset = H5Dcreate2(opened, path, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                                         H5P_DEFAULT, H5P_DEFAULT);
        ASSERT_GE(dataset, 0);
        H5Dclose(dataset);
        H5Sclose(space);
    });
    expect_mentions(reading_error(), {path, "bytes"});
}

TEST_F(Vtkhdf, KeepsNonFinitePositions) {
    Snapshot snapshot = sample(3);
    snapshot.positions[1] = {nan, std::numeric_limits<double>::infinity(), -0.0};
    for (const Precision precision : {Precision::float32, Precision::float64}) {
        snapshot.position_precision = precision;
        const Snapshot read = written_and_read(snapshot);
        EXPECT_TRUE(std::isnan(read.positions[1][0]));
        EXPECT_EQ(read.positions[1][1], std::numeric_limits<double>::infinity());
        EXPECT_TRUE(std::signbit(read.positions[1][2]));
    }
}

TEST_F(Vtkhdf, KeepsLongAndEmptyTexts) {
    Snapshot snapshot = sample(2);
    snapshot.provenance["scene file"] = std::string(200'000, 'x');
    snapshot.provenance["empty"] = "";
    expect_same(written_and_read(snapshot), snapshot);
}

TEST_F(Vtkhdf, NamesThatHdf5WouldTakeForPathsAreMended) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}};
    for (const char* name : {"a/b", "a_b", "/", ".", "", "..", "a.b (c)"})
        set_array(snapshot, {name, 1, std::vector<float>{1}});
    const Snapshot read = written_and_read(snapshot);
    EXPECT_EQ(read.point_data.size(), snapshot.point_data.size());
    for (const char* name : {"a_b", "a_b_", "_", "__", "___", "..", "a.b (c)"})
        EXPECT_NE(find_array(read, name), nullptr) << name;
}

TEST_F(Vtkhdf, TheSameSnapshotGivesTheSameBytes) {
    write_vtkhdf(sample(5000), file);
    const std::string first = bytes_of(file);
    // Long enough for a time in whole seconds to differ.
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    write_vtkhdf(sample(5000), folder / "other.vtkhdf");
    EXPECT_TRUE(bytes_of(folder / "other.vtkhdf") == first);
    write_vtkhdf(read_snapshot(file), folder / "again.vtkhdf");
    EXPECT_TRUE(bytes_of(folder / "again.vtkhdf") == first);
}

TEST_F(Vtkhdf, CompressesWhatRepeats) {
    Snapshot snapshot;
    snapshot.positions.assign(100'000, {1, 2, 3});
    write_vtkhdf(snapshot, file);
    EXPECT_LT(fs::file_size(file), 500'000U);
}

TEST_F(Vtkhdf, RefusesToWriteWhatCouldNotBeRead) {
    Snapshot snapshot = sample(3);
    snapshot.point_data[0].components = 2;
    EXPECT_THROW(write_vtkhdf(snapshot, file), std::invalid_argument);
    snapshot = sample(3);
    snapshot.support_radius = nan;
    EXPECT_THROW(write_vtkhdf(snapshot, file), std::invalid_argument);
    snapshot = sample(3);
    snapshot.dimension = 1;
    EXPECT_THROW(write_vtkhdf(snapshot, file), std::invalid_argument);
    EXPECT_FALSE(fs::exists(file));
}

TEST_F(Vtkhdf, NamesTheFolderThatIsMissing) {
    const fs::path missing = folder / "none";
    expect_mentions(
        error_of<InputError>([&] { write_vtkhdf(sample(3), missing / "state.vtkhdf"); }),
        {missing.c_str()});
}

TEST_F(Vtkhdf, TruncatedFilesAreRefused) {
    write_vtkhdf(sample(50), file);
    const std::string whole = bytes_of(file);
    for (std::size_t length = 0; length < whole.size(); length += 127) {
        write("state.vtkhdf", std::string_view(whole).substr(0, length));
        expect_mentions(reading_error(), {"state.vtkhdf", "expected", "found"});
    }
}

TEST_F(Vtkhdf, DamagedFilesAreReadOrRefused) {
    for (const std::size_t particles : {50, 2000}) { // stored as they are, and compressed
        write_vtkhdf(sample(particles), file);
        const std::string whole = bytes_of(file);
        for (std::size_t i = 0; i < whole.size(); i += 181) {
            std::string damaged = whole;
            damaged[i] = static_cast<char>(~damaged[i]);
            write("state.vtkhdf", damaged);
            try {
                read_snapshot(file);
            } catch (const InputError& error) {
                expect_mentions(error.what(), {"state.vtkhdf", "expected", "found"});
            }
        }
    }
}

TEST_F(Vtkhdf, OtherHdf5FilesAreNotOurs) {
    H5Fclose(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    EXPECT_FALSE(is_vtkhdf(file));
    expect_mentions(reading_error(), {"state.vtkhdf", "known format"});
    EXPECT_THROW(read_vtkhdf(file), InputError);
    EXPECT_FALSE(is_vtkhdf(write("text", "no HDF5 at all")));
}

TEST_F(Vtkhdf, ReadsWhatOthersLeaveOut) {
    write_vtkhdf(sample(4, 2), file);
    for (const char* path : {"/meniscus", "/VTKHDF/FieldData", "/VTKHDF/PointData",
                             "/VTKHDF/CellData", "/VTKHDF/Types"})
        remove(path);
    const Snapshot read = read_snapshot(file);
    EXPECT_EQ(read.positions, sample(4, 2).positions);
    EXPECT_EQ(read.dimension, 2);
    EXPECT_FALSE(read.support_radius);
    EXPECT_TRUE(read.point_data.empty());
    EXPECT_TRUE(read.scene.empty());
}

TEST_F(Vtkhdf, ReadsSeveralPartitionsAsOne) {
    write_vtkhdf(sample(5), file);
    replace_counts("/VTKHDF/NumberOfPoints", {2, 0, 3});
    replace_counts("/VTKHDF/NumberOfCells", {2, 0, 3});
    expect_same(read_snapshot(file), sample(5));
}

TEST_F(Vtkhdf, ReadsBigEndianNumbers) {
    write_vtkhdf(sample(2), file);
    // 1 and 258 as they lie in the file.
    replace<std::uint16_t>("/VTKHDF/PointData/phase", H5T_STD_U16BE, {2}, {0x0100, 0x0201});
    EXPECT_EQ(scalar_values(read_snapshot(file), "phase"), (std::vector<double>{1, 258}));
}

TEST_F(Vtkhdf, WrongArraysAreNamed) {
    write_vtkhdf(sample(3), file);
    replace<double>("/VTKHDF/PointData/density", H5T_NATIVE_DOUBLE, {2}, {1, 2});
    expect_mentions(reading_error(), {"/VTKHDF/PointData/density", "3", "found 2"});
    replace<double>("/VTKHDF/PointData/density", H5T_NATIVE_DOUBLE, {3, 1, 1}, {1, 2, 3});
    expect_mentions(reading_error(), {"/VTKHDF/PointData/density", "found 3 x 1 x 1"});
    replace<char>("/VTKHDF/PointData/density", H5T_C_S1, {3}, {'a', 'b', 'c'});
    expect_mentions(reading_error(), {"/VTKHDF/PointData/density", "another type"});
    remove("/VTKHDF/PointData/density");
    replace<double>("/VTKHDF/Points", H5T_NATIVE_DOUBLE, {3, 2}, {1, 2, 3, 4, 5, 6});
    expect_mentions(reading_error(), {"/VTKHDF/Points", "3 x 3", "found 3 x 2"});
    remove("/VTKHDF/Points");
    expect_mentions(reading_error(), {"/VTKHDF/Points", "found none"});
}

TEST_F(Vtkhdf, WrongFieldsAreNamed) {
    write_vtkhdf(sample(3), file);
    const char* path = "/VTKHDF/FieldData/support_radius";
    for (const double value : {0.0, -0.1, nan, std::numeric_limits<double>::infinity()}) {
        replace<double>(path, H5T_NATIVE_DOUBLE, {1}, {value});
        expect_mentions(reading_error(), {path});
    }
    replace<double>(path, H5T_NATIVE_DOUBLE, {2}, {0.1, 0.1});
    expect_mentions(reading_error(), {path, "2 values"});
    remove(path);
    replace<int>("/VTKHDF/FieldData/dimension", H5T_NATIVE_INT, {1}, {4});
    expect_mentions(reading_error(), {"/VTKHDF/FieldData/dimension", "2 or 3"});
}

TEST_F(Vtkhdf, MeshesAndSeriesAreNoSnapshots) {
    write_vtkhdf(sample(3), file);
    replace<int>("/VTKHDF/Steps", H5T_NATIVE_INT, {1}, {2});
    expect_mentions(reading_error(), {"/VTKHDF/Steps", "NSteps"});
    remove("/VTKHDF/Steps");
    replace<std::uint8_t>("/VTKHDF/Types", H5T_NATIVE_UINT8, {3}, {1, 1, 10});
    expect_mentions(reading_error(), {"/VTKHDF/Types", "cell type 10", "mesh"});
}

TEST_F(Vtkhdf, FilesOfANewerProgramAreRefused) {
    write_vtkhdf(sample(3), file);
    const hid_t type = H5Tcopy(H5T_C_S1);
    replace<char>("/meniscus/format_version", type, {}, {'2'});
    H5Tclose(type);
    expect_mentions(reading_error(), {"/meniscus/format_version", "'2'", "update"});
}

TEST_F(Vtkhdf, CountsThatNoFileHoldsAreRefused) {
    write_vtkhdf(sample(3), file);
    for (const std::int64_t count : {std::int64_t{-3}, std::int64_t{1} << 40, INT64_MAX}) {
        replace_counts("/VTKHDF/NumberOfPoints", {3, count, count});
        expect_mentions(reading_error(), {"/VTKHDF/NumberOfPoints"});
    }
}

TEST_F(Vtkhdf, DatasetsThatNoFileHoldsAreRefused) {
    write_vtkhdf(sample(3), file);
    const hsize_t trillion = 1'000'000'000'000;
    for (const bool chunked : {false, true}) {
        for (const hsize_t extent : {trillion, hsize_t{1} << 59}) {
            edit([&](hid_t opened) {
                H5Ldelete(opened, "/VTKHDF/Points", H5P_DEFAULT);
                const hsize_t dimensions[] = {extent, 3};
                const hsize_t chunk[] = {1'000'000, 3};
                const hid_t space = H5Screate_simple(2, dimensions, nullptr);
                const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
                if (chunked) {
                    H5Pset_chunk(creation, 2, chunk);
                    H5Pset_deflate(creation, 1);
                }
                const hid_t dataset = H5Dcreate2(opened, "/VTKHDF/Points", H5T_NATIVE_FLOAT, space,
                                                 H5P_DEFAULT, creation, H5P_DEFAULT);
                ASSERT_GE(dataset, 0);
                H5Dclose(dataset);
                H5Pclose(creation);
                H5Sclose(space);
            });
            expect_mentions(reading_error(), {"/VTKHDF/Points", "bytes"});
        }
    }
}

} // namespace
} // namespace meniscus
