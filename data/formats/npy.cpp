// NumPy's `.npy` with one array of positions: N x 2 or N x 3 numbers, floating-point of 4 or 8
// bytes, in either order of bytes and of rows and columns.
#include "snapshot_formats.hpp"

#include "detail/number_blocks.hpp"
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "\x93NUMPY";

struct Header {
    std::string description; ///< of the type, such as <f8
    bool columns_first = false;
    std::uint64_t rows = 0;
    std::uint64_t columns = 0;
};

[[noreturn]] void fail(const fs::path& file, const std::string& expected,
                       const std::string& found) {
    throw InputError(file.string() + ": NumPy array: expected " + expected + ", found " + found);
}

/// What stands behind 'key': in the header, up to the comma that ends it.
std::string_view value_of(const fs::path& file, std::string_view header, const std::string& key) {
    const std::size_t begin = header.find("'" + key + "':");
    if (begin == std::string_view::npos)
        fail(file, "'" + key + "' in the header", "none");
    std::string_view value = header.substr(begin + key.size() + 3);
    value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
    return value;
}

Header parsed_header(const fs::path& file, std::string_view text) {
    Header header;
    const std::string_view type = value_of(file, text, "descr");
    header.description = type.substr(0, 1) == "'" ? type.substr(1, type.find('\'', 1) - 1) : "";
    header.columns_first = value_of(file, text, "fortran_order").substr(0, 4) == "True";
    const std::string_view shape = value_of(file, text, "shape");
    const std::size_t comma = shape.find(',');
    const std::size_t end = shape.find(')');
    if (shape.substr(0, 1) != "(" || comma == std::string_view::npos || end < comma ||
        end == std::string_view::npos)
        fail(file, "a shape of N x 2 or N x 3", quoted_text(shape.substr(0, 40)));
    std::string_view rows = shape.substr(1, comma - 1);
    std::string_view columns = shape.substr(comma + 1, end - comma - 1);
    if (read_number(take_word(rows), header.rows) != std::errc() ||
        read_number(take_word(columns), header.columns) != std::errc() || header.columns < 2 ||
        header.columns > 3)
        fail(file, "a shape of N x 2 or N x 3", quoted_text(shape.substr(0, end + 1)));
    return header;
}

Header take_header(const fs::path& file, std::string_view& rest) {
    const bool is_first = rest.size() > 6 && rest[6] == 1;
    const std::size_t begin = is_first ? 10 : 12;
    std::size_t length = 0;
    for (std::size_t i = begin; i > 8 && rest.size() >= begin; --i)
        length = length * 256 + static_cast<unsigned char>(rest[i - 1]);
    if (rest.size() < begin || length > rest.size() - begin)
        fail(file, "a whole header", "the end of the file; export it again");
    const Header header = parsed_header(file, rest.substr(begin, length));
    rest.remove_prefix(begin + length);
    return header;
}

NumberType type_of(const fs::path& file, const std::string& description) {
    const std::string size = description.empty() ? "" : description.substr(1);
    if (size != "f4" && size != "f8")
        fail(file, "positions of type float32 or float64", quoted_text(description));
    return size == "f4" ? NumberType::float32 : NumberType::float64;
}

ArrayValues transposed(const ArrayValues& values, std::size_t columns) {
    return std::visit(
        [&](const auto& stored) -> ArrayValues {
            auto rows = stored;
            const std::size_t count = stored.size() / columns;
            for (std::size_t i = 0; i < stored.size(); ++i)
                rows[i % count * columns + i / count] = stored[i];
            return rows;
        },
        values);
}

bool is_npy(const fs::path& file) {
    return read_whole(file, magic.size()) == magic;
}

/// Throws InputError on anything else; memory is bounded by the file's own size.
Snapshot read_npy(const fs::path& file, const ReadChoices& /*choices*/) {
    const std::string bytes = read_whole(file);
    std::string_view rest = bytes;
    const Header header = take_header(file, rest);
    const NumberType type = type_of(file, header.description);
    const std::uint64_t row_bytes = header.columns * size_of(type);
    if (header.rows > rest.size() / row_bytes || header.rows * row_bytes != rest.size())
        fail(file,
             std::to_string(header.rows) + " x " + std::to_string(header.columns) + " numbers",
             std::to_string(rest.size()) + " bytes; export it again");
    const ArrayValues values = decoded(type, rest, header.description.front() == '>');
    Snapshot snapshot;
    set_positions(snapshot, header.columns_first ? transposed(values, header.columns) : values,
                  header.columns);
    return snapshot;
}

} // namespace

SnapshotFormat npy_format() {
    return {"NumPy .npy of positions", is_npy, read_npy};
}

} // namespace meniscus
