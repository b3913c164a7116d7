#include "timing.hpp"

#include <meniscus/runtime/simd/dispatch.hpp>

#include <algorithm>
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace meniscus {
namespace {

constexpr int repetitions_of_slow_ones = 3;

/// Keeps the time of every repetition, by the number that the benchmark has for a name.
class TimeKeeper : public benchmark::BenchmarkReporter {
public:
    std::vector<std::vector<double>> times; ///< s

    explicit TimeKeeper(std::size_t count) : times(count) {}

    bool ReportContext(const Context& /*context*/) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration)
                times[std::stoul(run.run_name.function_name)].push_back(
                    run.real_accumulated_time / static_cast<double>(run.iterations));
    }
};

/// The value below which a part of the sorted values lies.
double quantile(const std::vector<double>& sorted, double part) {
    const double place = part * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double share = place - static_cast<double>(below);
    return (1 - share) * sorted[below] + share * sorted[above];
}

void interleave_repetitions() {
    char program[] = "meniscus";
    char interleave[] = "--benchmark_enable_random_interleaving=true";
    char* arguments[] = {program, interleave};
    int count = 2;
    benchmark::Initialize(&count, arguments);
}

/// As Linux names it; "unknown" elsewhere.
std::string processor_name() {
    std::ifstream information("/proc/cpuinfo");
    for (std::string line; std::getline(information, line);)
        if (line.rfind("model name", 0) == 0)
            return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string cache_sizes() {
    std::string text;
    for (const auto& cache : benchmark::CPUInfo::Get().caches)
        text += fmt::format("{}L{} {} {} kB", text.empty() ? "" : ", ", cache.level, cache.type,
                            cache.size / 1024);
    return text;
}

} // namespace

std::vector<RepeatedTime> measure(const std::vector<Timed>& all, const TimingOptions& options) {
    benchmark::ClearRegisteredBenchmarks();
    interleave_repetitions();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto& one = all[k];
        benchmark::RegisterBenchmark(std::to_string(k).c_str(),
                                     [&one](benchmark::State& state) {
                                         for ([[maybe_unused]] auto _ : state) {
                                             one.run();
                                             benchmark::ClobberMemory();
                                         }
                                     })
            ->UseRealTime()
            ->MinTime(options.min_time)
            ->Repetitions(one.is_slow ? std::min(options.repetitions, repetitions_of_slow_ones)
                                      : options.repetitions);
    }
    TimeKeeper keeper(all.size());
    benchmark::RunSpecifiedBenchmarks(&keeper);
    benchmark::ClearRegisteredBenchmarks();
    std::vector<RepeatedTime> times;
    for (auto& of_one : keeper.times) {
        std::sort(of_one.begin(), of_one.end());
        times.push_back({quantile(of_one, 0.5), quantile(of_one, 0.25), quantile(of_one, 0.75)});
    }
    return times;
}

RepeatedTime per_particle(const RepeatedTime& seconds, double unit, std::size_t particles) {
    const double scale = 1 / (unit * static_cast<double>(particles));
    return {scale * seconds.median, scale * seconds.lower, scale * seconds.upper};
}

Medians measure_by_name(const std::vector<Timed>& all, const TimingOptions& options) {
    const auto times = measure(all, options);
    Medians medians;
    for (std::size_t k = 0; k < all.size(); ++k)
        medians[all[k].name] = times[k].median;
    return medians;
}

Table ratios_of(const Medians& medians, const std::vector<Ratio>& ratios) {
    Table table = table_of("ratios", "what | ratio of medians | value {:.2f}");
    table.before = "\n";
    for (const auto& [what, over, under] : ratios)
        table.add({what, over + " / " + under, medians.at(over) / medians.at(under)});
    return table;
}

nlohmann::json machine() {
    return {
        {"processor", processor_name()}, {"cores", benchmark::CPUInfo::Get().num_cpus},
        {"caches", cache_sizes()},       {"compiler", MENISCUS_COMPILER},
        {"build", MENISCUS_BENCH_BUILD}, {"vectors_of_labels", name_of(instruction_set_up_to())}};
}

} // namespace meniscus
