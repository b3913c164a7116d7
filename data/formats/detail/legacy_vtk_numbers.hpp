// What legacy VTK files are made of below their sections: lines of words, and blocks of numbers,
// which are text in ASCII files and big-endian bytes in binary ones. Every claim of a file is
// checked against the bytes that are left of it before anything is allocated.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::legacy_vtk {

/// The words of a line such as "POINTS 26136 float".
using Words = std::vector<std::string>;

/// What is left of a file to read.
struct Source {
    std::filesystem::path file;
    std::string_view rest;
    bool binary = true;          ///< how numbers are stored
    std::uint64_t particles = 0; ///< as POINTS claims, 0 before
};

/// Throws an InputError that names the file, the section and the number of particles.
[[noreturn]] void fail(const Source& source, const std::string& section,
                       const std::string& expected, const std::string& found);

/// Words of the file for a message; without any, that the file ends there.
std::string shown(const Words& words);

/// True where the first word is the keyword, in letters of any case.
bool starts_with(const Words& words, std::string_view keyword);

/// The words of the line that `source` is at, which may be none.
Words line_words(Source& source);

/// The next line that has words on it; none at the end of the file.
Words next_words(Source& source);

/// Fails unless the header has as many words as it should.
void expect_words(const Source& source, const Words& header, const std::string& section,
                  const std::string& form, std::size_t min, std::size_t max);

/// A whole number of a header. Fails where the word is none.
std::uint64_t parse_count(const Source& source, const std::string& section,
                          const std::string& word);

/// As parse_count, for a number from 1 on.
int parse_components(const Source& source, const std::string& section, const std::string& word);

/// A number type of the format, and how its values are read.
struct ScalarType {
    std::string_view name;
    std::uint64_t bits; ///< per value, in binary files
    ArrayValues (*decode)(std::string_view block, std::size_t count);
    ArrayValues (*parse)(Source& source, const std::string& section, std::string_view type,
                         std::size_t count);
};

/// The type of that name. Fails where there is none.
const ScalarType& parse_type(const Source& source, const std::string& section,
                             const std::string& word);

/// The next `count` texts: lines in ASCII files, lengths and bytes in binary ones.
std::vector<std::string> take_texts(Source& source, const std::string& section,
                                    std::uint64_t count);

/// The next `tuples` times `components` values. Fails where the rest of the file cannot hold them,
/// and where text is no number that the type can hold.
ArrayValues take_values(Source& source, const std::string& section, std::uint64_t tuples,
                        std::uint64_t components, const ScalarType& type);

} // namespace meniscus::legacy_vtk
