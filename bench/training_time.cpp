// How long training takes on many particles: labelled states repeated until there are ten million,
// each copy a state of its own. Prints time and peak memory of each objective, in Markdown.
// Usage: training_time LABELLED...
#include <meniscus/classifier/torch_plugin.hpp>
#include <meniscus/classifier/trainer.hpp>

#include <chrono>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <stdexcept>
#include <sys/resource.h>

namespace meniscus {
namespace {

constexpr std::size_t wanted_particles = 10'000'000;

std::vector<LabelledState> repeated_states(int argument_count, char** arguments) {
    std::vector<LabelledState> states;
    std::size_t particles = 0;
    for (int a = 1; a < argument_count; ++a) {
        states.push_back(read_labelled_state(arguments[a], ""));
        particles += states.back().size();
    }
    if (particles == 0)
        throw std::runtime_error("usage: training_time LABELLED...");
    for (std::size_t next = 0; particles < wanted_particles; ++next) {
        states.push_back(states[next]);
        particles += states.back().size();
    }
    fmt::print("{} particles.\n\n| objective | seconds | peak memory so far, MB |\n|---|---|---|\n",
               particles);
    return states;
}

double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

void print_times(const std::vector<LabelledState>& states) {
    TrainingOptions options;
    options.label_threshold = 0.02;
    for (const std::string& objective : training_objectives()) {
        if (objective != "neyman-pearson" && !has_torch_trainer())
            continue;
        options.objective = objective;
        const auto start = std::chrono::steady_clock::now();
        train(states, options);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        fmt::print("| {} | {:.1f} | {:.0f} |\n", objective, seconds.count(), peak_megabytes());
    }
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        meniscus::print_times(meniscus::repeated_states(argument_count, arguments));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "training_time: %s\n", error.what());
        return 1;
    }
}
