// meniscus train: the line, from labelled snapshots.
#include "file_batch.hpp"
#include "input_files.hpp"
#include "large_states.hpp"
#include "usage.hpp"

#include <meniscus/app/ranks/ranks_of_program.hpp>
#include <meniscus/classifier/objectives/objectives.hpp>
#include <meniscus/classifier/objectives/pair_search.hpp>
#include <meniscus/classifier/objectives/scene_errors.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>

#include <atomic>
#include <cstddef>
#include <exception>
#include <fmt/format.h>
#include <memory>
#include <vector>

namespace meniscus {
namespace {

struct TrainCommand {
    std::vector<Path> inputs;
    Path output;
    std::string scene;
    Path keep_k;
    std::vector<std::string> features;        ///< empty: those of keep_k, else the paper's
    std::vector<std::string> second_features; ///< empty: one line
    TrainingOptions training;
    std::uint64_t memory = 0; ///< bytes; files that take more are visited one by one; 0: no limit
    int threads = 0;
    bool quiet = false;
};

/// Asked for in place of names: all pairs are tried.
const std::vector<std::string> search = {"search"};

FeaturePair first_features(const TrainCommand& command) {
    if (!command.features.empty())
        return feature_pair(command.features);
    return command.training.keep_k ? command.training.keep_k->features : FeaturePair{};
}

/// The states in the order of the files, several of which are read at a time where they are small.
/// Throws what the first file at fault does.
std::vector<LabelledState> read_states(const TrainCommand& command, const FeaturePair& features) {
    const std::vector<Path>& files = command.inputs;
    std::vector<LabelledState> states(files.size());
    std::vector<std::exception_ptr> failures(files.size());
    ProgressBar bar("reading", files.size(), command.quiet);
    std::size_t done = 0;
    std::atomic<bool> stop{false};
    const int threads = thread_count(command.threads);
#pragma omp parallel for num_threads(are_many_and_small(files, threads) ? threads : 1)             \
    schedule(dynamic, 1)
    for (std::size_t f = 0; f < files.size(); ++f) {
        if (stop) // the files before are read or being read
            continue;
        try {
            states[f] = read_labelled_state(files[f], command.scene, features);
        } catch (...) {
            failures[f] = std::current_exception();
            stop = true;
        }
#pragma omp critical
        bar.show(++done);
    }
    for (const std::exception_ptr& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
    return states;
}

/// The best of all pairs, for a second line where there is a first; prints what each would do.
FeaturePair searched_features(const TrainCommand& command, const Model* first) {
    const auto states_of = [&](const FeaturePair& pair) { return read_states(command, pair); };
    const auto results = search_pairs(states_of, command.training.label_threshold, first);
    if (!command.quiet) {
        print_text(fmt::format("{:<42} {:>15} {:>24} {:>16}   line\n",
                               first == nullptr ? "features" : "features of a second line",
                               "false positives", "candidates for a surface", "sums a neighbor"));
        for (const PairResult& one : results)
            print_text(fmt::format("{:<42} {:>13.2f} % {:>24.2f} {:>16}   {}\n",
                                   names_of(one.features), 100 * one.false_positive_rate,
                                   one.candidates, one.sums, line_text(one.line, one.features, 5)));
    }
    return results.front().features;
}

/// A model and its errors on the files it was trained on.
struct Trained {
    Model model;
    std::vector<SceneErrors> errors;
};

Trained train_in_memory(const TrainCommand& command) {
    const auto states =
        read_states(command, command.features == search ? searched_features(command, nullptr)
                                                        : first_features(command));
    Trained trained;
    trained.model = train(states, command.training);
    trained.errors = count_errors(states, trained.model.line, trained.model.label_threshold);
    if (!command.second_features.empty()) {
        auto others = read_states(command, command.second_features == search
                                               ? searched_features(command, &trained.model)
                                               : feature_pair(command.second_features));
        trained.errors = add_second_line(trained.model, states, std::move(others));
    }
    return trained;
}

/// The same, to the bit, with files that are read anew at every visit.
Trained train_on_visits(const TrainCommand& command, Ranks& ranks) {
    if (command.features == search || !command.second_features.empty())
        throw InputError("--features search and --second-features need all files in the memory of "
                         "one process; leave them out, or --memory and mpirun");
    const Campaign campaign = campaign_of(command.inputs, command.scene, first_features(command),
                                          command.training.label_threshold, ranks);
    Trained trained;
    trained.model = train(campaign, command.training);
    trained.errors = count_errors(campaign, trained.model.line, trained.model.label_threshold);
    return trained;
}

/// Bytes that a particle takes in a snapshot.
std::uint64_t bytes_a_particle(const Snapshot& outline) {
    std::uint64_t bytes = sizeof(Positions::value_type);
    for (const PointArray& array : outline.point_data)
        bytes += static_cast<std::uint64_t>(array.components) *
                 std::visit([](const auto& values) { return sizeof values[0]; }, array.values);
    return bytes;
}

/// Whether the files are more than may be in memory at a time. Throws InputError where one alone
/// is.
bool exceeds_memory(const TrainCommand& command) {
    if (command.memory == 0)
        return false;
    constexpr std::uint64_t own_memory = std::uint64_t{36} << 20; // and the bins
    constexpr std::uint64_t kept = 32; // bytes a particle, of LabelledState
    std::uint64_t all = own_memory;
    for (const Path& input : command.inputs) {
        const Snapshot outline = naming_file(input, [&] { return read_vtkhdf_outline(input); });
        const std::uint64_t one =
            own_memory + outline.particles_in_file * (kept + bytes_a_particle(outline));
        if (one > command.memory)
            throw InputError(fmt::format("{}: reading it takes about {} MiB, more than --memory "
                                         "allows; files are read one by one, but whole",
                                         input.string(), (one >> 20) + 1));
        all += outline.particles_in_file * kept;
    }
    return all > command.memory;
}

void run_train(TrainCommand& command) {
    Ranks& ranks = ranks_of_program();
    command.inputs = input_files(command.inputs);
    check_is_not_an_input(command.output, command.inputs);
    check_is_not_an_input(command.output, {command.keep_k});
    check_can_be_written(command.output);
    check_label_threshold(command.training.label_threshold);
    if (!command.keep_k.empty())
        command.training.keep_k = read_model(command.keep_k);
    const auto [model, errors] = ranks.size() > 1 || exceeds_memory(command)
                                     ? train_on_visits(command, ranks)
                                     : train_in_memory(command);
    if (ranks.rank() > 0)
        return;
    {
        const WriteGuard guard;
        write_whole(command.output, model_to_json(model));
    }
    if (command.quiet)
        return;
    print_text(fmt::format(
        "{}: {}{} ({}, label threshold {})\n", printable(command.output.string()),
        line_text(model.line, model.features, 8),
        model.second ? "; of these " + line_text(model.second->line, model.second->features, 8)
                     : "",
        printable(model.objective), model.label_threshold));
    for (const SceneErrors& scene : errors)
        print_text(
            fmt::format("  {}: {} particles, {} surface, {} false negatives, {} false positives "
                        "({:.2f} %)\n",
                        printable(scene.scene), scene.particles, scene.surface_particles,
                        scene.false_negatives, scene.false_positives,
                        100.0 * static_cast<double>(scene.false_positives) /
                            static_cast<double>(scene.particles)));
}

std::vector<std::string> objective_names() {
    std::vector<std::string> names;
    for (const Objective& objective : objectives())
        names.emplace_back(objective.name);
    return names;
}

/// "name: meaning; ..."
std::string objective_meanings() {
    std::string text;
    for (const Objective& objective : objectives())
        text +=
            fmt::format("{}{}: {}", text.empty() ? "" : "; ", objective.name, objective.meaning);
    return text;
}

} // namespace

void add_train(CLI::App& command) {
    auto options = std::make_shared<TrainCommand>();
    auto* verb = command.add_subcommand("train", "Fit the line y <= k x + d to labelled snapshots");
    verb->add_option("LABELLED", options->inputs,
                     fmt::format("Snapshots that `meniscus label` has written: {}", input_kinds))
        ->required();
    verb->add_option("-o,--output", options->output, "Model file (JSON)")->required();
    auto* objective =
        verb->add_option("--objective", options->training.objective, objective_meanings())
            ->check(CLI::IsMember(objective_names()))
            ->capture_default_str();
    verb->add_option("--label-threshold", options->training.label_threshold,
                     "Surface means an uncovered fraction above this")
        ->capture_default_str();
    verb->add_option(
            "--features", options->features,
            fmt::format("The two features x and y of the line, of {}; or `search`: tries all "
                        "pairs, prints what each lets through and costs, and takes the best "
                        "(default: {})",
                        feature_names(), names_of(FeaturePair{})))
        ->delimiter(',');
    verb->add_option(
            "--second-features", options->second_features,
            "Train a second line of these two features, or of the best (`search`), for what "
            "the first lets through")
        ->delimiter(',');
    verb->add_option("--keep-k", options->keep_k,
                     "Keep this model's slope k, shift only d to these snapshots")
        ->excludes(objective);
    verb->add_option("--scene", options->scene, "Scene of all snapshots, in place of their own");
    verb->add_option("--seed", options->training.seed, "Seed of network's weights and batches")
        ->check(whole_numbers())
        ->capture_default_str();
    add_memory_option(*verb, options->memory,
                      "Files that are more together are read one by one, several times, with the "
                      "same line");
    add_threads_option(*verb, options->threads);
    verb->get_option("--threads")->description("Threads that read the files; 0: all cores");
    add_quiet_option(*verb, options->quiet);
    add_examples(
        *verb,
        {{"meniscus train labelled/ -o model.json", "the line with the fewest false positives"},
         {"meniscus train labelled/ -o model.json --second-features "
          "mass_offset,direction_eigenvalue",
          "two lines, as those that ship; after label --features direction_eigenvalue"},
         {"meniscus train new/ -o moved.json --keep-k model.json",
          "the same slope, shifted to a new scene"}});
    verb->callback([options] { run_train(*options); });
}

} // namespace meniscus
