// What other tools write: PLY, NumPy, extended XYZ, LAMMPS; and files that are none of these.
#include "expected_errors.hpp"
#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace meniscus {
namespace {

class Tables : public TestFolder {
protected:
    Snapshot read(std::string_view bytes) const { return read_snapshot(write("state", bytes)); }
    std::string error(std::string_view bytes) const {
        return error_of<InputError>([&] { read(bytes); });
    }
};

template <class Number>
std::string stored(std::initializer_list<Number> numbers, bool big_endian = false) {
    std::string all;
    for (const Number number : numbers) {
        std::string bytes(sizeof(Number), '\0');
        std::memcpy(bytes.data(), &number, bytes.size());
        if (big_endian)
            std::reverse(bytes.begin(), bytes.end());
        all += bytes;
    }
    return all;
}

const Positions expected = {{1, 2.5, -3}, {4, 5, 6}};

std::string ply(const std::string& format, const std::string& data) {
    return "ply\nformat " + format +
           " 1.0\ncomment by hand\nelement vertex 2\nproperty float x\nproperty float y\n"
           "property float z\nproperty int id\nelement face 0\n"
           "property list uchar int vertex_indices\nend_header\n" +
           data;
}

TEST_F(Tables, PlyInEveryEncoding) {
    const auto bytes = [](bool big) {
        return stored<float>({1, 2.5F, -3}, big) + stored<std::int32_t>({7}, big) +
               stored<float>({4, 5, 6}, big) + stored<std::int32_t>({8}, big);
    };
    for (const std::string& file :
         {ply("ascii", "1 2.5 -3 7\n4 5 6 8\n"), ply("binary_little_endian", bytes(false)),
          ply("binary_big_endian", bytes(true))}) {
        const Snapshot snapshot = read(file);
        EXPECT_EQ(snapshot.positions, expected);
        EXPECT_EQ(snapshot.position_precision, Precision::float32);
        EXPECT_EQ(scalar_values(snapshot, "id"), (std::vector<double>{7, 8}));
    }
}

TEST_F(Tables, PlyThatIsWrongIsNamed) {
    expect_mentions(error(ply("ascii", "1 2 3 7\n44 55 66\n")),
                    {"vertex 1", "'id'", "end of the file"});
    expect_mentions(error(ply("binary_little_endian", "abc")), {"2 vertices", "truncated"});
    expect_mentions(error(ply("utf8", "")), {"format ascii", "'utf8'"});
    std::string faces = ply("ascii", "1 2 3 7\n4 5 6 8\n3 0 1 1\n");
    faces.replace(faces.find("face 0"), 6, "face 1");
    expect_mentions(error(faces), {"face", "mesh"});
    expect_mentions(error("ply\nformat ascii 1.0\n"), {"end_header"});
    std::string many = ply("ascii", "1 2 3 7\n");
    many.replace(many.find("vertex 2"), 8, "vertex 99999999999999");
    expect_mentions(error(many), {"99999999999999"});
}

std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                const std::string& data) {
    const std::string header =
        "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
    return "\x93NUMPY" + std::string("\x01\x00", 2) +
           stored<std::uint16_t>({static_cast<std::uint16_t>(header.size())}) + header + data;
}

TEST_F(Tables, NumPyInEveryOrder) {
    const auto by_rows = {1., 2.5, -3., 4., 5., 6.};
    const auto by_columns = {1., 4., 2.5, 5., -3., 6.};
    EXPECT_EQ(read(npy("<f8", "False", "(2, 3)", stored(by_rows))).positions, expected);
    EXPECT_EQ(read(npy(">f8", "False", "(2, 3)", stored(by_rows, true))).positions, expected);
    EXPECT_EQ(read(npy("<f8", "True", "(2, 3)", stored(by_columns))).positions, expected);
    const Snapshot single =
        read(npy("<f4", "False", "(2, 3)", stored<float>({1, 2.5F, -3, 4, 5, 6})));
    EXPECT_EQ(single.positions, expected);
    EXPECT_EQ(single.position_precision, Precision::float32);
    const Snapshot flat = read(npy("<f8", "False", "(3, 2)", stored(by_rows)));
    EXPECT_EQ(flat.dimension, 2);
    EXPECT_EQ(flat.positions, (Positions{{1, 2.5, 0}, {-3, 4, 0}, {5, 6, 0}}));
}

TEST_F(Tables, NumPyThatIsWrongIsNamed) {
    expect_mentions(error(npy("<f8", "False", "(2, 3)", "short")), {"2 x 3", "5 bytes"});
    expect_mentions(error(npy("<i8", "False", "(2, 3)", "")), {"float64", "'<i8'"});
    expect_mentions(error(npy("<f8", "False", "(6,)", "")), {"N x 3", "'(6,)'"});
    expect_mentions(error(npy("<f8", "False", "(2, 7)", "")), {"N x 3", "'(2, 7)'"});
    expect_mentions(error("\x93NUMPY"), {"whole header"});
}

TEST_F(Tables, ExtendedXyz) {
    const Snapshot snapshot =
        read("2\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3:velo:R:3:id:I:1\n"
             "W 1 2.5 -3 1 2 3 7\nW 4 5 6 4 5 6 8\n");
    EXPECT_EQ(snapshot.positions, expected);
    EXPECT_EQ(as_doubles(*find_array(snapshot, "velocity")),
              (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(scalar_values(snapshot, "id"), (std::vector<double>{7, 8}));
    EXPECT_EQ(read("2\nplain\nH 1 2.5 -3\nO 4 5 6\n").positions, expected);
    expect_mentions(error("2\nplain\nH 1 2 3\n"), {"state: line", "words"});
    expect_mentions(error("2\nplain\nH 1 2 3\nO 4 5 x\n"), {"line 4", "'z'", "'x'"});
}

TEST_F(Tables, LammpsDumps) {
    const std::string head = "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\n"
                             "ITEM: BOX BOUNDS pp ff pp\n0 10\n0 10\n-5 5\n";
    const Snapshot snapshot =
        read(head + "ITEM: ATOMS id type x y z vx vy vz\n7 1 1 2.5 -3 1 2 3\n8 1 4 5 6 4 5 6\n");
    EXPECT_EQ(snapshot.positions, expected);
    EXPECT_EQ(scalar_values(snapshot, "id"), (std::vector<double>{7, 8}));
    EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
    EXPECT_EQ(snapshot.provenance.at("periodic"), "x=0.0:10.0,z=-5.0:5.0");
    const Snapshot scaled = read(head + "ITEM: ATOMS id xs ys zs\n7 0.1 0.25 0.2\n8 0.4 0.5 1\n");
    EXPECT_NEAR(scaled.positions[0][2], -3, 1e-12);
    expect_mentions(error(head + "ITEM: ATOMS id x y z\n7 1 2 3\n"), {"state: line", "words"});
    expect_mentions(error(head), {"ITEM: ATOMS"});
    expect_mentions(error(head + "ITEM: ATOMS id q\n7 1\n8 1\n"), {"columns x, y and z"});
}

TEST_F(Tables, OtherFilesAreCalledByTheirNames) {
    const std::pair<std::string, const char*> files[] = {
        {"\x7fNSJb\x01", "Houdini's newer .bgeo"},
        {"<?xml version=\"1.0\"?><svg/>", "XML that is not VTK's"},
        {"{\"a\": 1}", "JSON"},
        {std::string("PK\x03\x04", 4), "ZIP"},
        {"CDF\x01", "NetCDF"},
        {"solid cube\n", "STL mesh"},
        {"1.0 2.0 3.0\n4 5 6\n", "line such as 'x,y,z'"},
        {"hello\n", "'hello'"},
        {"a\x01\x02", "binary"}};
    for (const auto& [bytes, name] : files)
        expect_mentions(error(bytes), {"state: expected a snapshot", name});
}

} // namespace
} // namespace meniscus
