#include "plot.hpp"

#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cmath>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace meniscus {
namespace {

/// Of series, in their order; after the last they begin again. Okabe and Ito's for the color-blind,
/// without the yellow that is lost on white.
constexpr const char* colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                  "#56b4e9", "#e69f00", "#000000", "#999999"};

struct Point {
    double x, y;
    std::string label;
    bool is_best;
};

/// Points by panel and series, both in the order of the table.
struct Series {
    std::string name;
    std::vector<Point> points;
};
struct Panel {
    std::string name;
    std::vector<Series> series;
};

std::string text_of(const Table& table, const std::vector<Cell>& row, const std::string& key) {
    return key.empty() ? "" : std::get<std::string>(row[table.column(key)]);
}

/// The entry of that name, added where there is none.
template <class Named>
Named& entry(std::vector<Named>& all, const std::string& name) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
    if (found != all.end())
        return *found;
    all.push_back({name, {}});
    return all.back();
}

std::vector<Panel> panels_of(const Table& table, const Plot& plot) {
    const bool has_best = table.columns.back().key == "best";
    std::vector<Panel> panels;
    for (const auto& row : table.rows) {
        const auto x = figure(row[table.column(plot.x)]);
        const auto y = figure(row[table.column(plot.y)]);
        if (!x || !y)
            continue;
        auto& series = entry(entry(panels, text_of(table, row, plot.panel)).series,
                             text_of(table, row, plot.series));
        series.points.push_back({*x, *y, text_of(table, row, plot.label),
                                 has_best && text_of(table, row, "best") == "yes"});
    }
    return panels;
}

std::vector<double> values_of(const std::vector<Panel>& panels, double Point::*coordinate) {
    std::vector<double> values;
    for (const Panel& panel : panels)
        for (const Series& series : panel.series)
            for (const Point& point : series.points)
                values.push_back(point.*coordinate);
    return values;
}

/// A text between single quotes, as gnuplot has it.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

/// How one axis is drawn.
struct Axis {
    std::string script;
    std::optional<double> zero; ///< where zeros stand on a logarithmic axis

    [[nodiscard]] double place(double value) const { return value <= 0 && zero ? *zero : value; }
};

Axis axis(const char* name, const std::string& heading, bool logarithmic,
          const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    double min = HUGE_VAL;
    for (const double value : values)
        if (value > 0)
            min = std::min(min, value);
    Axis result{fmt::format("set {}label {}\n", name, quoted(heading)), std::nullopt};
    if (logarithmic)
        result.script += fmt::format("set logscale {}\nset format {} '%g'\n", name, name);
    if (logarithmic && *low <= 0) {
        result.zero = min == HUGE_VAL ? 1 : std::pow(10, std::floor(std::log10(min)) - 1);
        result.script += fmt::format("set {}tics add ('0' {})\n", name, *result.zero);
    }
    if (*low == *high) // gnuplot finds no range itself
        result.script += fmt::format("set {}range [{}:{}]\n", name,
                                     logarithmic ? result.place(*low) / 10 : *low - 1,
                                     logarithmic ? result.place(*low) * 10 : *low + 1);
    return result;
}

std::string point_lines(const Series& series, const Axis& x, const Axis& y, bool best) {
    std::string lines;
    for (const Point& point : series.points)
        if (point.is_best || !best)
            lines += fmt::format("{} {} \"{}\"\n", x.place(point.x), y.place(point.y), point.label);
    return lines;
}

std::string panel_script(const Panel& panel, const Plot& plot, const Axis& x, const Axis& y) {
    std::string data;
    std::string command;
    for (std::size_t k = 0; k < panel.series.size(); ++k) {
        const Series& series = panel.series[k];
        data += fmt::format("$all{} << END\n{}END\n", k, point_lines(series, x, y, false));
        const std::string best = point_lines(series, x, y, true);
        const std::string color = fmt::format("lc {}", k + 1);
        command += fmt::format("{} $all{} using 1:2 with {} {} pt 6 ps 0.8 title {}",
                               k == 0 ? "plot" : ",", k, plot.joined ? "linespoints" : "points",
                               color, quoted(series.name));
        if (!best.empty()) {
            data += fmt::format("$best{} << END\n{}END\n", k, best);
            command +=
                fmt::format(", $best{} using 1:2 with points {} pt 7 ps 0.8 notitle", k, color);
        }
        if (!plot.label.empty())
            command += fmt::format(", $all{} using 1:2:3 with labels left offset 0.6,0.3 font "
                                   "',9' tc lt {} notitle",
                                   k, k + 1);
    }
    return data + fmt::format("set title {}\n", quoted(panel.name)) + command + "\n";
}

std::string script_of(const Table& table, const Plot& plot, const std::vector<Panel>& panels,
                      const std::string& output) {
    const auto axis_of = [&](const char* name, const std::string& key, bool logarithmic,
                             double Point::*coordinate) {
        return axis(name, table.columns[table.column(key)].heading, logarithmic,
                    values_of(panels, coordinate));
    };
    const Axis x = axis_of("x", plot.x, plot.logarithmic_x, &Point::x);
    const Axis y = axis_of("y", plot.y, plot.logarithmic_y, &Point::y);
    std::string script = fmt::format(
        "set terminal svg size {},560 noenhanced font 'sans-serif,12' background rgb 'white'\n"
        "set output {}\nset grid\nset key below maxrows 4\n",
        panels.size() < 2 ? 860 : 560 * panels.size(), quoted(output));
    for (std::size_t k = 0; k < std::size(colors); ++k)
        script += fmt::format("set linetype {} lc rgb '{}'\n", k + 1, colors[k]);
    script += x.script + y.script;
    script += "set offsets graph 0.02, graph 0.05, graph 0.05, graph 0.05\n";
    script +=
        fmt::format("set multiplot layout 1,{} title {}\n", panels.size(), quoted(plot.title));
    for (const Panel& panel : panels)
        script += panel_script(panel, plot, x, y);
    return script + "unset multiplot\nset output\n";
}

/// Runs gnuplot with one argument; true where it succeeds.
bool run_gnuplot(std::string argument) {
    std::string program = "gnuplot";
    char* arguments[] = {program.data(), argument.data(), nullptr};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    int status = 0;
    const bool runs =
        posix_spawnp(&process, arguments[0], &files, nullptr, arguments, environ) == 0 &&
        waitpid(process, &status, 0) == process && status == 0;
    posix_spawn_file_actions_destroy(&files);
    return runs;
}

/// Writes a script, runs it, and takes it away again.
bool draw_by_script(const std::string& script, const std::filesystem::path& file) {
    std::ofstream(file) << script;
    const bool is_drawn = run_gnuplot(file.string());
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return is_drawn;
}

} // namespace

void require_gnuplot() {
    if (!run_gnuplot("--version"))
        throw FailureError("plots need gnuplot, which cannot be run here: install it (Debian's "
                           "package gnuplot-nox)");
}

void draw(const Table& table, const Plot& plot, const std::filesystem::path& folder) {
    const auto panels = panels_of(table, plot);
    if (panels.empty())
        return;
    const std::filesystem::path file = folder / plot.file;
    const std::filesystem::path partial = file.string() + ".partial";
    const std::string script = script_of(table, plot, panels, partial.string());
    std::error_code failure;
    if (draw_by_script(script, file.string() + ".gnuplot"))
        std::filesystem::rename(partial, file, failure);
    else
        failure = std::make_error_code(std::errc::io_error);
    if (!failure)
        return;
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw FailureError(file.string() + ": could not be drawn (" + failure.message() +
                       "); gnuplot says why above, or the folder cannot be written to");
}

} // namespace meniscus
