// What the runtime costs on snapshots, neighbor lists given, stage by stage and as a whole, on one
// thread and on two, in nanoseconds a particle of the snapshot; beside the same in plain loops and
// beside the pairwise force of Becker and Teschner 2007. Built twice: as the default build is, for
// every x86-64, and as surface_speed_native for the machine that it is built on.
// Usage: surface_speed SNAPSHOT... (files end where the options of Google Benchmark begin)
#include "becker_force.hpp"
#include "medians.hpp"

#include <meniscus/data/neighbor_search.hpp>
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/runtime/surface_reference.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace meniscus {
namespace {

constexpr std::size_t samples = 128;

using View = CsrNeighborhood<float, 3>;
using Surface = SurfaceParticles<float, 3>;

/// A snapshot as a solver holds it.
struct Fluid {
    std::vector<float> positions;
    NeighborLists lists;
    float support_radius = 0;

    explicit Fluid(const std::string& file) {
        const Snapshot snapshot = read_snapshot(file);
        if (!snapshot.support_radius || snapshot.dimension != 3 || snapshot.size() == 0)
            throw std::runtime_error(file + " must be in 3D and store its support radius");
        support_radius = static_cast<float>(*snapshot.support_radius);
        lists = find_neighbors(snapshot.positions, *snapshot.support_radius);
        for (const auto& position : snapshot.positions)
            for (const double coordinate : position)
                positions.push_back(static_cast<float>(coordinate));
    }

    [[nodiscard]] std::size_t size() const { return positions.size() / 3; }
    [[nodiscard]] View view() const {
        return {positions.data(), nullptr, lists.offsets.data(), lists.neighbors.data()};
    }
    [[nodiscard]] UniformRadius<float> radii() const { return {support_radius}; }
};

SurfaceTensionOptions with_samples(SurfaceTensionOptions options) {
    options.samples = samples;
    return options;
}

/// The stages one by one, each on what those before it left.
struct Stages {
    const Fluid& fluid;
    SurfaceTensionOptions options;
    Surface list;
    SampleDirections directions;
    HeldCells cells;
    std::vector<ExposureMemory> memory{2};
    std::vector<std::array<float, 3>> normals_before;
    std::vector<float> curvatures_before;

    explicit Stages(const Fluid& of) : fluid(of), options(with_samples(shipped_options<3>())) {
        fill_outward_directions<3>(samples, 0, directions);
        candidates(SerialLoop{});
        exposure({}, SerialLoop{});
        normals(SerialLoop{});
        curvature(SerialLoop{});
        force(SerialLoop{});
    }

    template <class Loop>
    void candidates(const Loop& loop) {
        find_candidates<float, 3>(fluid.view(), fluid.size(), fluid.radii(),
                                  surface_line<SurfaceCoefficients, float>(), 0.8, loop, list);
    }
    template <class Loop>
    void exposure(const ExposureOptions& how, const Loop& loop) {
        find_exposure<float, 3>(fluid.view(), NoBoundary{}, fluid.radii(), nullptr, directions,
                                cells, how, loop, memory.data(), list);
    }
    template <class Loop>
    void normals(const Loop& loop) {
        smooth_normals<float, 3>(options.tau, loop, list, normals_before);
    }
    template <class Loop>
    void curvature(const Loop& loop) {
        find_mapped_curvature<float, 3>(options.map, 0.8, fluid.radii(), loop, list,
                                        curvatures_before);
    }
    template <class Loop>
    void force(const Loop& loop) {
        find_force<float, 3>(options.force, fluid.radii(), loop, list);
    }
};

template <class Function>
void add(const std::string& name, const Function& function) {
    benchmark::RegisterBenchmark(name.c_str(), [function](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
            function();
            benchmark::ClobberMemory();
        }
    })->UseRealTime();
}

template <class Loop>
void add_stages(Stages& stages, const Loop& loop) {
    const std::string threads = "/" + std::to_string(loop.workers());
    ExposureOptions drop;
    drop.verification = Verification::drop;
    ExposureOptions exact;
    exact.method = CoverageMethod::exact;
    add("classify" + threads, [&stages, loop] { stages.candidates(loop); });
    add("expose_exact" + threads, [&stages, loop, exact] { stages.exposure(exact, loop); });
    add("expose_drop" + threads, [&stages, loop, drop] { stages.exposure(drop, loop); });
    add("expose_verify" + threads, [&stages, loop] { stages.exposure({}, loop); });
    add("normals" + threads, [&stages, loop] { stages.normals(loop); });
    add("curvature" + threads, [&stages, loop] { stages.curvature(loop); });
    add("force" + threads, [&stages, loop] { stages.force(loop); });
}

template <class Loop>
void add_step(const std::string& name, const Fluid& fluid, SurfaceTension<float, 3>& tension,
              const Loop& loop) {
    add(name + "/" + std::to_string(loop.workers()), [&fluid, &tension, loop] {
        tension.step(fluid.view(), fluid.size(), fluid.radii(), loop);
    });
}

void add_references(const Fluid& fluid, Stages& stages, ExactCoverage& exact) {
    const auto line = surface_line<SurfaceCoefficients, float>();
    add("classify_reference", [&fluid, line] {
        const auto range = neighbor_range<float>(fluid.support_radius, 0.8);
        std::size_t found = 0;
        for (std::size_t i = 0; i < fluid.size(); ++i)
            found += is_surface(sum_features_reference<float, 3>(fluid.view(), i, range), line,
                                fluid.support_radius)
                         ? 1
                         : 0;
        benchmark::DoNotOptimize(found);
    });
    add("expose_reference", [&fluid, &stages, &exact] {
        find_exposure_reference<float, 3>(fluid.view(), fluid.radii(), stages.directions,
                                          stages.cells.coarse, {}, exact, stages.list);
    });
    add("normals_to_force_reference", [&fluid, &stages] {
        find_force_reference<float, 3>(fluid.view(), fluid.radii(), stages.options, stages.list);
    });
}

template <class Loop>
void add_becker(const Fluid& fluid, std::vector<BeckerRow>& rows,
                std::vector<std::array<float, 3>>& force, const Loop& loop) {
    add("becker/" + std::to_string(loop.workers()), [&fluid, &rows, &force, loop] {
        find_becker_force(fluid.view(), fluid.size(), fluid.support_radius, 1, loop, rows.data(),
                          force);
    });
}

void print(const MedianReporter& reporter, const std::string& file, const Stages& stages) {
    const auto size = static_cast<double>(stages.fluid.size());
    std::size_t surface = 0;
    for (const SurfaceClass what : stages.list.surface_class)
        surface += what == SurfaceClass::surface ? 1 : 0;
    std::printf("\n%s: %.0f particles, %zu candidates, %zu of them surface; %zu samples\n\n",
                file.c_str(), size, stages.list.size(), surface, samples);
    std::printf("| benchmark | median, ms | ns a particle |\n|---|---|---|\n");
    for (const auto& [name, milliseconds] : reporter.medians)
        std::printf("| %s | %.3f | %.1f |\n", name.c_str(), milliseconds,
                    milliseconds * 1e6 / size);
    std::printf("\n| what | ratio of medians | value |\n|---|---|---|\n");
    for (const char* threads : {"/1", "/2"})
        print_ratio(reporter, "whole step, against Becker 2007", std::string("step") + threads,
                    std::string("becker") + threads);
    print_ratio(reporter, "whole step, speedup by a second thread", "step/1", "step/2");
    print_ratio(reporter, "classification, speedup over plain loops", "classify_reference",
                "classify/1");
    print_ratio(reporter, "coverage, speedup over plain loops", "expose_reference",
                "expose_verify/1");
    print_ratio(reporter, "momentum, part of the step", "momentum/2", "step/2");
}

void measure(const std::string& file) {
    const Fluid fluid(file);
    Stages stages(fluid);
    ExactCoverage exact;
    std::vector<BeckerRow> rows(2);
    std::vector<std::array<float, 3>> becker;
    SurfaceTension<float, 3> ours(with_samples(shipped_options<3>()));
    SurfaceTension<float, 3> paper(with_samples(paper_options()));
    benchmark::ClearRegisteredBenchmarks();
    const auto add_for = [&](const auto& loop) {
        add_stages(stages, loop);
        add_step("step", fluid, ours, loop);
        add_step("step_paper", fluid, paper, loop);
        add_becker(fluid, rows, becker, loop);
        add("momentum/" + std::to_string(loop.workers()), [&fluid, &ours, loop] {
            ours.balance_momentum<3>(fluid.view(), NoBoundary{}, fluid.radii(),
                                     fluid.positions.data(), loop);
        });
    };
    ours.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    add_for(SerialLoop{});
    add_for(OpenMpLoop{2});
    add_references(fluid, stages, exact);
    MedianReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    print(reporter, file, stages);
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        int files = 0;
        while (files + 1 < argument_count && arguments[files + 1][0] != '-')
            ++files;
        meniscus::initialize_benchmarks(argument_count, arguments, std::max(files, 1),
                                        "usage: surface_speed SNAPSHOT...");
        for (int f = 1; f <= files; ++f)
            meniscus::measure(arguments[f]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "surface_speed: %s\n", error.what());
        return 1;
    }
}
