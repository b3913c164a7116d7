#include "medians.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace meniscus {

void initialize_benchmarks(int argument_count, char** arguments, int own,
                           const std::string& usage) {
    std::vector<char*> with_defaults = {arguments[0]};
    static char interleave[] = "--benchmark_enable_random_interleaving=true";
    static char repetitions[] = "--benchmark_repetitions=9";
    static char short_runs[] = "--benchmark_min_time=0.05";
    static char aggregates[] = "--benchmark_report_aggregates_only=true";
    for (char* option : {interleave, repetitions, short_runs, aggregates})
        with_defaults.push_back(option);
    with_defaults.insert(with_defaults.end(), arguments + std::min(argument_count, own + 1),
                         arguments + argument_count);
    int count = static_cast<int>(with_defaults.size());
    benchmark::Initialize(&count, with_defaults.data());
    if (argument_count < own + 1 ||
        benchmark::ReportUnrecognizedArguments(count, with_defaults.data()))
        throw std::runtime_error(usage + " [options of Google Benchmark]");
}

void print_ratio(const MedianReporter& reporter, const char* what, const std::string& over,
                 const std::string& under) {
    const auto above = reporter.medians.find(over);
    const auto below = reporter.medians.find(under);
    if (above != reporter.medians.end() && below != reporter.medians.end())
        std::printf("| %s | %s / %s | %.2f |\n", what, over.c_str(), under.c_str(),
                    above->second / below->second);
}

void print_medians(const MedianReporter& reporter) {
    std::printf("| benchmark | median, ms |\n|---|---|\n");
    for (const auto& [name, milliseconds] : reporter.medians)
        std::printf("| %s | %.3f |\n", name.c_str(), milliseconds);
}

} // namespace meniscus
