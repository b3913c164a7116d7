// meniscus study: runs what this project does beside published or exact figures (validation/), or
// prints what was committed.
#include "input_files.hpp"
#include "shipped_files.hpp"
#include "usage.hpp"

#include <meniscus/app/picture/draw_particles.hpp>
#include <meniscus/app/picture/picture_file.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>

#include "framework/run_study.hpp"
#include "framework/run_tables.hpp"
#include "studies.hpp"
#include "support/plot.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <memory>

namespace meniscus {
namespace {

struct StudyCommand {
    std::vector<std::string> names;
    bool all = false;
    bool list = false;
    Path folder = "meniscus-study";
    std::string size = "small";
    int threads = 0;
    Path plots;          ///< folder that those of a committed result are drawn into; empty: none
    bool show = false;   ///< the committed result, in place of a run
    bool check = false;  ///< holds the result against the committed one
    bool record = false; ///< commits the result
    bool keep_frames = false;
    bool quiet = false;
};

Json read_json(const Path& file, const char* what) {
    return parse_json(text_of_file(file, what), file.string(), what);
}

Path committed_file(const Study& study, const std::string& size) {
    return shipped_studies() / study.name / (size + ".json");
}

/// Throws InputError where the size was never committed.
Json committed_result(const Study& study, const std::string& size) {
    const Path file = committed_file(study, size);
    if (!std::filesystem::exists(file))
        throw InputError(fmt::format("study {} has no committed result of size '{}'; leave --show "
                                     "and --check out to run it",
                                     study.name, size));
    return read_json(file, "a result (JSON)");
}

void draw_plots(const std::vector<Table>& tables, const Path& folder) {
    for (const Table& table : tables)
        for (const Plot& plot : table.plots)
            draw(table, plot, folder);
}

/// Those of the tables, and those that belong to none.
void draw_all(const Study& study, const std::vector<Table>& tables, const Json& result,
              const Path& folder) {
    draw_plots(tables, folder);
    if (study.plots != nullptr)
        draw_plots(study.plots(result), folder);
}

/// Prints the tables, and returns them.
std::vector<Table> print_tables(const Study& study, const StudyCommand& command, const Json& result,
                                std::string& text) {
    const Json reference =
        read_json(shipped_studies() / study.name / "reference.json", "a reference (JSON)");
    const std::vector<Table> tables = study.tables(result, reference);
    text = what_ran(result);
    for (const Table& table : tables)
        text += "\n" + table.before + markdown(table) + table.after;
    if (!command.quiet)
        print_text(text);
    return tables;
}

void show(const Study& study, const StudyCommand& command) {
    const Json result = committed_result(study, command.size);
    std::string text;
    const std::vector<Table> tables = print_tables(study, command, result, text);
    if (!command.plots.empty())
        draw_all(study, tables, result, command.plots);
}

/// What --check found: figures that differ, which it prints.
std::size_t differing(const Study& study, const StudyPlan& plan, const Json& result,
                      const StudyCommand& command) {
    const auto lines = differences(result, committed_result(study, command.size), plan);
    for (const std::string& line : lines)
        print_error_line(fmt::format("study {}: {}", study.name, line));
    return lines.size();
}

/// A state by the speed of its particles; walls would hide it.
void draw_state(const Path& frame, const Path& picture, const std::string& title) {
    const Snapshot snapshot = read_vtkhdf(frame);
    PictureOptions options;
    options.width = 900;
    options.height = 600;
    options.diameter = snapshot.particle_spacing.value();
    options.title = title;
    const Image image = draw_particles(snapshot, coloring_of(snapshot, "velocity", {}), options);
    write_whole(picture, picture_bytes(image, picture));
}

StudyOptions options_of(const Study& study, const StudyCommand& command) {
    StudyOptions options;
    options.work = command.folder / fmt::format("{}_{}", study.name, command.size);
    options.size = command.size;
    options.threads = command.threads;
    options.keep_frames = command.keep_frames;
    options.stop = interrupt_is_waiting;
    options.on_run = [&study, quiet = command.quiet](const StudyRun& run, std::size_t number,
                                                     std::size_t all) {
        if (!quiet)
            fmt::print(stderr, "study {}: {} / {}: {}\n", study.name, number, all, run.name);
    };
    options.draw = draw_state;
    make_writable_folder(options.work);
    return options;
}

/// Of the runs, as Markdown of a page beside the work folder.
std::string pictures_in(const StudyPlan& plan, const Path& work) {
    std::string text;
    for (const StudyRun& run : plan.runs)
        if (const Path picture = picture_file(run, work); std::filesystem::exists(picture))
            text += fmt::format("\n![{}]({})\n", run.name,
                                (work.filename() / picture.filename()).string());
    return text;
}

/// How many figures differ from the committed ones, where that is asked for.
std::size_t run(const Study& study, const StudyCommand& command) {
    const StudyPlan plan =
        read_plan(shipped_studies() / study.name, command.size, shipped_scenes());
    const StudyOptions options = options_of(study, command);
    // An interrupt waits for the step, and for the checkpoint after it.
    const WriteGuard guard;
    Json result;
    try {
        result = run_study(study, plan, options);
    } catch (const Stopped&) { // the guard then ends the program
        print_error_line(
            fmt::format("study {}: stopped; the same command goes on from here", study.name));
        return 0;
    }
    const std::string text = result.dump(1) + "\n";
    write_whole(options.work.string() + ".json", text);
    if (command.record)
        write_whole(committed_file(study, command.size), text);
    std::string page;
    const std::vector<Table> tables = print_tables(study, command, result, page);
    draw_all(study, tables, result, command.folder);
    write_whole(options.work.string() + ".md", page + pictures_in(plan, options.work));
    return command.check ? differing(study, plan, result, command) : 0;
}

/// "16 runs, 12 min": of a committed result, else the number of runs alone.
std::string extent_of(const Study& study, const std::string& size) {
    const std::size_t runs =
        read_plan(shipped_studies() / study.name, size, shipped_scenes()).runs.size();
    if (!std::filesystem::exists(committed_file(study, size)))
        return fmt::format("{} runs, has no result yet", runs);
    const Json result = committed_result(study, size);
    double particles = 0;
    for (const Json& one : result.at("runs"))
        particles = std::max(particles, figure_of(one, "particles").value_or(0));
    const double minutes = 60 * result.at("hours").get<double>();
    return fmt::format("{} runs, {:.{}f} min on {} threads{}", runs, minutes, minutes < 10 ? 1 : 0,
                       result.at("threads").get<int>(),
                       particles > 0 ? fmt::format(", up to {:.0f} particles", particles) : "");
}

void list_studies() {
    for (const Study& study : all_studies())
        print_text(fmt::format("{}\n    {}\n    small: {}\n    paper: {}\n", study.name,
                               wrapped(study.help, 4, 100), extent_of(study, "small"),
                               extent_of(study, "paper")));
}

std::vector<std::string> study_names() {
    std::vector<std::string> names;
    for (const Study& study : all_studies())
        names.emplace_back(study.name);
    return names;
}

void run_study_verb(const StudyCommand& command) {
    if (command.list) {
        list_studies();
        return;
    }
    if (command.names.empty() && !command.all)
        throw InputError("study: expected the name of a study, --all or --list");
    std::size_t differ = 0;
    for (const Study& study : all_studies()) {
        const bool named = std::find(command.names.begin(), command.names.end(), study.name) !=
                           command.names.end();
        if (!named && !command.all)
            continue;
        if (command.show)
            show(study, command);
        else
            differ += run(study, command);
    }
    if (differ > 0)
        throw LimitExceeded(fmt::format(
            "{} figures differ from the committed ones by more than study.json allows", differ));
}

} // namespace

void add_study(CLI::App& command) {
    auto options = std::make_shared<StudyCommand>();
    auto* verb = command.add_subcommand(
        "study", "Run what others have published or what is known exactly, and print both: tables "
                 "as DIR/*.md, plots as DIR/*.svg, figures as DIR/*.json. The same command goes on "
                 "where it was ended");
    verb->add_option("STUDY", options->names, "Names, which --list explains")
        ->check(CLI::IsMember(study_names()));
    verb->add_flag("--all", options->all, "All studies, one after the other");
    auto* lists = verb->add_flag(
        "--list", options->list,
        "Say what each study does and how large it is; minutes are those of the committed result");
    verb->add_option("-o,--output", options->folder, "Folder of runs and results")
        ->type_name("DIR")
        ->capture_default_str();
    verb->add_option("--size", options->size, "small takes minutes, paper hours")
        ->check(CLI::IsMember({"small", "paper"}))
        ->capture_default_str();
    auto* shows =
        verb->add_flag("--show", options->show, "Print the committed result; run nothing");
    verb->add_option("--plots", options->plots, "Existing folder to draw its plots into")
        ->check(CLI::ExistingDirectory)
        ->needs(shows);
    auto* checks = verb->add_flag("--check", options->check,
                                  "Exit with 1 where the result differs from the committed one");
    auto* records = verb->add_flag("--record", options->record,
                                   "Make the result the committed one (in the source tree)");
    verb->add_flag("--keep-frames", options->keep_frames, "Keep the frames of all runs");
    shows->excludes(checks)->excludes(records)->excludes(lists);
    checks->excludes(records);
    add_threads_option(*verb, options->threads);
    add_quiet_option(*verb, options->quiet);
    add_examples(
        *verb, {{"meniscus study thin_shells", "its small size, into ./meniscus-study"},
                {"meniscus study drop_formation --show", "the result that comes with the program"},
                {"meniscus study --all --check -o DIR", "all small sizes, held against those"}});
    verb->callback([options] { run_study_verb(*options); });
}

} // namespace meniscus
