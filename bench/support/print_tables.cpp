#include "tables.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <omp.h>

namespace meniscus {
namespace {

using Path = std::filesystem::path;

struct Wanted {
    TableInput input;
    Path json;
};

std::vector<Path> sample_files() {
    std::vector<Path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(MENISCUS_SOURCE_FOLDER "/data/samples"))
        if (entry.path().extension() == ".vtkhdf")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void write_json(const Tables& tables, const Path& file) {
    auto all = nlohmann::json::array();
    for (const Table& table : tables)
        all.push_back(to_json(table));
    write_whole(file, nlohmann::json({{"machine", machine()}, {"tables", all}}).dump(1) + "\n");
}

void print(const TableKind& kind, Wanted& wanted) {
    TableInput& input = wanted.input;
    if (!wanted.json.empty())
        check_can_be_written(wanted.json);
    input.samples = sample_files();
    if (kind.takes_states && input.files.empty())
        input.files = input.samples;
    for (const Path& file : input.files)
        if (kind.takes_states)
            input.states.push_back(read_fluid_state<float>(file));
    const Tables tables = kind.make(input);
    for (const Table& table : tables)
        fmt::print("{}{}{}", table.before, markdown(table), table.after);
    if (!wanted.json.empty())
        write_json(tables, wanted.json);
}

void add(const TableKind& kind, const char* heading, Wanted& wanted, CLI::App& program) {
    auto* table = program.add_subcommand(kind.name, kind.help)->group(heading);
    if (kind.files[0] != 0)
        table->add_option("FILES", wanted.input.files, kind.files)
            ->expected(static_cast<int>(kind.min_files), 1 << 20)
            ->required(kind.min_files > 0);
    table->add_option("--json", wanted.json, "File for the figures with all their digits");
    table->add_option("--repetitions", wanted.input.timing.repetitions, "Runs that a median is of")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    table->add_option("--threads", wanted.input.threads, "Threads of what is parallel")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    table->callback([&] { print(kind, wanted); });
}

} // namespace

int print_tables(int argument_count, char** arguments, const std::vector<TableGroup>& groups) {
    Wanted wanted;
    wanted.input.models = MENISCUS_SOURCE_FOLDER "/configs/models";
    wanted.input.scenes = MENISCUS_SOURCE_FOLDER "/configs/scenes";
    wanted.input.threads = omp_get_max_threads();
    CLI::App program("Prints a table of docs/ in Markdown.", "meniscus_bench");
    program.require_subcommand(1);
    program.get_formatter()->label("SUBCOMMAND", "TABLE [FILES...]");
    for (const TableGroup& group : groups)
        for (const TableKind& kind : group.kinds)
            add(kind, group.heading, wanted, program);
    try {
        program.parse(argument_count, arguments);
        return 0;
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? program.exit(error) : (program.exit(error), 2);
    } catch (const InputError& error) {
        fmt::print(stderr, "meniscus_bench: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "meniscus_bench: {}\n", error.what());
        return 3;
    }
}

} // namespace meniscus
