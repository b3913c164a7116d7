// How fast labelling and classification are, as ratios within one run, on one snapshot:
//   labels    Monte Carlo labels, fast kernel against the scalar reference, one thread against two
//   classify  the line over given neighbor lists against a loop that only gathers and adds
//   fused     the line inside a density loop against that loop alone
// Usage: speed SNAPSHOT [options of Google Benchmark]. The repetitions of all benchmarks are
// interleaved, and the ratios are of medians.
#include "density_loop.hpp"
#include "medians.hpp"

#include <meniscus/data/neighbor_search.hpp>
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/labeler/coverage.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/runtime/classifier.hpp>
#include <meniscus/runtime/surface_coefficients.hpp>

#include <benchmark/benchmark.h>
#include <cstdio>
#include <exception>
#include <utility>

namespace meniscus {
namespace {

constexpr std::size_t label_samples = 10000;

/// A snapshot as a solver holds it.
template <class Real>
struct Host {
    std::vector<Real> positions;
    std::vector<Real> masses;
    NeighborLists lists;
    Real support_radius;

    Host(const Snapshot& snapshot)
        : masses(snapshot.size(), Real(1)),
          lists(find_neighbors(snapshot.positions, *snapshot.support_radius)),
          support_radius(static_cast<Real>(*snapshot.support_radius)) {
        for (const auto& position : snapshot.positions)
            for (const double coordinate : position)
                positions.push_back(static_cast<Real>(coordinate));
    }

    [[nodiscard]] std::size_t size() const { return masses.size(); }
    [[nodiscard]] CsrNeighborhood<Real, 3> view(bool equal_masses) const {
        return {positions.data(), equal_masses ? nullptr : masses.data(), lists.offsets.data(),
                lists.neighbors.data()};
    }
};

void label_fast(benchmark::State& state, const Snapshot& snapshot, int threads) {
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = label_samples;
    options.threads = threads;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(label_particles(snapshot, *snapshot.support_radius, options));
}

/// What label_particles does, with the reference in place of the kernel.
void label_reference(benchmark::State& state, const Snapshot& snapshot) {
    const double h = *snapshot.support_radius;
    const auto range = neighbor_range<double>(h, 0.8);
    std::vector<Direction> directions(label_samples);
    fill_halton(3, 0, 0, directions);
    for ([[maybe_unused]] auto _ : state) {
        const auto lists = find_neighbors(snapshot.positions, h, {}, 1);
        const CsrNeighborhood<double, 3> view{snapshot.positions[0].data(), nullptr,
                                              lists.offsets.data(), lists.neighbors.data()};
        std::vector<Direction> displacements;
        for (std::size_t i = 0; i < snapshot.size(); ++i) {
            displacements.clear();
            view(i, [&](std::size_t, const Direction& x, double) {
                if (range.contains(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]))
                    displacements.push_back({x[0] / h, x[1] / h, x[2] / h});
            });
            benchmark::DoNotOptimize(count_uncovered_reference(directions, displacements, 0.8));
        }
    }
}

/// The baseline of classification: fetches every neighbor and adds up the displacements.
template <class Real>
void gather_and_add(benchmark::State& state, const Host<Real>& host) {
    std::vector<Real> sums(host.positions.size());
    const Real* positions = host.positions.data();
    for ([[maybe_unused]] auto _ : state) {
        for (std::size_t i = 0; i < host.size(); ++i) {
            Real sum[3] = {0, 0, 0};
            for (std::size_t n = host.lists.offsets[i]; n < host.lists.offsets[i + 1]; ++n) {
                const std::size_t j = host.lists.neighbors[n];
                for (int axis = 0; axis < 3; ++axis)
                    sum[axis] += positions[j * 3 + axis] - positions[i * 3 + axis];
            }
            for (int axis = 0; axis < 3; ++axis)
                sums[i * 3 + axis] = sum[axis];
        }
        benchmark::ClobberMemory();
    }
}

template <class Real, class View>
void classify_lists(benchmark::State& state, const Host<Real>& host, const View& view) {
    std::vector<std::uint8_t> surface(host.size());
    for ([[maybe_unused]] auto _ : state) {
        classify<SurfaceCoefficients, Real, 3>(view, 0, host.size(), host.support_radius,
                                               surface.data());
        benchmark::ClobberMemory();
    }
}

template <class Real, Fused fused>
void density_pass(benchmark::State& state, const Host<Real>& host) {
    std::vector<Real> densities(host.size());
    std::vector<std::uint8_t> surface(host.size());
    for ([[maybe_unused]] auto _ : state) {
        density_loop<Real, fused>(host.positions.data(), host.masses.data(), host.lists,
                                  host.size(), host.support_radius, densities.data(),
                                  surface.data());
        benchmark::ClobberMemory();
    }
}

template <class Real>
void register_for(const std::string& type, const Host<Real>& host) {
    const auto add = [&](const std::string& name, auto&& function) {
        benchmark::RegisterBenchmark((name + "/" + type).c_str(), function);
    };
    add("gather_and_add", [&](auto& state) { gather_and_add(state, host); });
    add("classify", [&](auto& state) { classify_lists(state, host, host.view(true)); });
    add("classify_masses", [&](auto& state) { classify_lists(state, host, host.view(false)); });
    add("classify_exact_lists", [&](auto& state) {
        classify_lists(state, host, ExactCsrNeighborhood<Real, 3>{host.view(true)});
    });
    add("classify_reference", [&](auto& state) {
        const auto view = host.view(true); // not as a CSR view: the plain path
        classify_lists(state, host, [&](std::size_t i, auto&& visit) {
            view(i, std::forward<decltype(visit)>(visit));
        });
    });
    add("density", [&](auto& state) { density_pass<Real, Fused::nothing>(state, host); });
    add("density_fused",
        [&](auto& state) { density_pass<Real, Fused::equal_masses>(state, host); });
    add("density_fused_masses",
        [&](auto& state) { density_pass<Real, Fused::masses>(state, host); });
}

void print_ratios(const MedianReporter& reporter) {
    std::printf("\n| what | ratio of medians | value |\n|---|---|---|\n");
    print_ratio(reporter, "fast labels, speedup over the scalar reference", "label_reference",
                "label/1_thread");
    print_ratio(reporter, "fast labels, speedup by a second thread", "label/1_thread",
                "label/2_threads");
    for (const std::string type : {"/float", "/double"}) {
        print_ratio(reporter, "classification over lists", "classify" + type,
                    "gather_and_add" + type);
        print_ratio(reporter, "the same, masses that differ", "classify_masses" + type,
                    "gather_and_add" + type);
        print_ratio(reporter, "the same, exact lists", "classify_exact_lists" + type,
                    "gather_and_add" + type);
        print_ratio(reporter, "the same, plain reference", "classify_reference" + type,
                    "gather_and_add" + type);
        print_ratio(reporter, "fused into a density loop", "density_fused" + type,
                    "density" + type);
        print_ratio(reporter, "the same, masses that differ", "density_fused_masses" + type,
                    "density" + type);
    }
}

int run(int argument_count, char** arguments) {
    initialize_benchmarks(argument_count, arguments, 1, "usage: speed SNAPSHOT");
    const Snapshot snapshot = read_snapshot(arguments[1]);
    if (!snapshot.support_radius || snapshot.dimension != 3)
        throw std::runtime_error("the snapshot must be in 3D and store its support radius");

    const Host<float> in_float(snapshot);
    const Host<double> in_double(snapshot);
    benchmark::RegisterBenchmark("label_reference",
                                 [&](auto& state) { label_reference(state, snapshot); });
    for (const int threads : {1, 2})
        benchmark::RegisterBenchmark(
            threads == 1 ? "label/1_thread" : "label/2_threads",
            [&, threads](auto& state) { label_fast(state, snapshot, threads); })
            ->UseRealTime();
    std::printf("%s: %zu particles; labels with %zu samples, %s\n\n", arguments[1], snapshot.size(),
                label_samples, coverage_instruction_set());
    register_for("float", in_float);
    register_for("double", in_double);
    MedianReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    print_medians(reporter);
    print_ratios(reporter);
    return 0;
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        return meniscus::run(argument_count, arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "speed: %s\n", error.what());
        return 1;
    }
}
