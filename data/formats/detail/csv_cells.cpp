#include "csv_cells.hpp"

#include <meniscus/data/text/cut_numbers.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <utility>

namespace meniscus::csv {

namespace {

std::string_view without_spaces_before(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// What stands between quotes at the front of the text, which is shortened past them; none where
/// they are not closed. Quotes within are doubled, and stay so.
std::optional<std::string_view> take_quoted(std::string_view& text) {
    std::size_t end = text.find('"', 1);
    while (end != std::string_view::npos && text.substr(end + 1, 1) == "\"")
        end = text.find('"', end + 2);
    if (end == std::string_view::npos)
        return std::nullopt;
    const std::string_view inside = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    return inside;
}

} // namespace

std::string_view without_spaces_behind(std::string_view text) {
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

void fail(const Source& source, const std::string& column, const std::string& expected,
          const std::string& found) {
    throw InputError(source.file.string() + ": line " + std::to_string(source.line) +
                     (column.empty() ? "" : ", column " + quoted_text(column)) + ": expected " +
                     expected + ", found " + found);
}

Source source_of(const std::filesystem::path& file, std::string_view bytes) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return {file, bytes.substr(bytes.substr(0, mark.size()) == mark ? mark.size() : 0)};
}

std::string_view take_line(Source& source) {
    const std::size_t end = std::min(source.rest.find('\n'), source.rest.size());
    std::string_view line = source.rest.substr(0, end);
    source.rest.remove_prefix(std::min(end + 1, source.rest.size()));
    ++source.line;
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return without_spaces_before(without_spaces_behind(line));
}

std::optional<std::string_view> take_cell(Cells& cells) {
    std::optional<std::string_view> cell;
    std::string_view rest = without_spaces_before(cells.rest);
    if (!rest.empty() && rest.front() == '"') {
        cell = take_quoted(rest);
        rest = without_spaces_before(rest);
        if (!cell || !(rest.empty() || rest.front() == cells.separator))
            return std::nullopt;
    } else {
        const std::size_t end = std::min(rest.find(cells.separator), rest.size());
        cell = without_spaces_behind(rest.substr(0, end));
        rest.remove_prefix(end);
    }
    cells.more = !rest.empty();
    cells.rest = rest.substr(cells.more ? 1 : 0);
    return cell;
}

std::vector<std::string> names_of(std::string_view line, char separator) {
    std::vector<std::string> names;
    for (Cells cells{line, separator}; cells.more;) {
        const auto cell = take_cell(cells);
        if (!cell)
            return {};
        std::string name;
        for (std::size_t i = 0; i < cell->size(); ++i) {
            name += (*cell)[i];
            i += cell->substr(i, 2) == "\"\"" ? 1 : 0;
        }
        names.push_back(std::move(name));
    }
    return names;
}

namespace {

/// The last cell of a line; empty where it is none.
std::string_view last_cell(std::string_view line, char separator) {
    Cells cells{line, separator};
    std::optional<std::string_view> cell;
    while (cells.more && (cell = take_cell(cells))) {
    }
    return cell.value_or("");
}

/// Where the last line has all its cells and the last of them its digits, as the lines before show,
/// nothing is cut.
bool is_whole(std::string_view text, char separator) {
    std::vector<std::string_view> last_cells;
    for (int lines = 0; lines < 20 && !text.empty(); ++lines) {
        const std::size_t begin = text.find_last_of('\n') + 1;
        std::string_view line = text.substr(begin);
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
        last_cells.insert(last_cells.begin(), last_cell(line, separator));
        text = text.substr(0, begin == 0 ? 0 : begin - 1);
    }
    if (last_cells.size() < 4)
        return false;
    const std::string_view last = last_cells.back();
    last_cells.pop_back();
    last_cells.erase(last_cells.begin()); // which may be the header's
    return !last.empty() && !may_be_cut(last, last_cells);
}

} // namespace

void check_end(Source source, char separator) {
    const std::size_t last = source.rest.find_last_of('\n') + 1;
    if (source.rest.find_first_not_of(" \r", last) != std::string_view::npos &&
        !is_whole(source.rest, separator)) {
        source.line +=
            static_cast<std::size_t>(std::count(source.rest.begin(), source.rest.end(), '\n') + 1);
        fail(source, "", "a line break at its end",
             "none; export the file again if it is cut, else add the line break");
    }
}

} // namespace meniscus::csv
