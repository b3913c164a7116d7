// How long training takes on many particles: labelled states repeated until there are ten million,
// each copy a state of its own.
#include "support/memory.hpp"
#include "support/tables.hpp"

#include <meniscus/classifier/objectives/objectives.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/classifier/torch/torch_plugin.hpp>

#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr std::size_t wanted_particles = 10'000'000;

Tables training_time(const TableInput& input) {
    std::vector<LabelledState> states;
    std::size_t particles = 0;
    for (const auto& file : input.files) {
        states.push_back(read_labelled_state(file, ""));
        particles += states.back().size();
    }
    for (std::size_t next = 0; particles < wanted_particles; ++next) {
        states.push_back(states[next]);
        particles += states.back().size();
    }
    Table table =
        table_of("training-time", "objective | seconds {:.1f} | peak memory so far, MB {:.0f}");
    table.before = fmt::format("{} particles.\n\n", particles);
    TrainingOptions options;
    options.label_threshold = 0.02;
    for (const Objective& objective : objectives()) {
        options.objective = objective.name;
        if (options.objective != "neyman-pearson" && !has_torch_trainer())
            continue;
        const auto times = measure({{[&] { train(states, options); }}}, {1, 1e-6});
        table.add({options.objective, times[0].median, peak_bytes() / (1024 * 1024)});
    }
    return {table};
}

} // namespace

TableGroup training_time_tables() {
    return {"Lines",
            {{"training-time", "LABELLED...", 1, "training on ten million particles, by objective",
              training_time}}};
}

} // namespace meniscus
