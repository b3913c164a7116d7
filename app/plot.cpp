// meniscus plot: a run's log, the plane of a line's features or a table of measurements as PNG or
// SVG.
#include "command_line.hpp"
#include "input_files.hpp"
#include "shipped_models.hpp"
#include "usage.hpp"

#include <meniscus/app/picture/picture_file.hpp>
#include <meniscus/app/plot/feature_plane.hpp>
#include <meniscus/app/plot/table_chart.hpp>
#include <meniscus/data/drawing/draw_chart.hpp>
#include <meniscus/data/hdf5/hdf5_signature.hpp>
#include <meniscus/data/text/files.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace meniscus {
namespace {

struct PlotCommand {
    std::vector<Path> inputs;
    Path output;
    std::optional<std::string> model;
    std::optional<std::string> table;
    std::optional<std::string> title;
    TableChartOptions columns;
    std::string logarithmic = "none";
    int threads = 0;
    bool quiet = false;
};

/// What a log is plotted by where no column is named.
constexpr const char* columns_of_logs = "kinetic_energy,potential_energy";

/// The table that was asked for, or the only one.
const TextTable& chosen_table(const std::vector<TextTable>& tables, const PlotCommand& command) {
    std::string names;
    for (const TextTable& table : tables) {
        if (command.table ? table.name == *command.table : tables.size() == 1)
            return table;
        names += (names.empty() ? "" : ", ") + table.name;
    }
    if (command.table)
        throw InputError("no table " + quoted_text(*command.table) + "; there are " +
                         printable(names, 300));
    throw InputError("has several tables; choose one by --table: " + printable(names, 300));
}

/// The columns that were asked for, those of logs where none was.
TableChartOptions options_for(const TextTable& table, TableChartOptions options) {
    if (!table.is_log && (options.x.empty() || (options.y.empty() && options.names.empty())))
        throw InputError("say by --x and --y which columns of the table are plotted; there are " +
                         columns_text(table) + ". Without, expected the log of a run");
    if (options.x.empty())
        options.x = "time";
    if (options.y.empty() && options.names.empty())
        options.y = {columns_of_logs};
    options.is_joined = options.is_joined || table.is_log;
    return options;
}

Chart chart_of_tables(const std::vector<Path>& files, const PlotCommand& command) {
    if (command.model)
        throw InputError("--model is for labelled states, which " + files.front().string() +
                         " is not");
    Chart chart;
    for (const Path& file : files)
        naming_file(file, [&] {
            const std::vector<TextTable> tables = read_tables(file);
            const TextTable& table = chosen_table(tables, command);
            if (chart.title.empty())
                chart.title = printable(table.title, 200);
            add_table(table, options_for(table, command.columns),
                      files.size() > 1 ? printable(file.stem().string(), 200) : "", chart);
        });
    return chart;
}

Chart chart_of_states(const std::vector<Path>& files, const PlotCommand& command) {
    const TableChartOptions& columns = command.columns;
    if (command.table || !columns.x.empty() || !columns.y.empty() || !columns.series.empty() ||
        !columns.names.empty() || !columns.panel.empty() || columns.is_joined ||
        command.logarithmic != "none")
        throw InputError("--table, --x, --y, --series, --names, --panel, --joined and "
                         "--logarithmic are for logs and tables; " +
                         files.front().string() + " is a state, whose axes are the model's");
    const NamedModel model = command.model ? named_model(*command.model)
                                           : model_that_fits(read_labelled_state(files[0], ""));
    Chart chart = feature_planes(model.model, files, command.threads);
    chart.title = printable(files.size() == 1 ? files[0].stem().string()
                                              : fmt::format("{} states", files.size()),
                            200) +
                  ", model " + printable(model.name, 200);
    return chart;
}

bool has_points(const Chart& chart) {
    for (const ChartPanel& panel : chart.panels)
        for (const ChartSeries& series : panel.series)
            if (!series.points.empty() && series.mark != Mark::line)
                return true;
    return false;
}

Chart chart_of(const std::vector<Path>& files, const PlotCommand& command) {
    const auto is_state = [](const Path& file) { return is_hdf5(file); };
    const auto states = std::count_if(files.begin(), files.end(), is_state);
    if (states != 0 && states != static_cast<std::ptrdiff_t>(files.size()))
        throw InputError(files.front().string() +
                         ": states and tables cannot be in one plot; give files of one kind");
    Chart chart = states != 0 ? chart_of_states(files, command) : chart_of_tables(files, command);
    if (!has_points(chart))
        throw InputError(files.front().string() + ": there is nothing to plot: no row has both "
                                                  "figures, or no particle a neighbor");
    if (command.title)
        chart.title = printable(*command.title, 200);
    return chart;
}

void run_plot(PlotCommand command) {
    check_picture_name(command.output);
    check_can_be_written(command.output);
    command.columns.is_logarithmic_x = command.logarithmic.find('x') != std::string::npos;
    command.columns.is_logarithmic_y = command.logarithmic.find('y') != std::string::npos;
    const std::vector<Path> files = input_files(command.inputs);
    check_is_not_an_input(command.output, files);
    const Drawing drawing = draw_chart(chart_of(files, command));
    const WriteGuard guard;
    write_whole(command.output, picture_bytes(drawing, command.output));
    if (!command.quiet)
        print_text(fmt::format("{}\n", printable(command.output.string())));
}

void add_table_options(PlotCommand& options, CLI::App& verb) {
    TableChartOptions& columns = options.columns;
    verb.add_option("--table", options.table,
                    "Of a file with several tables, the one of this name (in Markdown: number)");
    verb.add_option("--x", columns.x, "Column along the plot (default: a log's time)");
    verb.add_option("--y", columns.y,
                    fmt::format("Column upward, or several with commas between; once more for a "
                                "further panel (a log's default: {}; without, but with --names: "
                                "rows below each other)",
                                columns_of_logs))
        ->allow_extra_args(false);
    verb.add_option("--series", columns.series, "Column of texts: rows of one text share a color");
    verb.add_option("--names", columns.names, "Column of texts that stand at the points");
    verb.add_option("--panel", columns.panel, "Column of texts: a panel for each of them");
    verb.add_option("--logarithmic", options.logarithmic, "Which axes are: none, x, y or xy")
        ->check(CLI::IsMember({"none", "x", "y", "xy"}))
        ->capture_default_str();
    verb.add_flag("--joined", columns.is_joined,
                  "Lines through the rows of a series, as logs have them");
}

} // namespace

void add_plot(CLI::App& command) {
    auto options = std::make_shared<PlotCommand>();
    auto* verb = command.add_subcommand(
        "plot", "Plot a run's log, the plane of a line's features, or a table of meniscus bench");
    verb->add_option("INPUT", options->inputs,
                     fmt::format("Logs of `meniscus simulate`, labelled snapshots, or tables "
                                 "(Markdown or JSON): {}",
                                 input_kinds))
        ->required();
    verb->add_option("-o,--output", options->output, "Plot to write, .png or .svg")->required();
    verb->add_option("--model", options->model,
                     "For labelled snapshots: model file, or the name of one that ships (default: "
                     "of these the one that fits the first snapshot)")
        ->type_name("FILE");
    add_table_options(*options, *verb);
    verb->add_option("--title", options->title, "Words above");
    add_threads_option(*verb, options->threads);
    add_quiet_option(*verb, options->quiet);
    add_examples(*verb, {{"meniscus plot frames/dam_log.csv -o log.svg --y steps --y max_speed",
                          "two columns of a run's log over time"},
                         {"meniscus plot labelled/ -o plane.svg --model model.json",
                          "particles in the plane of the model's features, with its line"},
                         {"meniscus plot detectors_3d.md -o speed.svg --x 'ns a particle, 1 "
                          "thread' --y 'false positives, %' --names detector --logarithmic xy",
                          "a table of meniscus bench"}});
    verb->callback([options] { run_plot(*options); });
}

} // namespace meniscus
