#include "word_table.hpp"

#include "number_blocks.hpp"
#include <meniscus/data/text/cut_numbers.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <utility>

namespace meniscus {
namespace {

void append(const Lines& lines, WordColumn& column, std::string_view word) {
    if (column.is_text || append_word(column.values, word))
        return;
    const bool is_first = count_of(column.values) == 0;
    if (std::holds_alternative<std::vector<std::int64_t>>(column.values)) {
        column.values = as_doubles({column.name, 1, std::move(column.values)});
        if (append_word(column.values, word))
            return;
    }
    if (!is_first)
        fail(lines, "a number for " + quoted_text(column.name), quoted_text(word));
    column.is_text = true;
}

} // namespace

void fail(const Lines& lines, const std::string& expected, const std::string& found) {
    throw InputError(lines.file.string() + ": line " + std::to_string(lines.line) + ": expected " +
                     expected + ", found " + found);
}

std::string_view take_line(Lines& lines) {
    const std::size_t end = std::min(lines.rest.find('\n'), lines.rest.size());
    std::string_view line = lines.rest.substr(0, end);
    lines.rest.remove_prefix(std::min(end + 1, lines.rest.size()));
    ++lines.line;
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return line;
}

std::uint64_t take_count(Lines& lines, const std::string& of) {
    std::string_view line = take_line(lines);
    const std::string_view word = take_word(line);
    std::uint64_t count = 0;
    if (read_number(word, count) != std::errc())
        fail(lines, "a number of " + of, quoted_text(word));
    return count;
}

void take_rows(Lines& lines, std::uint64_t rows, std::vector<WordColumn>& columns) {
    if (rows > lines.rest.size() / 2 + 1)
        fail(lines, std::to_string(rows) + " particles", "fewer lines; export the file again");
    std::vector<std::string_view> last_words;
    for (std::uint64_t row = 0; row < rows; ++row) {
        const bool is_cut = lines.rest.find('\n') == std::string_view::npos;
        std::string_view line = take_line(lines);
        std::string_view word;
        for (WordColumn& column : columns) {
            word = take_word(line);
            if (word.empty())
                fail(lines, std::to_string(columns.size()) + " words", "fewer");
            append(lines, column, word);
        }
        if (!take_word(line).empty())
            fail(lines, std::to_string(columns.size()) + " words", "more");
        if (is_cut && may_be_cut(word, last_words))
            fail(lines, "a line break at the end of the last line",
                 "none; export the file again if it is cut, else add the line break");
        if (row + 20 > rows)
            last_words.push_back(word);
    }
}

bool has_more(const Lines& lines) {
    std::string_view rest = lines.rest;
    return !take_word(rest).empty();
}

const WordColumn* find_column(const std::vector<WordColumn>& columns, std::string_view name) {
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [&](const WordColumn& column) { return column.name == name; });
    return found == columns.end() ? nullptr : &*found;
}

Snapshot snapshot_of(const Lines& lines, std::vector<WordColumn> columns,
                     const std::vector<std::string>& axes) {
    Snapshot snapshot;
    std::vector<std::string> names;
    for (const WordColumn& column : columns)
        names.push_back(column.name);
    if (const auto repeated = repeated_name(names))
        fail(lines, "every column once", quoted_text(*repeated) + " twice");
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const WordColumn* column = find_column(columns, axes[axis]);
        if (column == nullptr)
            continue;
        if (column->is_text)
            fail(lines, "numbers in column " + quoted_text(column->name), "text");
        const std::vector<double> values = as_doubles({"", 1, column->values});
        snapshot.positions.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            snapshot.positions[i][axis] = values[i];
    }
    for (WordColumn& column : columns)
        if (!column.is_text && std::find(axes.begin(), axes.end(), column.name) == axes.end())
            snapshot.point_data.push_back({column.name, 1, std::move(column.values)});
    snapshot.dimension_is_stated = find_column(columns, axes.back()) == nullptr;
    snapshot.dimension = snapshot.dimension_is_stated ? 2 : dimension_of(snapshot.positions);
    return snapshot;
}

} // namespace meniscus
