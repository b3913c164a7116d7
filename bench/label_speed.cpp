// How fast exact labels are beside Monte Carlo ones, on snapshots: each label run as a whole, with
// its neighbor search and its features.
//   exact            lambda of every particle, on one thread and on two
//   exact_surface    surface or not, without lambda
//   exact_reference  lambda by exact_reference.hpp, without vectors and cells
//   samples_N        Monte Carlo with N directions a particle
// Usage: label_speed SNAPSHOT... (files end where the options of Google Benchmark begin)
#include "medians.hpp"

#include <meniscus/data/neighbor_search.hpp>
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/labeler/exact_labels.hpp>
#include <meniscus/labeler/exact_reference.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/runtime/exact_coverage.hpp>
#include <meniscus/runtime/features.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace meniscus {
namespace {

constexpr double radius_ratio = 0.8;

void label(benchmark::State& state, const Snapshot& snapshot, LabelMethod method,
           std::size_t samples, int threads) {
    LabelOptions options;
    options.method = method;
    options.samples = samples;
    options.threads = threads;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(label_particles(snapshot, *snapshot.support_radius, options));
}

/// What label_particles does, with `decide(displacements / h)` in place of lambda.
template <class Decide>
void label_otherwise(benchmark::State& state, const Snapshot& snapshot, Decide&& decide) {
    const double h = *snapshot.support_radius;
    const auto range = neighbor_range<double>(h, radius_ratio);
    FoundNeighbors found;
    std::vector<Direction> displacements;
    std::vector<double> offsets(snapshot.size());
    for ([[maybe_unused]] auto _ : state) {
        const NeighborGrid grid(snapshot.positions, h, {}, 1);
        for (std::size_t place = 0; place < grid.size(); ++place) {
            grid.find(place, found);
            displacements.clear();
            FeatureSum<double, 3> sum;
            for (const Direction& x : found.displacements) {
                const double square = squared_length<double, 3>(x);
                sum.add(x, square, 1, range);
                if (range.contains(square))
                    displacements.push_back({x[0] / h, x[1] / h, x[2] / h});
            }
            offsets[grid.particle(place)] = mass_offset(sum, h);
            benchmark::DoNotOptimize(decide(displacements));
        }
        benchmark::ClobberMemory();
    }
}

void exact_surface(benchmark::State& state, const Snapshot& snapshot) {
    const auto exact = exact_labels();
    label_otherwise(state, snapshot, [&](const std::vector<Direction>& displacements) {
        return exact->is_uncovered(3, displacements, radius_ratio);
    });
}

void exact_reference(benchmark::State& state, const Snapshot& snapshot) {
    label_otherwise(state, snapshot, [](const std::vector<Direction>& displacements) {
        return uncovered_fraction_reference(displacements, radius_ratio);
    });
}

/// How many particles need no arc to tell whether they are surface.
void print_settled(const Snapshot& snapshot) {
    const double h = *snapshot.support_radius;
    const auto range = neighbor_range<double>(h, radius_ratio);
    const NeighborGrid grid(snapshot.positions, h);
    const CoverageCells cells;
    ExactCoverage coverage;
    FoundNeighbors found;
    std::array<double, 3> counts{};
    for (std::size_t place = 0; place < grid.size(); ++place) {
        grid.find(place, found);
        coverage.caps.clear();
        for (const Direction& x : found.displacements)
            if (range.contains(squared_length<double, 3>(x)))
                add_cap<3>(coverage.caps, x, h, radius_ratio * h);
        counts[static_cast<std::size_t>(settle(cells, coverage.caps, coverage.tests, false))] += 1;
    }
    for (double& count : counts)
        count *= 100 / static_cast<double>(grid.size());
    std::printf("Settled by cells: %.1f %% covered, %.1f %% not; undecided %.2f %%.\n\n", counts[0],
                counts[1], counts[2]);
}

void measure(const std::string& file) {
    const Snapshot snapshot = read_snapshot(file);
    if (!snapshot.support_radius || snapshot.dimension != 3 || snapshot.size() == 0)
        throw std::runtime_error(file + " must be in 3D and store its support radius");
    benchmark::ClearRegisteredBenchmarks();
    const auto add = [](const std::string& name, auto&& function) {
        benchmark::RegisterBenchmark(name.c_str(), function)->UseRealTime();
    };
    for (const int threads : {1, 2})
        add("exact/" + std::to_string(threads),
            [&, threads](auto& state) { label(state, snapshot, LabelMethod::exact, 1, threads); });
    add("exact_surface", [&](auto& state) { exact_surface(state, snapshot); });
    add("exact_reference", [&](auto& state) { exact_reference(state, snapshot); });
    for (const int samples : {1000, 10000, 100000})
        add("samples_" + std::to_string(samples), [&, samples](auto& state) {
            label(state, snapshot, LabelMethod::monte_carlo, samples, 1);
        });
    MedianReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    std::printf("\n%s: %zu particles. ", file.c_str(), snapshot.size());
    print_settled(snapshot);
    print_medians(reporter);
    std::printf("\n| what | ratio of medians | value |\n|---|---|---|\n");
    print_ratio(reporter, "surface or not, against 1000 samples", "exact_surface", "samples_1000");
    print_ratio(reporter, "with lambda, against 10,000 samples", "exact/1", "samples_10000");
    print_ratio(reporter, "speedup over the plain reference", "exact_reference", "exact/1");
    print_ratio(reporter, "speedup by a second thread", "exact/1", "exact/2");
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        int files = 0;
        while (files + 1 < argument_count && arguments[files + 1][0] != '-')
            ++files;
        meniscus::initialize_benchmarks(argument_count, arguments, std::max(files, 1),
                                        "usage: label_speed SNAPSHOT...");
        for (int f = 1; f <= files; ++f)
            meniscus::measure(arguments[f]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "label_speed: %s\n", error.what());
        return 1;
    }
}
