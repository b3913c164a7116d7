// Extended XYZ, as OVITO and ASE write it: the number of particles, a line of properties, and a
// line a particle; another state may follow. Without properties the columns are a species and x, y,
// z.
#include "snapshot_formats.hpp"

#include "detail/frames.hpp"
#include "detail/number_blocks.hpp"
#include "detail/word_table.hpp"
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <string>
#include <string_view>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

/// What stands behind `key=` in the second line, in quotes or up to a space.
std::string_view value_of(std::string_view line, std::string_view key) {
    const std::size_t begin = line.find(key);
    if (begin == std::string_view::npos)
        return {};
    line.remove_prefix(begin + key.size());
    const bool quoted = !line.empty() && line.front() == '"';
    return quoted ? line.substr(1, line.find('"', 1) - 1) : take_word(line);
}

std::string_view take_part(std::string_view& text) {
    const std::size_t end = std::min(text.find(':'), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

/// Columns of "species:S:1:pos:R:3:velo:R:3".
std::vector<WordColumn> columns_of(const Lines& lines, std::string_view properties) {
    std::vector<WordColumn> columns;
    while (!properties.empty()) {
        const std::string name(take_part(properties));
        const std::string_view type = take_part(properties);
        int count = 0;
        if (read_number(take_part(properties), count) != std::errc() || count < 1 || count > 100)
            fail(lines, "Properties=name:type:columns:...", quoted_text(name));
        for (int i = 0; i < count; ++i) {
            std::string column = name;
            if (name == "pos" && count >= 2 && count <= 3)
                column = std::string(1, "xyz"[i]);
            else if ((name == "velo" || name == "vel" || name == "velocity") && count <= 3)
                column = "v" + std::string(1, "xyz"[i]);
            else if (count > 1)
                column += "_" + std::to_string(i);
            columns.push_back({column, type == "S", std::vector<std::int64_t>()});
        }
    }
    return columns;
}

/// True where the first line is a count alone, and the second has properties or the third a word
/// and three numbers.
bool is_xyz(const fs::path& file) {
    const std::string begin = read_whole(file, 4096);
    Lines lines{file, begin};
    std::string_view first = take_line(lines);
    std::uint64_t count = 0;
    if (read_number(take_word(first), count) != std::errc() || !take_word(first).empty())
        return false;
    if (take_line(lines).find("Properties=") != std::string_view::npos)
        return true;
    std::string_view third = take_line(lines);
    double number = 0;
    if (take_word(third).empty())
        return false;
    for (int axis = 0; axis < 3; ++axis)
        if (read_number(take_word(third), number) != std::errc())
            return false;
    return take_word(third).empty();
}

/// Where each state begins, of which the last may be cut.
std::vector<Lines> states_in(Lines lines) {
    std::vector<Lines> states;
    do {
        states.push_back(lines);
        std::uint64_t left = take_count(lines, "particles") + 1; // and the line of properties
        for (; left > 0 && !lines.rest.empty(); --left)
            take_line(lines);
    } while (has_more(lines));
    return states;
}

/// Throws InputError, naming the line; memory is bounded by the file's own size.
Snapshot read_xyz(const fs::path& file, const ReadChoices& choices) {
    const std::string bytes = read_whole(file);
    const std::vector<Lines> states = states_in({file, bytes});
    const std::uint64_t frame = frame_to_read(choices, states.size());
    Lines lines = states[frame];
    const std::uint64_t count = take_count(lines, "particles");
    const std::string_view properties = value_of(take_line(lines), "Properties=");
    auto columns = columns_of(lines, properties.empty() ? "species:S:1:pos:R:3" : properties);
    if (find_column(columns, "x") == nullptr || find_column(columns, "y") == nullptr)
        fail(lines, "a property pos of 2 or 3 columns", quoted_text(properties));
    take_rows(lines, count, columns);
    Snapshot snapshot = snapshot_of(lines, std::move(columns), {"x", "y", "z"});
    note_frame(snapshot, choices, frame, states.size());
    return snapshot;
}

} // namespace

SnapshotFormat xyz_format() {
    return {"extended XYZ", is_xyz, read_xyz, true};
}

} // namespace meniscus
