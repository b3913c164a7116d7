// LAMMPS's text dumps ("ITEM: TIMESTEP ..." for each state): positions x, y, z, unwrapped (xu, yu,
// zu) or in fractions of the box (xs, ys, zs). A box that is periodic ("pp") goes to provenance.
#include "snapshot_formats.hpp"

#include "detail/frames.hpp"
#include "detail/number_blocks.hpp"
#include "detail/word_table.hpp"
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "ITEM: TIMESTEP";

struct Box {
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    std::array<bool, 3> is_periodic{};
    bool is_tilted = false;
};

/// "pp pp ff" behind BOX BOUNDS, where tilted boxes have "xy xz yz" first, and a line an axis.
Box take_box(Lines& lines, std::string_view header) {
    Box box;
    std::string_view word = take_word(header);
    for (; word == "xy" || word == "xz" || word == "yz" || word == "abc"; word = take_word(header))
        box.is_tilted = true;
    for (std::size_t axis = 0; axis < 3; ++axis, word = take_word(header)) {
        box.is_periodic[axis] = word == "pp";
        std::string_view line = take_line(lines);
        if (read_number(take_word(line), box.low[axis]) != std::errc() ||
            read_number(take_word(line), box.high[axis]) != std::errc())
            fail(lines, "two bounds of the box", "none");
    }
    return box;
}

std::vector<WordColumn> columns_of(std::string_view header) {
    std::vector<WordColumn> columns;
    for (auto name = take_word(header); !name.empty(); name = take_word(header))
        columns.push_back({std::string(name), false, std::vector<std::int64_t>()});
    return columns;
}

std::vector<std::string> axes_of(const Lines& lines, const std::vector<WordColumn>& columns) {
    for (const char* kind : {"", "u", "s", "su"}) {
        std::vector<std::string> axes;
        for (const char* axis : {"x", "y", "z"})
            axes.push_back(axis + std::string(kind));
        if (find_column(columns, axes[0]) != nullptr && find_column(columns, axes[1]) != nullptr)
            return axes;
    }
    fail(lines, "columns x, y and z of the positions", "none");
}

void unscale(const Lines& lines, Snapshot& snapshot, const Box& box) {
    if (box.is_tilted)
        fail(lines, "positions x, y, z in a tilted box", "fractions of it; dump x y z");
    for (auto& position : snapshot.positions)
        for (std::size_t axis = 0; axis < 3; ++axis)
            position[axis] = box.low[axis] + position[axis] * (box.high[axis] - box.low[axis]);
}

std::string words_of(const Box& box) {
    std::string words;
    for (std::size_t axis = 0; axis < 3 && !box.is_tilted; ++axis)
        if (box.is_periodic[axis] && box.high[axis] > box.low[axis])
            words += (words.empty() ? "" : ",") + std::string(1, "xyz"[axis]) + "=" +
                     number_text(box.low[axis]) + ":" + number_text(box.high[axis]);
    return words;
}

bool is_lammps(const fs::path& file) {
    return read_whole(file, first_line.size()) == first_line;
}

/// The states of a dump, one behind the other.
std::vector<Lines> states_in(Lines lines) {
    std::vector<Lines> states;
    while (!lines.rest.empty()) {
        const Lines before = lines;
        if (take_line(lines) == first_line || states.empty()) {
            if (!states.empty())
                states.back().rest.remove_suffix(before.rest.size());
            states.push_back(before);
        }
    }
    return states;
}

/// The one state of these lines.
Snapshot read_state(Lines lines) {
    Box box;
    std::optional<std::uint64_t> count;
    std::optional<double> time;
    while (!lines.rest.empty()) {
        std::string_view header = take_line(lines);
        const std::string_view item = take_word(header);
        const std::string_view kind = take_word(header);
        if (item != "ITEM:")
            fail(lines, "ITEM: and its kind", quoted_text(item));
        if (kind == "NUMBER") {
            count = take_count(lines, "atoms");
        } else if (kind == "TIME") {
            std::string_view line = take_line(lines);
            double value = 0;
            if (read_number(take_word(line), value) == std::errc())
                time = value;
        } else if (kind == "BOX") {
            take_word(header); // BOUNDS
            box = take_box(lines, header);
        } else if (kind == "ATOMS") {
            auto columns = columns_of(header);
            const auto axes = axes_of(lines, columns);
            take_rows(lines, count.value_or(0), columns);
            if (has_more(lines))
                fail(lines, "the next ITEM: TIMESTEP, or the end, behind the atoms", "more lines");
            Snapshot snapshot = snapshot_of(lines, std::move(columns), axes);
            if (axes[0] == "xs" || axes[0] == "xsu")
                unscale(lines, snapshot, box);
            snapshot.time = time;
            if (const std::string words = words_of(box); !words.empty())
                snapshot.provenance["periodic"] = words;
            return snapshot;
        } else {
            take_line(lines);
        }
    }
    fail(lines, "ITEM: ATOMS", "the end of the state; dump it again");
}

/// Throws InputError, naming the line; memory is bounded by the file's own size.
Snapshot read_lammps(const fs::path& file, const ReadChoices& choices) {
    const std::string bytes = read_whole(file);
    const std::vector<Lines> states = states_in({file, bytes});
    const std::uint64_t frame = frame_to_read(choices, states.size());
    Snapshot snapshot = read_state(states[frame]);
    note_frame(snapshot, choices, frame, states.size());
    return snapshot;
}

} // namespace

SnapshotFormat lammps_format() {
    return {"LAMMPS dump", is_lammps, read_lammps, true};
}

} // namespace meniscus
