// Medians of repeated benchmarks and their ratios as Markdown tables. The repetitions of all
// benchmarks are interleaved, so that a busy moment of the machine meets them all alike.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace meniscus {

/// Keeps the medians. Processor time, which a busy machine disturbs least; wall time
/// where threads are compared.
class MedianReporter : public benchmark::ConsoleReporter {
public:
    std::map<std::string, double> medians; ///< milliseconds

    MedianReporter() : benchmark::ConsoleReporter(OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Aggregate || run.aggregate_name != "median")
                continue;
            const double nanoseconds = run.run_name.time_type == "real_time"
                                           ? run.GetAdjustedRealTime()
                                           : run.GetAdjustedCPUTime();
            medians[run.run_name.function_name] = nanoseconds * 1e-6;
        }
    }
};

/// Reads the options of Google Benchmark behind the first `own` arguments, which are the program's;
/// throws std::runtime_error with `usage` where something is missing or unknown.
void initialize_benchmarks(int argument_count, char** arguments, int own, const std::string& usage);

/// Rows "| what | over / under | ratio |"; none where one of the two did not run.
void print_ratio(const MedianReporter& reporter, const char* what, const std::string& over,
                 const std::string& under);

/// A table of all medians in milliseconds.
void print_medians(const MedianReporter& reporter);

} // namespace meniscus
