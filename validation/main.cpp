// meniscus_study NAME: runs a study of validation/, or prints its committed results.
#include "framework/run_study.hpp"
#include "framework/run_tables.hpp"
#include "studies.hpp"
#include "support/plot.hpp"

#include <meniscus/app/threads.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>

namespace meniscus {
namespace {

using Path = std::filesystem::path;

const Path studies_folder = MENISCUS_VALIDATION;

struct StudyCommand {
    Path folder = "meniscus-study";
    std::string size = "small";
    int threads = 0;
    Path plots;          ///< folder that those of a committed result are drawn into; empty: none
    bool show = false;   ///< the committed result, in place of a run
    bool check = false;  ///< holds the result against the committed one
    bool record = false; ///< commits the result
    bool keep_frames = false;
};

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*signal*/) {
    interrupted = 1;
}

Json read_json(const Path& file, const char* what) {
    return parse_json(text_of_file(file, what), file.string(), what);
}

Path committed_file(const Study& study, const std::string& size) {
    return studies_folder / study.name / (size + ".json");
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

/// Prints the tables, which it returns, and writes them where a folder is given.
std::vector<Table> print_tables(const Study& study, const Json& result, const Path& folder) {
    const Json reference =
        read_json(studies_folder / study.name / "reference.json", "a reference (JSON)");
    const std::vector<Table> tables = study.tables(result, reference);
    std::string text = what_ran(result);
    for (const Table& table : tables)
        text += "\n" + table.before + markdown(table) + table.after;
    fmt::print("{}", text);
    if (!folder.empty())
        write_whole(folder /
                        fmt::format("{}_{}.md", study.name, result.at("size").get<std::string>()),
                    text);
    return tables;
}

void show(const Study& study, const StudyCommand& command) {
    const Json result = read_json(committed_file(study, command.size), "a result (JSON)");
    const std::vector<Table> tables = print_tables(study, result, {});
    if (!command.plots.empty())
        draw_all(study, tables, result, command.plots);
}

/// Exit status.
int check(const Study& study, const StudyPlan& plan, const Json& result,
          const StudyCommand& command) {
    const auto lines = differences(
        result, read_json(committed_file(study, command.size), "a result (JSON)"), plan);
    for (const std::string& line : lines)
        fmt::print(stderr, "meniscus_study: {}: {}\n", study.name, line);
    return lines.empty() ? 0 : 1;
}

StudyOptions options_of(const Study& study, const StudyCommand& command) {
    StudyOptions options;
    options.work = command.folder / fmt::format("{}_{}", study.name, command.size);
    options.size = command.size;
    options.threads = command.threads;
    options.keep_frames = command.keep_frames;
    options.stop = [] { return interrupted != 0; };
    options.on_run = [](const StudyRun& run, std::size_t number, std::size_t all) {
        fmt::print(stderr, "{} / {}: {}\n", number, all, run.name);
    };
    std::error_code error;
    std::filesystem::create_directories(options.work, error);
    if (error)
        throw InputError(options.work.string() + ": cannot be made (" + error.message() +
                         "); choose another folder with -o");
    return options;
}

int run(const Study& study, const StudyCommand& command) {
    if (command.show) {
        show(study, command);
        return 0;
    }
    const StudyPlan plan = read_plan(studies_folder / study.name, command.size);
    const StudyOptions options = options_of(study, command);
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    const Json result = run_study(study, plan, options);
    const std::string text = result.dump(1) + "\n";
    write_whole(options.work.string() + ".json", text);
    if (command.record)
        write_whole(committed_file(study, command.size), text);
    draw_all(study, print_tables(study, result, command.folder), result, command.folder);
    return command.check ? check(study, plan, result, command) : 0;
}

void add(const Study& study, StudyCommand& command, CLI::App& program, int& status) {
    auto* verb = program.add_subcommand(study.name, study.help);
    verb->add_option("-o,--output", command.folder,
                     "Folder of runs and results; a study that was stopped goes on there")
        ->capture_default_str();
    verb->add_option("--size", command.size, "small (minutes) or paper (hours)")
        ->check(CLI::IsMember({"small", "paper"}))
        ->capture_default_str();
    verb->add_option("--threads", command.threads, "0: all cores")->check(CLI::Range(0, 4096));
    verb->add_flag("--keep-frames", command.keep_frames, "Keep the frames of all runs");
    auto* shows = verb->add_flag("--show", command.show, "Print the committed result; run nothing");
    verb->add_option("--plots", command.plots, "Existing folder to draw its plots into")
        ->check(CLI::ExistingDirectory)
        ->needs(shows);
    auto* checks = verb->add_flag("--check", command.check,
                                  "Exit with 1 where the result differs from the committed one");
    verb->add_flag("--record", command.record, "Write the result to validation/ as well")
        ->excludes(shows)
        ->excludes(checks);
    checks->excludes(shows);
    verb->callback([&status, &command, study] { status = run(study, command); });
}

int run_program(int argument_count, char** arguments) {
    CLI::App program("Runs a study of this project beside published or exact figures, and prints "
                     "both.",
                     "meniscus_study");
    program.require_subcommand(1);
    program.get_formatter()->label("SUBCOMMAND", "STUDY");
    StudyCommand command;
    int status = 0;
    for (const Study& study : all_studies())
        add(study, command, program, status);
    try {
        program.parse(argument_count, arguments);
        return status;
    } catch (const CLI::RequiredError&) {
        std::string names;
        for (const Study& study : all_studies())
            names += std::string(names.empty() ? "" : ", ") + study.name;
        fmt::print(stderr, "meniscus_study: expected a study: {}\n", names);
        return 2;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) // --help
            return program.exit(error);
        fmt::print(stderr, "meniscus_study: {} (see meniscus_study --help)\n", error.what());
        return 2;
    } catch (const Stopped&) {
        fmt::print(stderr, "meniscus_study: stopped; the same command goes on from here\n");
        return 130;
    } catch (const InputError& error) {
        fmt::print(stderr, "meniscus_study: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "meniscus_study: {}\n", error.what());
        return 3;
    }
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    meniscus::wait_asleep(arguments);
    return meniscus::run_program(argument_count, arguments);
}
