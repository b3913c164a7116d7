#include "test_folder.hpp"
#include "vtk_bytes.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/snapshot_formats.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

using LegacyVtk = TestFolder;

std::string preamble() {
    return "# vtk DataFile Version 4.1\nSPlisHSPlasH particle data\nBINARY\n"
           "DATASET UNSTRUCTURED_GRID\n";
}

std::string points() {
    return "POINTS 2 float\n" + big_endian<float>({0.5F, 1, 2, 3, 4, 5}) + "\n";
}

std::string cells() {
    return "CELLS 2 4\n" + big_endian<std::int32_t>({1, 0, 1, 1}) + "\nCELL_TYPES 2\n" +
           big_endian<std::int32_t>({1, 1}) + "\n";
}

std::string ids() {
    return "POINT_DATA 2\nSCALARS id unsigned_int 1\nLOOKUP_TABLE id_table\n" +
           big_endian<std::uint32_t>({7, 4'000'000'000}) + "\n";
}

std::string fields() {
    return "FIELD FieldData 2\ndensity 1 2 float\n" + big_endian<float>({1000, 999}) +
           "\nvelocity 3 2 double\n" + big_endian<double>({1, 2, 3, 4, 5, 6}) + "\n";
}

/// What SPlisHSPlasH writes, with two particles.
std::string whole_file() {
    return preamble() + points() + cells() + ids() + fields();
}

TEST_F(LegacyVtk, ReadsWhatSplishsplashWrites) {
    const Snapshot snapshot = read_snapshot(write("state.vtk", whole_file()));
    EXPECT_EQ(snapshot.positions, (Positions{{0.5, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(snapshot.position_precision, Precision::float32);
    EXPECT_EQ(snapshot.dimension, 3);
    EXPECT_FALSE(snapshot.support_radius);
    ASSERT_EQ(snapshot.point_data.size(), 3U);
    EXPECT_EQ(find_array(snapshot, "id")->values,
              ArrayValues(std::vector<std::uint32_t>{7, 4'000'000'000}));
    EXPECT_EQ(find_array(snapshot, "density")->values, ArrayValues(std::vector<float>{1000, 999}));
    EXPECT_EQ(find_array(snapshot, "velocity")->values,
              ArrayValues(std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
}

TEST_F(LegacyVtk, ReadsEveryNumberType) {
    const std::string data =
        "POINT_DATA 2\nFIELD all 14\n"
        "a 1 2 bit\n\x40\nb 1 2 char\n" +
        big_endian<std::int8_t>({-1, 2}) + "\nc 1 2 unsigned_char\n" +
        big_endian<std::uint8_t>({1, 2}) + "\nd 1 2 short\n" + big_endian<std::int16_t>({-1, 2}) +
        "\ne 1 2 unsigned_short\n" + big_endian<std::uint16_t>({1, 2}) + "\nf 1 2 int\n" +
        big_endian<std::int32_t>({-1, 2}) + "\ng 1 2 unsigned_int\n" +
        big_endian<std::uint32_t>({1, 2}) + "\nh 1 2 long\n" + big_endian<std::int64_t>({-1, 2}) +
        "\ni 1 2 unsigned_long\n" + big_endian<std::uint64_t>({1, 2}) + "\nj 1 2 vtktypeint64\n" +
        big_endian<std::int64_t>({-1, 2}) + "\nk 1 2 vtktypeuint64\n" +
        big_endian<std::uint64_t>({1, 2}) + "\nl 1 2 vtkIdType\n" +
        big_endian<std::int32_t>({-1, 2}) + "\nm 1 2 float\n" + big_endian<float>({-1, 2}) +
        "\nn 1 2 double\n" + big_endian<double>({-1, 2}) + "\n";
    const Snapshot snapshot =
        legacy_vtk_format().read(write("state.vtk", preamble() + points() + cells() + data));
    EXPECT_EQ(scalar_values(snapshot, "a"), (std::vector<double>{0, 1}));
    for (const char* name : {"b", "d", "f", "h", "j", "l", "m", "n"})
        EXPECT_EQ(scalar_values(snapshot, name), (std::vector<double>{-1, 2})) << name;
    for (const char* name : {"c", "e", "g", "i", "k"})
        EXPECT_EQ(scalar_values(snapshot, name), (std::vector<double>{1, 2})) << name;
    EXPECT_TRUE(
        std::holds_alternative<std::vector<std::uint64_t>>(find_array(snapshot, "k")->values));
}

TEST_F(LegacyVtk, ReadsWhatVtkItselfWrites) {
    // Version 5.1: cells as two arrays, metadata after arrays, names with coded characters.
    const std::string file =
        "# vtk DataFile Version 5.1\n\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
        "FIELD FieldData 1\nTIME 1 1 double\n" +
        big_endian<double>({0.25}) + "\nPOINTS 2 double\n" +
        big_endian<double>({1, 2, 0, 3, 4, 0}) +
        "\nMETADATA\nINFORMATION 0\n\nCELLS 3 2\nOFFSETS vtktypeint64\n" +
        big_endian<std::int64_t>({0, 1, 2}) + "\nCONNECTIVITY vtktypeint64\n" +
        big_endian<std::int64_t>({0, 1}) + "\nCELL_TYPES 2\n" + big_endian<std::int32_t>({1, 1}) +
        "\nCELL_DATA 2\nSCALARS part int\nLOOKUP_TABLE colors\n" +
        big_endian<std::int32_t>({0, 0}) + "\nLOOKUP_TABLE colors 1\n\x01\x02\x03\x04\n" +
        "POINT_DATA 2\nVECTORS flow%20speed float\n" + big_endian<float>({1, 2, 3, 4, 5, 6}) +
        "\nMETADATA\nCOMPONENT_NAMES\nx\ny\nz\n\nNORMALS n float\n" +
        big_endian<float>({0, 0, 1, 0, 0, 1}) + "\n";
    const Snapshot snapshot = legacy_vtk_format().read(write("state.vtk", file));
    EXPECT_EQ(snapshot.positions, (Positions{{1, 2, 0}, {3, 4, 0}}));
    EXPECT_EQ(snapshot.position_precision, Precision::float64);
    EXPECT_EQ(snapshot.dimension, 2);
    ASSERT_EQ(snapshot.point_data.size(), 2U);
    EXPECT_EQ(snapshot.point_data[0].name, "flow speed");
    EXPECT_EQ(snapshot.point_data[1].values, ArrayValues(std::vector<float>{0, 0, 1, 0, 0, 1}));
}

TEST_F(LegacyVtk, ToleratesWhitespaceAndLetterCase) {
    const std::string file = "# vtk DataFile Version 3.0\r\ntitle\r\nbinary\r\n\r\n"
                             "dataset  unstructured_grid\r\n\r\nPoints 2  FLOAT \r\n" +
                             big_endian<float>({0.5F, 1, 2, 3, 4, 5}) + cells() + "\n \n" + ids();
    const Snapshot snapshot = legacy_vtk_format().read(write("state.vtk", file));
    EXPECT_EQ(snapshot.positions, (Positions{{0.5, 1, 2}, {3, 4, 5}}));
    EXPECT_NE(find_array(snapshot, "id"), nullptr);
}

TEST_F(LegacyVtk, ReadsParticlesWithoutDataAndNoParticles) {
    EXPECT_EQ(legacy_vtk_format().read(write("bare.vtk", preamble() + points() + cells())).size(),
              2U);
    const std::string none = "POINTS 0 float\n\nCELLS 0 0\n\nCELL_TYPES 0\n\nPOINT_DATA 0\n";
    EXPECT_EQ(legacy_vtk_format().read(write("none.vtk", preamble() + none)).size(), 0U);
    EXPECT_EQ(legacy_vtk_format().read(write("none.vtk", preamble() + "POINTS 0 float\n")).size(),
              0U);
}

TEST_F(LegacyVtk, RefusesWhatIsNotSupportedByName) {
    const auto message = [this](const std::string& bytes) {
        return error_of<InputError>([&] { read_snapshot(write("state.vtk", bytes)); });
    };
    const std::string first = "# vtk DataFile Version 4.1\ntitle\n";
    expect_mentions(message(first + "XML\nDATASET POLYDATA\n"), {"ASCII or BINARY", "'XML'"});
    expect_mentions(message(first + "BINARY\nDATASET STRUCTURED_GRID\n"),
                    {"UNSTRUCTURED_GRID or POLYDATA", "STRUCTURED_GRID"});
    for (const char* version : {"6.0", "0.9", "x", "", "4.1 beta"}) {
        expect_mentions(message("# vtk DataFile Version " + std::string(version) + "\ntitle\n"),
                        {"section header", "1.0 to 5.1", version});
    }
    std::string mesh = preamble() + points() + cells();
    mesh[mesh.size() - 2] = 10;
    expect_mentions(message(mesh), {"CELL_TYPES", "type 10", "mesh"});
}

TEST_F(LegacyVtk, TruncationIsNoticedWithinEverySection) {
    const std::string whole = whole_file();
    // Where a section ends and nothing says that another one should follow, the file is well
    // formed: after the cells and after the first array of point data.
    const std::size_t cells_end = (preamble() + points() + cells()).size();
    const std::size_t ids_end = cells_end + ids().size();
    for (std::size_t length = 1; length + 1 < whole.size(); ++length) {
        if (length == cells_end || length + 1 == cells_end || length == ids_end ||
            length + 1 == ids_end)
            continue;
        const fs::path file = write("state.vtk", std::string_view(whole).substr(0, length));
        const std::string message = error_of<InputError>([&] { read_snapshot(file); });
        expect_mentions(message, {"state.vtk"});
        if (length > (preamble() + points()).size())
            expect_mentions(message, {"section", "2 particles"});
    }
}

TEST_F(LegacyVtk, TruncationNamesTheSection) {
    const std::string whole = whole_file();
    const auto message_without = [&](const std::string& rest) {
        const std::size_t end = whole.find(rest);
        const fs::path file = write("state.vtk", std::string_view(whole).substr(0, end));
        return error_of<InputError>([&] { legacy_vtk_format().read(file); });
    };
    expect_mentions(message_without("POINTS"), {"section POINTS"});
    expect_mentions(message_without("\nCELLS"), {"section CELLS", "2 particles"});
    expect_mentions(message_without("CELL_TYPES"), {"section CELL_TYPES", "2 particles"});
    expect_mentions(message_without("SCALARS"), {"section POINT_DATA", "2 particles"});
    expect_mentions(message_without("LOOKUP_TABLE"), {"section SCALARS 'id'", "2 particles"});
    expect_mentions(message_without("density"), {"section FIELD, array 1 of 2", "2 particles"});
    expect_mentions(message_without("velocity"), {"section FIELD, array 2 of 2", "2 particles"});
}

TEST_F(LegacyVtk, LyingHeadersTakeNoMemory) {
    const auto message = [this](const std::string& bytes) {
        return error_of<InputError>([&] { legacy_vtk_format().read(write("state.vtk", bytes)); });
    };
    for (const char* count : {"1000000000000000000", "18446744073709551615", "6148914691236517206",
                              "99999999999999999999", "-2", "2x", "two"}) {
        const std::string claim(count);
        expect_mentions(message(preamble() + "POINTS " + claim + " float\n" + cells()),
                        {"section POINTS", count});
        expect_mentions(message(preamble() + points() + "CELLS 2 " + claim + "\n" + cells()),
                        {"section CELLS", count});
        expect_mentions(message(preamble() + points() + "CELLS 2 4\n0123456789abcdef\nCELL_TYPES " +
                                claim + "\n" + cells()),
                        {"section CELL_TYPES", count});
        expect_mentions(message(preamble() + points() + cells() + "POINT_DATA " + claim + "\n"),
                        {"POINT_DATA", count});
        expect_mentions(message(preamble() + points() + cells() + "POINT_DATA 2\nSCALARS id int " +
                                claim + "\nLOOKUP_TABLE t\n1234"),
                        {"section SCALARS 'id'"});
        expect_mentions(
            message(preamble() + points() + cells() + "POINT_DATA 2\nFIELD f " + claim + "\n"),
            {"section FIELD"});
    }
}

TEST_F(LegacyVtk, WrongArraysAreNamed) {
    const auto message = [this](const std::string& data) {
        const std::string bytes = preamble() + points() + cells() + data;
        return error_of<InputError>([&] { legacy_vtk_format().read(write("state.vtk", bytes)); });
    };
    expect_mentions(message(ids() + "FIELD f 1\nid 1 2 float\n12345678\n"),
                    {"'id'", "second time"});
    expect_mentions(message("POINT_DATA 2\nFIELD f 1\nmass 1 3 float\n123456789012\n"),
                    {"'mass'", "2 tuples", "found 3"});
    expect_mentions(message("POINT_DATA 2\nFIELD f 1\nmass 0 2 float\n"), {"'mass'", "components"});
    expect_mentions(message("POINT_DATA 2\nFIELD f 1\nmass 1 2 string\n"), {"'mass'", "2 texts"});
    expect_mentions(message("POINT_DATA 2\nHYPERTREES c 3\n123456\n"), {"'HYPERTREES c 3'"});
    expect_mentions(message("POINT_DATA 3\n"), {"POINT_DATA", "2 tuples", "found 3"});
    expect_mentions(message("SCALARS id int\n"), {"POINT_DATA", "'SCALARS id int'"});
}

class SharedSnapshots : public ::testing::Test {
protected:
    void SetUp() override {
        if (!fs::exists(folder))
            GTEST_SKIP() << "no snapshots of real solvers at " << folder;
    }

    static std::ptrdiff_t invalid(const Snapshot& snapshot) {
        const std::vector<std::uint8_t> finite = finite_positions(snapshot);
        return std::count(finite.begin(), finite.end(), 0);
    }

    const fs::path folder = fs::path(MENISCUS_SHARED_SNAPSHOTS) / "splishsplash";
};

TEST_F(SharedSnapshots, HaveTheirParticlesAndArrays) {
    const Snapshot snapshot = read_snapshot(folder / "dam_dfsph_04.vtk");
    EXPECT_EQ(snapshot.size(), 26136U);
    EXPECT_EQ(snapshot.dimension, 3);
    EXPECT_EQ(snapshot.position_precision, Precision::float32);
    EXPECT_EQ(invalid(snapshot), 0);
    std::vector<double> ids = scalar_values(snapshot, "id");
    std::sort(ids.begin(), ids.end());
    for (std::size_t i = 0; i < ids.size(); ++i)
        ASSERT_EQ(ids[i], static_cast<double>(i));
    for (const double density : scalar_values(snapshot, "density"))
        ASSERT_TRUE(density > 100 && density < 2000) << density;
    EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
    for (const double surface : scalar_values(snapshot, "Surf.Class_(SurfZR20)"))
        ASSERT_TRUE(surface == 0 || surface == 0.5 || surface == 1);
    EXPECT_NE(find_array(snapshot, "Curv.Final_(SurfZR20)"), nullptr);
}

TEST_F(SharedSnapshots, KeepNonFinitePositions) {
    const Snapshot snapshot = read_snapshot(folder / "dam_wcsph_04_with_nan.vtk");
    EXPECT_EQ(snapshot.size(), 26136U);
    EXPECT_EQ(invalid(snapshot), 12);
    EXPECT_EQ(snapshot.dimension, 3);
}

TEST_F(SharedSnapshots, BoundariesHavePositionsOnly) {
    const Snapshot snapshot = read_snapshot(folder / "dam_boundary.vtk");
    EXPECT_EQ(snapshot.size(), 24557U);
    EXPECT_TRUE(snapshot.point_data.empty());
}

TEST_F(SharedSnapshots, AllLegacyFilesAreRead) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".vtk") {
            EXPECT_GT(read_snapshot(entry.path()).size(), 0U) << entry.path();
            ++count;
        }
    }
    EXPECT_EQ(count, 17);
}

} // namespace
} // namespace meniscus
