#include "plot.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/printable.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
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

// In the folder that gnuplot runs in.
constexpr const char* script_name = "script";
constexpr const char* plot_name = "plot.svg";

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

/// A text in one line between single quotes, as gnuplot has it.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : printable(text))
        result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

/// The same between double quotes in a block of data, where gnuplot knows no quote inside.
std::string data_label(const std::string& text) {
    std::string result = "\"";
    for (const char c : printable(text))
        result += c == '"' ? "''" : c == '\\' ? "\\\\" : std::string(1, c);
    return result + "\"";
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
            lines += fmt::format("{} {} {}\n", x.place(point.x), y.place(point.y),
                                 data_label(point.label));
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

std::string script_of(const Table& table, const Plot& plot, const std::vector<Panel>& panels) {
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
        panels.size() < 2 ? 860 : 560 * panels.size(), quoted(plot_name));
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

/// Runs gnuplot in a folder with one argument; true where it succeeds.
bool run_gnuplot(const std::filesystem::path& folder, std::string argument) {
    std::string program = "gnuplot";
    char* arguments[] = {program.data(), argument.data(), nullptr};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    int status = 0;
    const bool runs =
        posix_spawnp(&process, arguments[0], &files, nullptr, arguments, environ) == 0 &&
        waitpid(process, &status, 0) == process && status == 0;
    posix_spawn_file_actions_destroy(&files);
    return runs;
}

/// A new folder inside another one, under a name that nobody foresees; removed with what is in it.
class WorkFolder {
public:
    explicit WorkFolder(const std::filesystem::path& parent) : name(parent / "plot-XXXXXX") {
        if (mkdtemp(name.data()) == nullptr)
            throw FailureError(parent.string() +
                               ": no folder can be made in it: " + std::strerror(errno));
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    ~WorkFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(name, ignored);
    }

    [[nodiscard]] std::filesystem::path path() const { return name; }

private:
    std::string name;
};

} // namespace

void require_gnuplot() {
    if (!run_gnuplot(".", "--version"))
        throw FailureError("plots need gnuplot, which cannot be run here: install it (Debian's "
                           "package gnuplot-nox)");
}

void draw(const Table& table, const Plot& plot, const std::filesystem::path& folder) {
    const auto panels = panels_of(table, plot);
    if (panels.empty())
        return;
    const std::filesystem::path file = folder / plot.file;
    const WorkFolder work(folder);
    write_whole(work.path() / script_name, script_of(table, plot, panels));
    std::error_code failure;
    if (run_gnuplot(work.path(), script_name))
        std::filesystem::rename(work.path() / plot_name, file, failure);
    else
        failure = std::make_error_code(std::errc::io_error);
    if (failure)
        throw FailureError(file.string() + ": could not be drawn (" + failure.message() +
                           "); gnuplot says why above, or the folder cannot be written to");
}

} // namespace meniscus
