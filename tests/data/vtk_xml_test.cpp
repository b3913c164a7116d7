// VTK's XML files, in every encoding that VTK writes.
#include "expected_errors.hpp"
#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

namespace meniscus {
namespace {

std::string base64(const std::string& bytes) {
    constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t b = 0; b < 3; ++b)
            bits =
                bits * 256 + (i + b < bytes.size() ? static_cast<unsigned char>(bytes[i + b]) : 0);
        for (std::size_t c = 0; c < 4; ++c)
            text += i + c <= bytes.size() ? alphabet[bits >> (18 - 6 * c) & 63] : '=';
    }
    return text;
}

template <class Number>
std::string bytes_of_numbers(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

std::string header(std::uint64_t number, bool wide) {
    return bytes_of_numbers(std::vector<std::uint64_t>{number}).substr(0, wide ? 8 : 4);
}

/// How a file stores its numbers.
struct Encoding {
    bool appended;
    bool raw;
    bool compressed;
    bool wide; ///< headers of 8 bytes
};

/// Blocks of 16 bytes, so that there are several and the last is shorter.
std::string encoded(const std::string& bytes, const Encoding& encoding) {
    const auto text = [&](const std::string& stored) {
        return encoding.raw ? stored : base64(stored);
    };
    if (!encoding.compressed)
        return text(header(bytes.size(), encoding.wide) + bytes);
    constexpr std::size_t block = 16;
    const std::size_t blocks = (bytes.size() + block - 1) / block;
    std::string head = header(blocks, encoding.wide) + header(block, encoding.wide) +
                       header(bytes.size() % block, encoding.wide);
    std::string all;
    for (std::size_t i = 0; i < blocks; ++i) {
        const std::string part = bytes.substr(i * block, block);
        std::string stored(200, '\0');
        uLongf size = stored.size();
        compress(reinterpret_cast<Bytef*>(stored.data()), &size,
                 reinterpret_cast<const Bytef*>(part.data()), part.size());
        head += header(size, encoding.wide);
        all += stored.substr(0, size);
    }
    return text(head) + text(all);
}

const std::vector<double> coordinates = {0, 0, 0.5, 1, 0, 0, 0, 2, 0};
const std::vector<std::int32_t> numbers = {7, 8, 9};

std::string file_of(const Encoding& encoding, const std::string& kind = "UnstructuredGrid") {
    const std::string points = encoded(bytes_of_numbers(coordinates), encoding);
    const std::string ids = encoded(bytes_of_numbers(numbers), encoding);
    const auto array = [&](const std::string& attributes, const std::string& data,
                           std::size_t offset) {
        return encoding.appended ? "<DataArray " + attributes + " format='appended' offset=\"" +
                                       std::to_string(offset) + "\"/>\n"
                                 : "<DataArray " + attributes + " format=\"binary\">\n  " + data +
                                       "\n</DataArray>\n";
    };
    std::string text = "<?xml version=\"1.0\"?>\n<!-- > -->\n<VTKFile type=\"" + kind +
                       "\" byte_order=\"LittleEndian\"";
    text += encoding.wide ? " header_type=\"UInt64\"" : "";
    text += encoding.compressed ? " compressor=\"vtkZLibDataCompressor\">" : ">";
    text += "<" + kind + "><Piece NumberOfPoints=\"3\" NumberOfCells=\"0\">\n<PointData>\n" +
            array("type=\"Int32\" Name=\"Idp\"", ids, 0) + "</PointData><Points>\n" +
            array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points, ids.size()) +
            "</Points></Piece></" + kind + ">\n";
    if (encoding.appended)
        text += std::string("<AppendedData encoding=\"") + (encoding.raw ? "raw" : "base64") +
                "\">\n_" + ids + points + "\n</AppendedData>\n";
    return text + "</VTKFile>\n";
}

class VtkXml : public TestFolder {
protected:
    Snapshot read(std::string_view bytes) const { return read_snapshot(write("a.vtu", bytes)); }
    std::string error(std::string_view bytes) const {
        return error_of<InputError>([&] { read(bytes); });
    }
};

TEST_F(VtkXml, EveryEncodingReadsTheSame) {
    for (const bool compressed : {false, true})
        for (const bool wide : {false, true})
            for (const auto& [appended, raw] :
                 {std::pair(false, false), {true, false}, {true, true}})
                for (const char* kind : {"UnstructuredGrid", "PolyData"}) {
                    const Snapshot snapshot =
                        read(file_of({appended, raw, compressed, wide}, kind));
                    EXPECT_EQ(snapshot.positions, (Positions{{0, 0, 0.5}, {1, 0, 0}, {0, 2, 0}}));
                    EXPECT_EQ(find_array(snapshot, "id")->values, ArrayValues(numbers));
                }
}

const std::string text_file =
    "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>\n"
    "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
    "format=\"ascii\">0.25</DataArray></FieldData>\n"
    "<Piece NumberOfPoints=\"1\" NumberOfCells=\"1\"><PointData>\n"
    "<DataArray type=\"Float32\" Name=\"Vel\" NumberOfComponents=\"3\" format=\"ascii\">\n1 2 3\n"
    "<InformationKey name=\"k\"><Value index=\"0\">9</Value></InformationKey></DataArray>\n"
    "<Array type=\"String\" Name=\"material\" format=\"ascii\">119 0</Array></PointData>\n"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">4 5 6"
    "</DataArray></Points>\n"
    "<Cells><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">1</DataArray></Cells>\n"
    "</Piece></UnstructuredGrid></VTKFile>\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

TEST_F(VtkXml, ReadsText) {
    const Snapshot snapshot = read(text_file);
    EXPECT_EQ(snapshot.positions, (Positions{{4, 5, 6}}));
    EXPECT_EQ(snapshot.position_precision, Precision::float32);
    EXPECT_EQ(as_doubles(*find_array(snapshot, "velocity")), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(snapshot.time, 0.25);
    ASSERT_EQ(snapshot.notes.size(), 1U);
    expect_mentions(snapshot.notes[0], {"'material'", "text"});
}

TEST_F(VtkXml, PiecesFollowOneAnother) {
    const std::size_t begin = text_file.find("<Piece");
    const std::size_t end = text_file.find("</Piece>") + 8;
    const std::string piece = text_file.substr(begin, end - begin);
    const Snapshot snapshot = read(replaced(text_file, "</Piece>", "</Piece>" + piece));
    EXPECT_EQ(snapshot.size(), 2U);
    EXPECT_EQ(as_doubles(*find_array(snapshot, "velocity")).size(), 6U);
}

TEST_F(VtkXml, WhatIsWrongIsNamed) {
    expect_mentions(error(replaced(text_file, ">1</Data", ">5</Data")), {"cell type 5", "mesh"});
    expect_mentions(error(replaced(text_file, "4 5 6", "4 5")), {"index 2 of 3", "end"});
    expect_mentions(error(replaced(text_file, "4 5 6", "4 5 x")), {"'x'"});
    expect_mentions(error(replaced(text_file, "\"Float32\" Name", "\"Float16\" Name")),
                    {"'Vel'", "Float64", "'Float16'"});
    expect_mentions(error(replaced(text_file, "UnstructuredGrid", "PUnstructuredGrid")),
                    {"'PUnstructuredGrid'", "other files"});
    expect_mentions(error(replaced(text_file, "UnstructuredGrid", "ImageData")),
                    {"'ImageData'", "export particles"});
    expect_mentions(error(replaced(text_file, "NumberOfPoints=\"1\"", "NumberOfPoints=\"1e9\"")),
                    {"NumberOfPoints", "'1e9'"});
    expect_mentions(
        error(replaced(text_file, "NumberOfPoints=\"1\"", "NumberOfPoints=\"999999999999\"")),
        {"a.vtu"});
    const std::string lz4 = replaced(file_of({false, false, true, false}), "vtkZLib", "vtkLZ4");
    expect_mentions(error(lz4), {"vtkLZ4DataCompressor", "zlib"});
}

TEST_F(VtkXml, DamagedFilesAreReadOrRefused) {
    for (const Encoding& encoding :
         {Encoding{true, false, true, false}, {true, true, false, true}}) {
        const std::string whole = file_of(encoding);
        for (std::size_t i = 0; i < whole.size(); ++i) {
            if (i + 12 < whole.size())
                expect_mentions(error(std::string_view(whole).substr(0, i + 1)), {"a.vtu"});
            std::string damaged = whole;
            damaged[i] = static_cast<char>(~damaged[i]);
            try {
                read(damaged);
            } catch (const InputError& failure) {
                expect_mentions(failure.what(), {"a.vtu"});
            }
        }
    }
}

} // namespace
} // namespace meniscus
