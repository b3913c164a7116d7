#include "input_files.hpp"

#include <meniscus/data/formats/snapshot_formats.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <glob.h>
#include <map>
#include <optional>
#include <regex>
#include <set>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool ends_with(const std::string& text, std::string_view end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The frames that a pair of braces stands for: all, or every `step`-th from `first` to `last`.
struct Frames {
    std::uint64_t first = 0;
    std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t step = 1;

    [[nodiscard]] bool contain(const std::string& digits) const {
        if (digits.size() > 18)
            return false;
        const std::uint64_t number = std::stoull(digits);
        return number >= first && number <= last && (number - first) % step == 0;
    }
};

[[noreturn]] void refuse_braces(const std::string& pattern, const std::string& inside) {
    throw InputError(fmt::format("{}: '{{{}}}' is no range of frames; expected {{}}, {{0..99}} or "
                                 "{{0:99:10}}",
                                 pattern, inside));
}

/// Of "", "0..99", "0..99..10", "0:99" or "0:99:10".
Frames frames_of(const std::string& inside, const std::string& pattern) {
    static const std::regex form(R"((\d{1,18})(?:\.\.|:)(\d{1,18})(?:(?:\.\.|:)(\d{1,18}))?)");
    if (inside.empty())
        return {};
    std::smatch parts;
    if (!std::regex_match(inside, parts, form))
        refuse_braces(pattern, inside);
    const Frames frames{std::stoull(parts[1]), std::stoull(parts[2]),
                        parts[3].matched ? std::stoull(parts[3]) : 1};
    if (frames.step == 0 || frames.first > frames.last)
        refuse_braces(pattern, inside);
    return frames;
}

/// A pattern as what the file system is asked for, and as what tells which answers are meant.
struct Pattern {
    std::string glob;
    std::string expression;
    std::vector<Frames> frames;
};

/// Takes "[...]" at `at` over; where it does not end, the bracket stands for itself.
std::size_t add_set(const std::string& word, std::size_t at, Pattern& pattern) {
    const std::size_t end = word.find(']', at + 2);
    if (end == std::string::npos) {
        pattern.glob += "[[]";
        pattern.expression += "\\[";
        return at + 1;
    }
    std::string set = word.substr(at, end + 1 - at);
    pattern.glob += set;
    if (set[1] == '!')
        set[1] = '^';
    pattern.expression += set;
    return end + 1;
}

std::size_t add_frames(const std::string& word, std::size_t at, Pattern& pattern) {
    const std::size_t end = word.find('}', at);
    if (end == std::string::npos)
        throw InputError(fmt::format("{}: '{{' has no '}}'", word));
    pattern.frames.push_back(frames_of(word.substr(at + 1, end - at - 1), word));
    pattern.glob += "[0-9]*";
    pattern.expression += "([0-9]+)";
    return end + 1;
}

Pattern pattern_of(const std::string& word) {
    Pattern pattern;
    for (std::size_t at = 0; at < word.size();) {
        const char c = word[at];
        if (c == '[') {
            at = add_set(word, at, pattern);
            continue;
        }
        if (c == '{') {
            at = add_frames(word, at, pattern);
            continue;
        }
        pattern.glob += c;
        if (c == '*')
            pattern.expression += "[^/]*";
        else if (c == '?')
            pattern.expression += "[^/]";
        else
            pattern.expression += std::string(std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                                                      static_cast<unsigned char>(c) > 127
                                                  ? ""
                                                  : "\\") +
                                  c;
        ++at;
    }
    return pattern;
}

/// Files, not folders, that the file system finds.
std::vector<Path> found_by(const std::string& pattern) {
    glob_t found{};
    std::vector<Path> files;
    if (glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0)
        for (std::size_t f = 0; f < found.gl_pathc; ++f)
            if (!fs::is_directory(found.gl_pathv[f]))
                files.emplace_back(found.gl_pathv[f]);
    globfree(&found);
    return files;
}

bool matches(const Path& file, const std::regex& expression, const std::vector<Frames>& frames) {
    std::smatch parts;
    const std::string name = file.string();
    if (!std::regex_match(name, parts, expression))
        return false;
    for (std::size_t f = 0; f < frames.size(); ++f)
        if (!frames[f].contain(parts[f + 1]))
            return false;
    return true;
}

void sort_naturally(std::vector<Path>& files) {
    std::sort(files.begin(), files.end(),
              [](const Path& a, const Path& b) { return is_before(a.string(), b.string()); });
}

/// What `simulate` writes beside frames, and what others keep there.
bool is_no_frame(const Path& file) {
    const std::string name = file.filename().string();
    return name.front() == '.' || is_checkpoint_name(file) || ends_with(name, "_log.csv") ||
           ends_with(name, ".partial") || ends_with(name, ".series");
}

std::vector<Path> files_of_pattern(const std::string& word) {
    const Pattern pattern = pattern_of(word);
    const std::regex expression(pattern.expression);
    std::vector<Path> files = found_by(pattern.glob);
    files.erase(std::remove_if(
                    files.begin(), files.end(),
                    [&](const Path& file) { return !matches(file, expression, pattern.frames); }),
                files.end());
    if (files.empty())
        throw InputError(fmt::format("{}: no file has a name of that pattern", word));
    const auto others = std::stable_partition(files.begin(), files.end(),
                                              [](const Path& file) { return !is_no_frame(file); });
    if (others != files.begin()) // else the pattern means them
        files.erase(others, files.end());
    sort_naturally(files);
    return files;
}

bool is_snapshot(const Path& file) {
    try {
        const auto formats = snapshot_formats();
        return std::any_of(formats.begin(), formats.end(),
                           [&](const SnapshotFormat& format) { return format.detect(file); });
    } catch (const InputError&) { // an empty one, say
        return false;
    }
}

std::vector<Path> files_of_folder(const Path& folder) {
    std::map<std::string, std::vector<Path>> by_ending;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        if (entry->is_regular_file() && !is_no_frame(entry->path()) && is_snapshot(entry->path()))
            by_ending[entry->path().extension().string()].push_back(entry->path());
    if (error)
        fail_for(error.value(), fmt::format("{}: the folder cannot be read: {}", folder.string(),
                                            error.message()));
    if (by_ending.empty())
        throw InputError(fmt::format("{}: there is no snapshot in the folder itself; name the one "
                                     "that holds them",
                                     folder.string()));
    if (by_ending.size() > 1) {
        std::string kinds;
        for (const auto& [ending, files] : by_ending)
            kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", files.size(), ending);
        throw InputError(fmt::format(
            "{}: the folder holds snapshots of several kinds ({}); say which, as in '{}'",
            folder.string(), kinds, (folder / ("*" + by_ending.begin()->first)).string()));
    }
    sort_naturally(by_ending.begin()->second);
    return by_ending.begin()->second;
}

std::vector<Path> files_of(const Path& word) {
    std::error_code error;
    const fs::file_status status = fs::status(word, error);
    if (is_failure_of_machine(error.value()))
        throw FailureError(fmt::format("{}: cannot be read: {}", word.string(), error.message()));
    if (fs::is_directory(status))
        return files_of_folder(word);
    if (!fs::exists(status) && word.string().find_first_of("*?[{") != std::string::npos)
        return files_of_pattern(word.string());
    return {word};
}

} // namespace

bool is_before(const std::string& a, const std::string& b) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        if (!is_digit(a[i]) || !is_digit(b[j])) {
            if (a[i] != b[j])
                return a[i] < b[j];
            ++i;
            ++j;
            continue;
        }
        const auto number_at = [](const std::string& text, std::size_t& at) {
            while (at + 1 < text.size() && text[at] == '0' && is_digit(text[at + 1]))
                ++at;
            const std::size_t begin = at;
            while (at < text.size() && is_digit(text[at]))
                ++at;
            return text.substr(begin, at - begin);
        };
        const std::string first = number_at(a, i);
        const std::string second = number_at(b, j);
        if (first.size() != second.size())
            return first.size() < second.size();
        if (first != second)
            return first < second;
    }
    const std::size_t left_of_a = a.size() - i;
    const std::size_t left_of_b = b.size() - j;
    return left_of_a != left_of_b ? left_of_a < left_of_b : a < b; // "01" and "1" are two names
}

bool is_checkpoint_name(const Path& file) {
    return ends_with(file.stem().string(), "_checkpoint");
}

std::vector<Path> input_files(const std::vector<Path>& words) {
    std::vector<Path> files;
    std::set<Path> named;
    for (const Path& word : words)
        for (const Path& file : files_of(word)) // a series lists what stands beside it
            if (file.extension() != ".series" && named.insert(file.lexically_normal()).second)
                files.push_back(file);
    if (files.empty() && !words.empty())
        throw InputError(words.front().string() +
                         ": a series lists files for ParaView; name its folder instead");
    return files;
}

} // namespace meniscus
