#include "legacy_vtk_numbers.hpp"

#include <meniscus/data/text/cut_numbers.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <system_error>

namespace meniscus::legacy_vtk {

namespace {

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// The line up to its end, which is taken too. Lines of more than 1000 characters are not text.
std::string_view take_line(Source& source) {
    const std::string_view line = source.rest.substr(0, 1000);
    const std::size_t end = std::min(line.find('\n'), line.size());
    source.rest.remove_prefix(std::min(end + 1, source.rest.size()));
    return line.substr(0, end);
}

// Numbers are stored big endian; the machines that this is built for are little endian.
template <class Number>
ArrayValues decode(std::string_view block, std::size_t count) {
    std::vector<Number> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        const char* stored = block.data() + i * sizeof(Number);
        std::reverse_copy(stored, stored + sizeof(Number), reinterpret_cast<char*>(&values[i]));
    }
    return values;
}

ArrayValues decode_bits(std::string_view block, std::size_t count) {
    std::vector<std::uint8_t> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = (static_cast<unsigned char>(block[i / 8]) >> (7 - i % 8)) & 1;
    return values;
}

/// The next word; empty where the file ends before it.
std::string_view take_word(Source& source) {
    const std::string_view rest = source.rest;
    const auto begin = std::find_if_not(rest.begin(), rest.end(), is_space);
    const auto end = std::find_if(begin, rest.end(), is_space);
    source.rest.remove_prefix(static_cast<std::size_t>(end - rest.begin()));
    return rest.substr(static_cast<std::size_t>(begin - rest.begin()),
                       static_cast<std::size_t>(end - begin));
}

[[noreturn]] void fail_at_value(const Source& source, const std::string& section,
                                std::string_view type, std::size_t index, std::size_t count,
                                std::string_view word) {
    fail(source, section,
         "a number of type " + std::string(type) + " at index " + std::to_string(index) + " of " +
             std::to_string(count) + " values",
         word.empty() ? "the end of the file; it is truncated, export it again"
                      : quoted_text(word));
}

template <class Number>
ArrayValues parse(Source& source, const std::string& section, std::string_view type,
                  std::size_t count) {
    std::vector<Number> values(count);
    std::vector<std::string_view> last_words;
    for (std::size_t i = 0; i < count; ++i) {
        std::string_view word = take_word(source);
        if (source.rest.empty() && may_be_cut(word, last_words))
            word = {};
        if (read_number(word, values[i]) != std::errc())
            fail_at_value(source, section, type, i, count, word);
        if (i + 20 > count)
            last_words.push_back(word);
    }
    return values;
}

ArrayValues parse_bits(Source& source, const std::string& section, std::string_view type,
                       std::size_t count) {
    ArrayValues values = parse<std::uint8_t>(source, section, type, count);
    const auto& bits = std::get<std::vector<std::uint8_t>>(values);
    for (std::size_t i = 0; i < count; ++i)
        if (bits[i] > 1)
            fail_at_value(source, section, type, i, count, std::to_string(bits[i]));
    return values;
}

// VTK writes long with the size that it has on Unix, and vtkIdType always as int.
constexpr ScalarType scalar_types[] = {
    {"bit", 1, decode_bits, parse_bits},
    {"char", 8, decode<std::int8_t>, parse<std::int8_t>},
    {"signed_char", 8, decode<std::int8_t>, parse<std::int8_t>},
    {"unsigned_char", 8, decode<std::uint8_t>, parse<std::uint8_t>},
    {"short", 16, decode<std::int16_t>, parse<std::int16_t>},
    {"unsigned_short", 16, decode<std::uint16_t>, parse<std::uint16_t>},
    {"int", 32, decode<std::int32_t>, parse<std::int32_t>},
    {"vtkidtype", 32, decode<std::int32_t>, parse<std::int32_t>},
    {"unsigned_int", 32, decode<std::uint32_t>, parse<std::uint32_t>},
    {"long", 64, decode<std::int64_t>, parse<std::int64_t>},
    {"vtktypeint64", 64, decode<std::int64_t>, parse<std::int64_t>},
    {"unsigned_long", 64, decode<std::uint64_t>, parse<std::uint64_t>},
    {"vtktypeuint64", 64, decode<std::uint64_t>, parse<std::uint64_t>},
    {"float", 32, decode<float>, parse<float>},
    {"double", 64, decode<double>, parse<double>},
};

} // namespace

void fail(const Source& source, const std::string& section, const std::string& expected,
          const std::string& found) {
    throw InputError(source.file.string() + ": section " + section + " (" +
                     std::to_string(source.particles) + " particles): expected " + expected +
                     ", found " + found);
}

std::string shown(const Words& words) {
    if (words.empty())
        return "the end of the file; it is truncated, export it again";
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return quoted_text(text);
}

bool starts_with(const Words& words, std::string_view keyword) {
    return !words.empty() && lowered(words[0]) == lowered(keyword);
}

Words line_words(Source& source) {
    const std::string_view line = take_line(source);
    Words words;
    auto begin = std::find_if_not(line.begin(), line.end(), is_space);
    while (begin != line.end()) {
        const auto end = std::find_if(begin, line.end(), is_space);
        words.emplace_back(begin, end);
        begin = std::find_if_not(end, line.end(), is_space);
    }
    return words;
}

Words next_words(Source& source) {
    Words words;
    while (words.empty() && !source.rest.empty())
        words = line_words(source);
    return words;
}

void expect_words(const Source& source, const Words& header, const std::string& section,
                  const std::string& form, std::size_t min, std::size_t max) {
    if (header.size() < min || header.size() > max)
        fail(source, section, "'" + form + "'", shown(header));
}

std::uint64_t parse_count(const Source& source, const std::string& section,
                          const std::string& word) {
    std::uint64_t count = 0;
    if (read_number(word, count) != std::errc())
        fail(source, section, "a count", shown({word}));
    return count;
}

int parse_components(const Source& source, const std::string& section, const std::string& word) {
    const std::uint64_t count = parse_count(source, section, word);
    if (count < 1 || count > std::numeric_limits<int>::max())
        fail(source, section, "one or more components", shown({word}));
    return static_cast<int>(count);
}

const ScalarType& parse_type(const Source& source, const std::string& section,
                             const std::string& word) {
    const std::string name = lowered(word);
    const auto* type = std::find_if(std::begin(scalar_types), std::end(scalar_types),
                                    [&](const ScalarType& known) { return known.name == name; });
    if (type == std::end(scalar_types))
        fail(source, section, "a number type such as float or unsigned_int", shown({word}));
    return *type;
}

std::vector<std::string> take_texts(Source& source, const std::string& section,
                                    std::uint64_t count) {
    std::vector<std::string> texts;
    for (std::uint64_t i = 0; i < count; ++i) {
        if (source.rest.empty())
            fail(source, section, std::to_string(count) + " texts", shown({}));
        if (!source.binary) {
            const std::string_view line = take_line(source);
            texts.emplace_back(line.substr(0, line.find('\r')));
            continue;
        }
        // A length whose first two bits say of how many bytes it is, the rest being big endian.
        const auto first = static_cast<unsigned char>(source.rest[0]);
        const std::size_t bytes = std::size_t{1} << (3 - first / 64);
        std::uint64_t length = first % 64;
        for (std::size_t b = 1; b < bytes && b < source.rest.size(); ++b)
            length = length * 256 + static_cast<unsigned char>(source.rest[b]);
        if (bytes > source.rest.size() || length > source.rest.size() - bytes)
            fail(source, section, "a text of " + std::to_string(length) + " bytes", shown({}));
        texts.emplace_back(source.rest.substr(bytes, length));
        source.rest.remove_prefix(bytes + length);
    }
    return texts;
}

ArrayValues take_values(Source& source, const std::string& section, std::uint64_t tuples,
                        std::uint64_t components, const ScalarType& type) {
    // Nothing is allocated or multiplied before the claim is known to fit. As text, a value takes
    // a digit and a space.
    const std::uint64_t bits = source.binary ? type.bits : 16;
    const std::uint64_t bytes_left = source.rest.size();
    if (tuples > bytes_left * 8 / bits / components) {
        fail(source, section,
             std::to_string(tuples) + " x " + std::to_string(components) + " values of type " +
                 std::string(type.name),
             std::to_string(bytes_left) +
                 " bytes left in the file; it is truncated or damaged, export it again");
    }
    const std::uint64_t count = tuples * components;
    if (!source.binary)
        return type.parse(source, section, type.name, count);
    const std::string_view block = source.rest.substr(0, (count * bits + 7) / 8);
    source.rest.remove_prefix(block.size());
    return type.decode(block, count);
}

} // namespace meniscus::legacy_vtk
