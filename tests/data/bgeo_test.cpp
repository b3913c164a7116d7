// Files are put together here byte by byte, as Partio lays them out. samples/partio_cube.bgeo is
// one that SPlisHSPlasH's Partio exporter wrote, with fewer particles (see cut_bgeo.py there).
#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/snapshot_formats.hpp>
#include <meniscus/data/text/errors.hpp>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

template <class Number>
std::string big_endian(Number number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string named(const std::string& text) {
    return big_endian(static_cast<std::uint16_t>(text.size())) + text;
}

enum : std::uint32_t { float_type, integer_type, text_type, index_type = 4, vector_type };

std::string attribute(const std::string& name, std::uint16_t size, std::uint32_t type) {
    return named(name) + big_endian(size) + big_endian(type) +
           std::string(std::size_t{4} * size, '\0');
}

std::string index_attribute(const std::string& name, const std::vector<std::string>& texts) {
    std::string bytes = named(name) + big_endian(std::uint16_t{1}) + big_endian(index_type) +
                        big_endian(static_cast<std::uint32_t>(texts.size()));
    for (const std::string& text : texts)
        bytes += named(text);
    return bytes;
}

/// The counts of a header: points, primitives, point groups, primitive groups, and attributes of
/// points, vertices, primitives and the whole.
using Counts = std::array<std::uint32_t, 8>;

std::string header(const Counts& counts, std::uint32_t version = 5) {
    std::string bytes = "BgeoV" + big_endian(version);
    for (const std::uint32_t count : counts)
        bytes += big_endian(count);
    return bytes;
}

/// Pieces of a file, so that it can be cut between any two of them.
using Pieces = std::vector<std::string>;

/// Three particles with an attribute of each type, and one of the whole.
Pieces pieces() {
    Pieces all = {header({3, 0, 0, 0, 4, 0, 0, 1}), attribute("id", 1, integer_type),
                  attribute("velocity", 3, vector_type), attribute("density", 1, float_type),
                  index_attribute("material", {"oil", "water"})};
    for (int i = 0; i < 3; ++i) {
        std::string point;
        for (const float x : {0.1F * static_cast<float>(i), -2.5F, static_cast<float>(i * i), 1.F})
            point += big_endian(x);
        point += big_endian(std::int32_t{70000 - i});
        for (const float v : {1.F, -0.5F, static_cast<float>(i)})
            point += big_endian(v);
        point += big_endian(1000.F + static_cast<float>(i)) + big_endian(std::int32_t{i % 2});
        all.push_back(point);
    }
    all.push_back(attribute("time", 1, float_type));
    all.push_back(big_endian(0.25F));
    all.push_back(std::string("\x00\xff", 2));
    return all;
}

std::string joined(const Pieces& pieces) {
    std::string bytes;
    for (const std::string& piece : pieces)
        bytes += piece;
    return bytes;
}

std::string gzip(const std::string& bytes) {
    z_stream stream = {};
    deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + 16, 9, Z_DEFAULT_STRATEGY);
    std::string compressed(deflateBound(&stream, bytes.size()) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(compressed.data());
    stream.avail_out = static_cast<uInt>(compressed.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    compressed.resize(stream.total_out);
    deflateEnd(&stream);
    return compressed;
}

class Bgeo : public TestFolder {
protected:
    Snapshot reading(const std::string& bytes) const {
        return read_snapshot(write("state.bgeo", bytes));
    }

    std::string error_in(const std::string& bytes) const {
        const fs::path file = write("state.bgeo", bytes);
        return error_of<InputError>([&] { bgeo_format().read(file); });
    }

    /// Whatever becomes of the bytes, it is no crash, and every error names the file.
    void expect_read_or_refused(const std::string& bytes) const {
        const fs::path file = write("state.bgeo", bytes);
        try {
            bgeo_format().read(file);
        } catch (const InputError& error) {
            expect_mentions(error.what(), {"state.bgeo"});
        }
    }
};

void expect_is_whole(const Snapshot& snapshot) {
    ASSERT_EQ(snapshot.size(), 3U);
    EXPECT_EQ(snapshot.positions[2], (std::array<double, 3>{0.1F * 2.F, -2.5, 4}));
    EXPECT_EQ(snapshot.position_precision, Precision::float32);
    EXPECT_EQ(snapshot.dimension, 3);
    EXPECT_EQ(find_array(snapshot, "id")->values,
              ArrayValues(std::vector<std::int32_t>{70000, 69999, 69998}));
    EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
    EXPECT_EQ(find_array(snapshot, "velocity")->values,
              ArrayValues(std::vector<float>{1, -0.5F, 0, 1, -0.5F, 1, 1, -0.5F, 2}));
    EXPECT_EQ(find_array(snapshot, "density")->values,
              ArrayValues(std::vector<float>{1000, 1001, 1002}));
    EXPECT_EQ(find_array(snapshot, "material")->values,
              ArrayValues(std::vector<std::int32_t>{0, 1, 0}));
    EXPECT_EQ(find_array(snapshot, "time"), nullptr); // of the whole
}

TEST_F(Bgeo, ReadsEveryTypeOfAttribute) {
    expect_is_whole(reading(joined(pieces())));
}

TEST_F(Bgeo, ReadsCompressedFiles) {
    expect_is_whole(reading(gzip(joined(pieces()))));
}

TEST_F(Bgeo, ReadsAFileWithoutParticles) {
    const std::string bytes = header({}) + std::string("\x00\xff", 2);
    EXPECT_EQ(reading(bytes).size(), 0U);
    EXPECT_EQ(reading(gzip(bytes)).size(), 0U);
}

TEST_F(Bgeo, HoudinisNameOfVelocityBecomesOurs) {
    Pieces renamed = pieces();
    renamed[2] = attribute("v", 3, vector_type);
    EXPECT_NE(find_array(reading(joined(renamed)), "velocity"), nullptr);
    renamed[1] = attribute("velocity", 1, integer_type);
    const Snapshot both = reading(joined(renamed));
    EXPECT_EQ(find_array(both, "velocity")->components, 1);
    EXPECT_EQ(find_array(both, "v")->components, 3);
}

TEST_F(Bgeo, NonFinitePositionsAreReadAsTheyAre) {
    Pieces all = pieces();
    all[5].replace(0, 4, big_endian(std::nanf("")));
    const Snapshot snapshot = reading(joined(all));
    EXPECT_TRUE(std::isnan(snapshot.positions[0][0]));
    EXPECT_EQ(snapshot.positions[0][1], -2.5);
}

TEST_F(Bgeo, AMissingEndIsRefusedAndItsSectionNamed) {
    const char* sections[] = {
        "header", "attribute 1 of 4", "attribute 2", "attribute 3",        "attribute 4",
        "points", "points",           "points",      "detail attribute 1", "detail values",
        "end"};
    const Pieces all = pieces();
    for (const bool compressed : {false, true}) {
        for (std::size_t kept = 1; kept < all.size(); ++kept) {
            const std::string cut = joined({all.begin(), all.begin() + static_cast<int>(kept)});
            expect_mentions(error_in(compressed ? gzip(cut) : cut),
                            {"state.bgeo", sections[kept], "found"});
        }
    }
}

TEST_F(Bgeo, CutAnywhereItIsRefused) {
    for (const std::string& whole : {joined(pieces()), gzip(joined(pieces()))})
        for (std::size_t length = 1; length < whole.size(); ++length)
            EXPECT_THROW(reading(whole.substr(0, length)), InputError) << length;
}

TEST_F(Bgeo, TrailingBytesAreRefused) {
    const std::string whole = joined(pieces());
    for (const std::string& bytes :
         {whole + '\0', gzip(whole + "x"), gzip(whole) + "x", gzip(whole) + gzip(whole)})
        expect_mentions(error_in(bytes), {"state.bgeo", "section end", "more bytes"});
}

TEST_F(Bgeo, FlippedBytesAreReadOrRefused) {
    for (const std::string& whole : {joined(pieces()), gzip(joined(pieces()))}) {
        for (std::size_t i = 0; i < whole.size(); ++i) {
            for (const int bits : {0xff, 0x01, 0x80}) {
                std::string damaged = whole;
                damaged[i] = static_cast<char>(damaged[i] ^ bits);
                expect_read_or_refused(damaged);
            }
        }
    }
}

TEST_F(Bgeo, ChecksumsOfCompressionCount) {
    std::string damaged = gzip(joined(pieces()));
    damaged[damaged.size() - 8] ^= 1;
    expect_mentions(error_in(damaged), {"section end", "damaged compression"});
}

TEST_F(Bgeo, CountsThatNoFileHoldsAreRefused) {
    const Pieces all = pieces();
    for (const std::uint32_t count : {4U, 1U << 20, 0x7fffffffU, 0xffffffffU}) {
        Pieces claimed = all;
        claimed[0] = header({count, 0, 0, 0, 4, 0, 0, 1});
        expect_mentions(error_in(joined(claimed)), {"points", std::to_string(count).c_str()});
        expect_mentions(error_in(gzip(joined(claimed))), {std::to_string(count).c_str()});
        claimed[0] = header({3, 0, 0, 0, count + 2000, 0, 0, 1});
        expect_mentions(error_in(joined(claimed)), {"header", "attributes"});
        claimed[0] = header({3, 0, 0, 0, 4, 0, 0, count + 2000});
        expect_mentions(error_in(joined(claimed)), {"header", "attributes"});
    }
    // A table of four thousand million texts.
    Pieces claimed = all;
    claimed[4].replace(claimed[4].find("material") + 14, 4, "\xff\xff\xff\xff");
    expect_mentions(error_in(joined(claimed)), {"attribute 'material'"});
}

TEST_F(Bgeo, MoreThanPointsIsRefused) {
    for (const std::size_t which : {2, 3, 5, 6}) {
        Counts counts = {3, 0, 0, 0, 4, 0, 0, 1};
        counts[which] = 1;
        Pieces all = pieces();
        all[0] = header(counts);
        expect_mentions(error_in(joined(all)), {"header", "points alone"});
    }
    Pieces all = pieces();
    all[0] = header({3, 2, 0, 0, 4, 0, 0, 1});
    expect_mentions(error_in(joined(all)), {"header", "2 primitives"});
    all[0] = header({3, 1, 0, 0, 4, 0, 0, 1}); // whose type is missing
    expect_mentions(error_in(joined(all)), {"primitive", "particles, type 32768"});
}

TEST_F(Bgeo, OtherVersionsAndTypesAreRefused) {
    Pieces all = pieces();
    all[0] = header({3, 0, 0, 0, 4, 0, 0, 1}, 6);
    expect_mentions(error_in(joined(all)), {"header", "version 5", "6"});
    all = pieces();
    all[1] = attribute("id", 1, text_type);
    expect_mentions(error_in(joined(all)), {"attribute 'id'", "type 2"});
    all[1] = attribute("id", 0, integer_type);
    expect_mentions(error_in(joined(all)), {"attribute 'id'", "found 0"});
    all[1] = attribute("den\nsity", 1, text_type);
    expect_mentions(error_in(joined(all)), {"attribute 'den?sity'"});
    all[1] = attribute("density", 1, integer_type);
    expect_mentions(error_in(joined(all)), {"attribute 'density'", "a second time"});
}

TEST_F(Bgeo, OtherFilesAreNotOurs) {
    EXPECT_FALSE(bgeo_format().detect(write("text", "no geometry")));
    EXPECT_FALSE(bgeo_format().detect(write("text.gz", gzip("no geometry"))));
    EXPECT_FALSE(bgeo_format().detect(write("short", "Bgeo")));
    EXPECT_FALSE(bgeo_format().detect(write("short.gz", "\x1f\x8b")));
    expect_mentions(error_in(gzip("no geometry")), {"header", "BgeoV"});
}

TEST_F(Bgeo, ReadsTheSample) {
    const Snapshot snapshot = read_snapshot(fs::path(MENISCUS_TEST_SAMPLES) / "partio_cube.bgeo");
    ASSERT_GT(snapshot.size(), 10U);
    EXPECT_EQ(snapshot.dimension, 3);
    EXPECT_EQ(snapshot.point_data.size(), 3U);
    EXPECT_EQ(scalar_values(snapshot, "id").size(), snapshot.size());
    EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
    for (const double density : scalar_values(snapshot, "density")) {
        EXPECT_GT(density, 100); // of water in kg/m^3, summed up: less at corners
        EXPECT_LT(density, 1100);
    }
}

TEST_F(Bgeo, ReadsTheSharedFile) {
    const fs::path shared = fs::path(MENISCUS_SHARED_SNAPSHOTS) / "splishsplash";
    if (!fs::exists(shared))
        GTEST_SKIP() << "no " << shared;
    const Snapshot partio = read_snapshot(shared / "cube_iisph_partio.bgeo");
    const Snapshot vtk =
        legacy_vtk_format().read(shared / "cube_iisph_05.vtk"); // the scene, later on
    ASSERT_EQ(partio.size(), vtk.size());
    auto partio_ids = scalar_values(partio, "id");
    auto vtk_ids = scalar_values(vtk, "id");
    std::sort(partio_ids.begin(), partio_ids.end());
    std::sort(vtk_ids.begin(), vtk_ids.end());
    EXPECT_EQ(partio_ids, vtk_ids);
    EXPECT_EQ(finite_positions(partio), std::vector<std::uint8_t>(partio.size(), 1));
}

} // namespace
} // namespace meniscus
