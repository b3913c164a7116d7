#include "unknown_files.hpp"

#include "number_blocks.hpp"
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <string_view>

namespace meniscus {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view begin; ///< of the file
    const char* description;
};

constexpr Signature signatures[] = {
    {"\x7fNSJb"sv, "Houdini's newer .bgeo (JSON); save it as .ply, .csv or Partio's classic .bgeo"},
    {"scf1"sv, "Houdini's .bgeo.sc (Blosc); save it as .ply, .csv or Partio's classic .bgeo"},
    {"PGEOMETRY"sv, "Houdini's classic text .geo; save it as binary .bgeo"},
    {"<?xml"sv, "XML that is not VTK's; export particles as .vtu, .vtk or .csv"},
    {"<"sv, "XML or HTML that is not VTK's; export particles as .vtu, .vtk or .csv"},
    {"{"sv, "JSON; export particles as .csv with a line 'x,y,z' or as .vtk"},
    {"["sv, "JSON, perhaps Houdini's newer .geo; export particles as .ply, .csv or .vtk"},
    {"PK\x03\x04"sv, "a ZIP archive, perhaps NumPy's .npz; save the positions alone by numpy.save"},
    {"\x1f\x8b"sv, "a file compressed by gzip that is no .bgeo; unpack it first"},
    {"BZh"sv, "a file compressed by bzip2; unpack it first"},
    {"\xfd"
     "7zXZ"sv,
     "a file compressed by xz; unpack it first"},
    {"\x28\xb5\x2f\xfd"sv, "a file compressed by zstd; unpack it first"},
    {"CDF"sv, "NetCDF; export particles as .csv, .vtk or HDF5"},
    {"solid"sv, "an STL mesh; export particles, not a surface"},
    {"OFF"sv, "an OFF mesh; export particles, not a surface"},
    {"v "sv, "an OBJ mesh; export particles, not a surface"},
    {"# Blender"sv, "a Blender file of a mesh; export particles, not a surface"},
    {"FoamFile"sv, "OpenFOAM's own format; export particles as .vtk (foamToVTK)"},
    {"/*"sv, "perhaps OpenFOAM's own format; export particles as .vtk (foamToVTK)"},
    {"%!"sv, "PostScript"},
    {"# vtk"sv, "legacy VTK with a first line of another version"},
};

bool is_text(std::string_view bytes) {
    return std::none_of(bytes.begin(), bytes.end(), [](unsigned char c) {
        return c < 32 && c != '\n' && c != '\r' && c != '\t';
    });
}

/// What JSON of the project's own is, which is no snapshot; empty for other files.
std::string own_json(std::string_view begin) {
    const auto has = [&](std::string_view part) {
        return begin.find(part) != std::string_view::npos;
    };
    if (begin.substr(0, 1) != "{")
        return {};
    if (has("\"meniscus model\"") || has("\"meniscus curvature model\""))
        return "a model; give it by --model, and snapshots here";
    if (has("\"particle_spacing\"") && has("\"fluid\""))
        return "a scene; `meniscus simulate` makes snapshots of it";
    return {};
}

/// True where the first line is numbers between spaces or separators.
bool begins_with_numbers(std::string_view text) {
    std::string line(text.substr(0, text.find('\n')));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    std::string_view rest = line;
    int count = 0;
    for (auto word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
        double number = 0;
        if (read_number(word, number) != std::errc())
            return false;
    }
    return count >= 2;
}

} // namespace

std::string description_of(const std::filesystem::path& file) {
    const std::string bytes = read_whole(file, 4096);
    const std::string_view begin = bytes;
    const std::string extension = lowered(file.extension().string());
    if (extension == ".bi4" || extension == ".ibi4")
        return "DualSPHysics' own binary format; convert it by PartVTK (-savevtk or -savecsv)";
    if (std::string own = own_json(begin); !own.empty())
        return own;
    for (const Signature& signature : signatures)
        if (begin.substr(0, signature.begin.size()) == signature.begin)
            return signature.description;
    if (!is_text(begin))
        return "other binary data; export particles as .vtk, .vtu, .csv or .ply";
    if (begins_with_numbers(begin))
        return "numbers without names; put a line such as 'x,y,z' in front, with commas";
    return "text that begins with " + quoted_text(begin.substr(0, begin.find('\n'))) +
           " and names no columns x, y and z between commas, semicolons or tabs; export it as "
           ".csv or .vtk";
}

} // namespace meniscus
