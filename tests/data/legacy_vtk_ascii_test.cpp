// ASCII files, POLYDATA, and what the two encodings and kinds have in common; legacy_vtk_test.cpp
// is about binary UNSTRUCTURED_GRID.
#include "test_folder.hpp"
#include "vtk_bytes.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/snapshot_formats.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <cmath>
#include <limits>
#include <set>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

class LegacyVtkAscii : public TestFolder {
protected:
    Snapshot read(std::string_view bytes) const { return read_snapshot(write("state.vtk", bytes)); }

    std::string message(std::string_view bytes) const {
        const fs::path file = write("state.vtk", bytes);
        return error_of<InputError>([&] { read_snapshot(file); });
    }
};

/// Two particles, as a program might write them by hand.
std::string preamble(const std::string& dataset = "UNSTRUCTURED_GRID") {
    return "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET " + dataset + "\n";
}

std::string points() {
    return "POINTS 2 float\n0.5 1 2\n3 4 5\n";
}

std::string cells() {
    return "CELLS 2 4\n1 0\n1 1\nCELL_TYPES 2\n1\n1\n";
}

std::string data() {
    return "POINT_DATA 2\nSCALARS id unsigned_int\nLOOKUP_TABLE default\n7\n4000000000\n"
           "VECTORS velocity double\n1 2 3 4 5 6\nFIELD FieldData 1\ndensity 1 2 float\n1000 999\n";
}

std::string whole_file() {
    return preamble() + points() + cells() + data();
}

// One cloud in every encoding, kind and version. Its numbers are short in binary and decimal.
struct Cloud {
    std::vector<double> coordinates;
    std::vector<std::int64_t> ids;
    std::vector<double> velocities;
};

Cloud cloud() {
    Cloud cloud;
    for (int i = 0; i < 50; ++i) {
        cloud.ids.push_back(1000 - 7 * i);
        for (int axis = 0; axis < 3; ++axis) {
            cloud.coordinates.push_back((i * (axis + 3) % 17 - 8) / 64.0);
            cloud.velocities.push_back((i * (axis + 5) % 23 - 11) / 1024.0);
        }
    }
    return cloud;
}

template <class Number>
std::string numbers(const std::vector<Number>& values, bool binary) {
    if (binary)
        return big_endian(values) + "\n";
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += number_text(static_cast<double>(values[i]));
        text.erase(text.size() - (std::is_integral_v<Number> ? 2 : 0)); // its ".0"
        text += i % 9 == 8 ? "\n" : " ";
    }
    return text + "\n";
}

std::string cells_of(std::size_t count, const std::string& section, bool binary, int version) {
    std::vector<std::int32_t> classic;
    std::vector<std::int64_t> offsets{0};
    std::vector<std::int64_t> connectivity;
    for (std::size_t i = 0; i < count; ++i) {
        classic.insert(classic.end(), {1, static_cast<std::int32_t>(i)});
        offsets.push_back(static_cast<std::int64_t>(i) + 1);
        connectivity.push_back(static_cast<std::int64_t>(i));
    }
    if (version < 5) {
        return section + " " + std::to_string(count) + " " + std::to_string(2 * count) + "\n" +
               numbers(classic, binary);
    }
    return section + " " + std::to_string(count + 1) + " " + std::to_string(count) +
           "\nOFFSETS vtktypeint64\n" + numbers(offsets, binary) + "CONNECTIVITY vtktypeint64\n" +
           numbers(connectivity, binary);
}

std::string vtk_file(const Cloud& cloud, bool binary, bool polydata, int version) {
    const std::size_t count = cloud.ids.size();
    const std::string n = std::to_string(count);
    std::string file = "# vtk DataFile Version " + std::to_string(version) + ".1\ncloud\n" +
                       (binary ? "BINARY" : "ASCII") + "\nDATASET " +
                       (polydata ? "POLYDATA" : "UNSTRUCTURED_GRID") + "\nPOINTS " + n +
                       " double\n" + numbers(cloud.coordinates, binary);
    file += cells_of(count, polydata ? "VERTICES" : "CELLS", binary, version);
    if (!polydata)
        file += "CELL_TYPES " + n + "\n" + numbers(std::vector<std::int32_t>(count, 1), binary);
    return file + "POINT_DATA " + n + "\nVECTORS velocity double\n" +
           numbers(cloud.velocities, binary) + "SCALARS id long 1\nLOOKUP_TABLE default\n" +
           numbers(cloud.ids, binary);
}

std::string csv_file(const Cloud& cloud) {
    std::string file = "x,y,z,id,vx,vy,vz\n";
    for (std::size_t i = 0; i < cloud.ids.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            file += number_text(cloud.coordinates[3 * i + axis]) + ",";
        file += std::to_string(cloud.ids[i]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            file += "," + number_text(cloud.velocities[3 * i + axis]);
        file += "\n";
    }
    return file;
}

TEST_F(LegacyVtkAscii, OneCloudReadsTheSameFromEveryEncodingAndKind) {
    const Cloud cloud = meniscus::cloud();
    std::vector<std::string> files{csv_file(cloud)};
    for (const bool binary : {false, true}) {
        for (const bool polydata : {false, true})
            for (const int version : {2, 3, 4, 5})
                files.push_back(vtk_file(cloud, binary, polydata, version));
    }
    EXPECT_EQ(std::set<std::string>(files.begin(), files.end()).size(), 17U);
    for (const std::string& file : files) {
        const Snapshot snapshot = read(file);
        ASSERT_EQ(snapshot.size(), cloud.ids.size()) << file;
        for (std::size_t i = 0; i < snapshot.size(); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                ASSERT_EQ(snapshot.positions[i][axis], cloud.coordinates[3 * i + axis]) << file;
        ASSERT_EQ(snapshot.point_data.size(), 2U) << file;
        EXPECT_EQ(find_array(snapshot, "id")->values, ArrayValues(cloud.ids)) << file;
        EXPECT_EQ(find_array(snapshot, "velocity")->values, ArrayValues(cloud.velocities)) << file;
        EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
        EXPECT_EQ(snapshot.dimension, 3);
    }
}

TEST_F(LegacyVtkAscii, ReadsWhatIsWrittenByHand) {
    const Snapshot snapshot = read(whole_file());
    EXPECT_EQ(snapshot.positions, (Positions{{0.5, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(snapshot.position_precision, Precision::float32);
    EXPECT_EQ(find_array(snapshot, "id")->values,
              ArrayValues(std::vector<std::uint32_t>{7, 4'000'000'000}));
    EXPECT_EQ(find_array(snapshot, "velocity")->values,
              ArrayValues(std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(find_array(snapshot, "density")->values, ArrayValues(std::vector<float>{1000, 999}));

    std::string with_tabs_and_returns;
    for (const char c : whole_file())
        with_tabs_and_returns += c == '\n' ? "\r\n" : std::string(1, c == ' ' ? '\t' : c);
    // The first line is told by its bytes.
    with_tabs_and_returns.replace(0, preamble().find('3'), preamble(), 0, preamble().find('3'));
    EXPECT_EQ(read(with_tabs_and_returns).positions, snapshot.positions);
}

TEST_F(LegacyVtkAscii, ReadsEveryNumberType) {
    const std::string file = preamble("POLYDATA") + points() +
                             "POINT_DATA 2\nFIELD all 15\n"
                             "a 1 2 bit\n0 1\nb 1 2 char\n-128 127\nb2 1 2 signed_char\n-1 2\n"
                             "c 1 2 unsigned_char\n0 255\nd 1 2 short\n-32768 32767\n"
                             "e 1 2 unsigned_short\n1 65535\nf 1 2 int\n-2147483648 2147483647\n"
                             "g 1 2 unsigned_int\n+1 4294967295\n"
                             "h 1 2 long\n-9223372036854775808 9223372036854775807\n"
                             "i 1 2 unsigned_long\n1 18446744073709551615\n"
                             "j 1 2 vtktypeint64\n-1 2\nk 1 2 vtktypeuint64\n1 2\n"
                             "l 1 2 vtkIdType\n-1 2\nm 1 2 float\n-0.1 1e-60\n"
                             "n 1 2 double\n-0.1 1e-400\n";
    const Snapshot snapshot = read(file);
    const auto expect = [&](const char* name, const ArrayValues& values) {
        EXPECT_EQ(find_array(snapshot, name)->values, values) << name;
    };
    expect("a", std::vector<std::uint8_t>{0, 1});
    expect("b", std::vector<std::int8_t>{-128, 127});
    expect("b2", std::vector<std::int8_t>{-1, 2});
    expect("c", std::vector<std::uint8_t>{0, 255});
    expect("d", std::vector<std::int16_t>{-32768, 32767});
    expect("e", std::vector<std::uint16_t>{1, 65535});
    expect("f", std::vector<std::int32_t>{-2147483647 - 1, 2147483647});
    expect("g", std::vector<std::uint32_t>{1, 4294967295});
    expect("h", std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min(),
                                          std::numeric_limits<std::int64_t>::max()});
    expect("i", std::vector<std::uint64_t>{1, std::numeric_limits<std::uint64_t>::max()});
    expect("j", std::vector<std::int64_t>{-1, 2});
    expect("k", std::vector<std::uint64_t>{1, 2});
    expect("l", std::vector<std::int32_t>{-1, 2});
    expect("m", std::vector<float>{-0.1F, 0});
    expect("n", std::vector<double>{-0.1, 0});
}

TEST_F(LegacyVtkAscii, ReadsNonFiniteNumbers) {
    const Snapshot snapshot =
        read(preamble("POLYDATA") + "POINTS 2 double\nNaN -nan nan\nINF -Infinity +inf\n");
    for (const double coordinate : snapshot.positions[0])
        EXPECT_TRUE(std::isnan(coordinate));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(snapshot.positions[1], (std::array<double, 3>{infinity, -infinity, infinity}));
}

TEST_F(LegacyVtkAscii, NumbersThatAreNoneAreRefused) {
    const auto field = [this](const std::string& type, const std::string& values) {
        return message(preamble("POLYDATA") + points() + "POINT_DATA 2\nFIELD f 1\nmass 1 2 " +
                       type + "\n" + values + "\n");
    };
    expect_mentions(message(preamble() + "POINTS 2 float\n1 2 3\n4 x 6\n" + cells()),
                    {"section POINTS (2 particles)", "type float", "index 4 of 6", "'x'"});
    expect_mentions(message(preamble() + "POINTS 2 float\n1 2 3 4 5\n" + cells()),
                    {"section POINTS", "index 5 of 6", "'CELLS'"});
    expect_mentions(message(preamble() + "POINTS 2 float\n1 2 3 4 5 6 7\n" + cells()),
                    {"section after POINTS", "found '7'"});
    expect_mentions(field("float", "1 1e39"), {"'mass'", "float at index 1 of 2", "'1e39'"});
    expect_mentions(field("double", "-1e309 1"), {"'mass'", "double at index 0 of 2", "'-1e309'"});
    expect_mentions(field("double", "1 0,5"), {"index 1 of 2", "'0,5'"});
    expect_mentions(field("double", "1 +-2"), {"index 1 of 2", "'+-2'"});
    expect_mentions(field("double", "1 +"), {"index 1 of 2", "'+'"});
    expect_mentions(field("int", "1.5 1"), {"int at index 0 of 2", "'1.5'"});
    expect_mentions(field("int", "1 nan"), {"int at index 1 of 2", "'nan'"});
    expect_mentions(field("int", "2147483648 1"), {"int at index 0 of 2", "'2147483648'"});
    expect_mentions(field("unsigned_char", "256 1"), {"unsigned_char at index 0", "'256'"});
    expect_mentions(field("unsigned_int", "1 -1"), {"unsigned_int at index 1", "'-1'"});
    expect_mentions(field("bit", "1 2"), {"bit at index 1 of 2", "'2'"});
    expect_mentions(field("float", std::string("1 \x01\0", 4)), {"index 1 of 2", "'\\x01\\x00'"});
}

TEST_F(LegacyVtkAscii, ReadsPolydataWithOrWithoutVertices) {
    const std::string file = preamble("polydata") + points();
    EXPECT_EQ(read(file).size(), 2U);
    EXPECT_EQ(read(file + data()).point_data.size(), 3U);
    EXPECT_EQ(read(file + "VERTICES 1 3\n2 0 1\n" + data()).point_data.size(), 3U);
    EXPECT_EQ(read(file + "LINES 0 0\nVERTICES 2 4\n1 0 1 1\nPOLYGONS 0 0\n" + data()).size(), 2U);
    EXPECT_EQ(read(preamble("POLYDATA") + "POINTS 0 float\n").size(), 0U);
}

TEST_F(LegacyVtkAscii, MeshesAreRefused) {
    const std::string polydata = preamble("POLYDATA") + points();
    expect_mentions(message(polydata + "LINES 1 3\n2 0 1\n" + data()),
                    {"section LINES (2 particles)", "found 1", "mesh"});
    expect_mentions(message(polydata + "VERTICES 2 4\n1 0 1 1\nPOLYGONS 1 3\n2 0 1\n"),
                    {"section POLYGONS", "mesh"});
    expect_mentions(message(polydata + "TRIANGLE_STRIPS 1 3\n2 0 1\n"),
                    {"section TRIANGLE_STRIPS", "mesh"});
    std::string newer = polydata + "LINES 2 2\nOFFSETS int\n0 2\nCONNECTIVITY int\n0 1\n";
    newer.replace(newer.find("3.0"), 3, "5.1");
    expect_mentions(message(newer), {"section LINES", "found 1", "mesh"});
    expect_mentions(message(preamble() + points() + "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n"),
                    {"CELL_TYPES", "type 3", "mesh"});
    expect_mentions(message(polydata + "CELLS 2 4\n1 0 1 1\n"), {"after POINTS", "'CELLS 2 4'"});
}

TEST_F(LegacyVtkAscii, ColorsBecomeBytes) {
    const std::string ascii = preamble("POLYDATA") + points() +
                              "POINT_DATA 2\nCOLOR_SCALARS surface 1\n0 1\n"
                              "TEXTURE_COORDINATES place 2 float\n1 2 3 4\n"
                              "SCALARS d double 1\nLOOKUP_TABLE t\n0.5 1.5\n"
                              "LOOKUP_TABLE t 2\n0 0 0 1\n1 1 1 1\n";
    std::string binary =
        "# vtk DataFile Version 4.2\nt\nBINARY\nDATASET POLYDATA\nPOINTS 2 float\n" +
        big_endian<float>({0.5F, 1, 2, 3, 4, 5}) + "\nPOINT_DATA 2\nCOLOR_SCALARS surface 1\n" +
        std::string("\0\xff", 2) + "\nTEXTURE_COORDINATES place 2 float\n" +
        big_endian<float>({1, 2, 3, 4}) + "\nSCALARS d double 1\nLOOKUP_TABLE t\n" +
        big_endian<double>({0.5, 1.5}) + "\nLOOKUP_TABLE t 2\n01234567\n";
    for (const std::string& file : {ascii, binary}) {
        const Snapshot snapshot = read(file);
        ASSERT_EQ(snapshot.point_data.size(), 3U);
        EXPECT_EQ(find_array(snapshot, "surface")->values,
                  ArrayValues(std::vector<std::uint8_t>{0, 255}));
        EXPECT_EQ(find_array(snapshot, "place")->values,
                  ArrayValues(std::vector<float>{1, 2, 3, 4}));
        EXPECT_EQ(find_array(snapshot, "place")->components, 2);
    }
    const std::string colors =
        preamble("POLYDATA") + points() + "POINT_DATA 2\nCOLOR_SCALARS c 1\n";
    expect_mentions(message(colors + "0 1.5\n"), {"COLOR_SCALARS 'c'", "0 to 1", "1.5"});
    expect_mentions(message(colors + "0 nan\n"), {"COLOR_SCALARS 'c'", "0 to 1", "nan"});
}

TEST_F(LegacyVtkAscii, TruncationIsNoticedWithinEverySection) {
    const std::string whole = whole_file();
    // Where a section ends and nothing says that another one should follow, the file is well
    // formed: after the cells and after each array of point data.
    std::set<std::size_t> well_formed{whole.size()};
    for (const char* next : {"POINT_DATA", "VECTORS", "FIELD"})
        well_formed.insert(whole.find(next));
    for (std::size_t length = 1; length <= whole.size(); ++length) {
        const std::string cut = whole.substr(0, length);
        if (well_formed.count(length) > 0) {
            EXPECT_EQ(read(cut).size(), 2U) << cut;
            continue;
        }
        const std::string text = message(cut);
        expect_mentions(text, {"state.vtk"});
        if (length > (preamble() + points()).size())
            expect_mentions(text, {"section", "2 particles"});
    }
}

TEST_F(LegacyVtkAscii, LyingHeadersTakeNoMemory) {
    for (const char* count : {"1000000000000000000", "18446744073709551615", "6148914691236517206",
                              "99999999999999999999", "-2", "2x", "two"}) {
        const std::string claim(count);
        expect_mentions(message(preamble() + "POINTS " + claim + " float\n" + cells()),
                        {"section POINTS", count});
        expect_mentions(message(preamble() + points() + "CELLS 2 " + claim + "\n" + cells()),
                        {"section CELLS", count});
        expect_mentions(message(preamble("POLYDATA") + points() + "VERTICES 2 " + claim + "\n1 0"),
                        {"section VERTICES", count});
        expect_mentions(
            message(preamble() + points() + "CELLS 2 4\n1 0 1 1\nCELL_TYPES " + claim + "\n1 1\n"),
            {"section CELL_TYPES", count});
        expect_mentions(message(preamble() + points() + cells() + "POINT_DATA " + claim + "\n"),
                        {"POINT_DATA", count});
        expect_mentions(message(preamble() + points() + cells() + "POINT_DATA 2\nSCALARS id int " +
                                claim + "\nLOOKUP_TABLE t\n1 2"),
                        {"section SCALARS 'id'"});
    }
    // Half the bytes that are left hold a value each.
    expect_mentions(message(preamble() + "POINTS 2 float\n1 2 3 4 5"), {"2 x 3 values", "9 bytes"});
}

TEST_F(LegacyVtkAscii, ManyEmptyArraysEndSoon) {
    std::string file = preamble("POLYDATA") + "POINTS 0 float\nPOINT_DATA 0\nFIELD f 100000\n";
    for (int i = 0; i < 100'000; ++i)
        file += "a" + std::to_string(i) + " 1 0 int\n";
    expect_mentions(message(file), {"at most 1000 arrays", "100000"});
    expect_mentions(message(file + "FIELD g 1\na5 1 0 int\n"), {"'a5'", "second time"});
}

TEST_F(LegacyVtkAscii, TextsNamedVtkAreNoSnapshots) {
    expect_mentions(message("# dam break, frame 4\n0.5 1 2\n"), {"state.vtk", "legacy VTK"});
    const fs::path misspelt =
        write("state.vtk", "# vtk DaFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n" + points());
    expect_mentions(error_of<InputError>([&] { legacy_vtk_format().read(misspelt); }),
                    {"section header", "DataFile", "DaFile"});
    expect_mentions(message("# vtk DataFile Version 3.0\nand nothing else\n"),
                    {"state.vtk", "section header", "ASCII or BINARY", "truncated"});
    expect_mentions(message("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nhello\n"),
                    {"section POINTS", "'hello'"});
}

} // namespace
} // namespace meniscus
