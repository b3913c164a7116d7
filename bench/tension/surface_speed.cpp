// What the runtime costs on snapshots, neighbor lists given, stage by stage and as a whole, on one
// thread and on two, in nanoseconds a particle of the snapshot; beside the same in plain loops and
// beside the pairwise force of Becker and Teschner 2007. Built twice: as the default build is, for
// every x86-64, and in meniscus_bench_native for the machine that it is built on.
#include "becker_force.hpp"
#include "support/tables.hpp"

#include "reference/surface_reference.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr std::size_t samples = 128;

using Surface = SurfaceParticles<float, 3>;

/// A state in 3D, and how the runtime is handed it.
struct Fluid {
    FluidState<float> state;

    [[nodiscard]] std::size_t size() const { return state.size(); }
    [[nodiscard]] CsrNeighborhood<float, 3> view() const { return state.view<3>(); }
    [[nodiscard]] UniformRadius<float> radii() const { return {state.support_radius}; }
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

    explicit Stages(const Fluid& of) : fluid(of), options(with_samples(completed({}, 3))) {
        fill_outward_directions<3>(samples, 0, directions);
        candidates(SerialLoop{});
        exposure({}, SerialLoop{});
        normals(SerialLoop{});
        curvature(SerialLoop{});
        force(SerialLoop{});
    }

    template <class Loop>
    void candidates(const Loop& loop) {
        find_candidates<float, 3>(fluid.view(), NoBoundary{}, fluid.size(), fluid.radii(), options,
                                  loop, memory.data(), list);
    }
    template <class Loop>
    void exposure(const SurfaceTensionOptions& how, const Loop& loop) {
        find_exposure<float, 3>(fluid.view(), NoBoundary{}, fluid.radii(), nullptr, directions,
                                cells, how, loop, memory.data(), list);
    }
    template <class Loop>
    void normals(const Loop& loop) {
        smooth_normals<float, 3>(options.tau, loop, list, normals_before);
    }
    template <class Loop>
    void curvature(const Loop& loop) {
        find_mapped_curvature<float, 3>(options.curvature_map, 0.8, fluid.radii(), loop, list,
                                        curvatures_before);
    }
    template <class Loop>
    void force(const Loop& loop) {
        find_force<float, 3>(options, fluid.radii(), loop, list);
    }
};

/// What is timed, by name.
struct Works {
    std::vector<Timed> all;

    void add(const std::string& name, std::function<void()> run) {
        all.push_back({std::move(run), false, name});
    }
};

template <class Loop>
void add_stages(Stages& stages, const Loop& loop, Works& works) {
    const std::string threads = "/" + std::to_string(loop.workers());
    SurfaceTensionOptions drop;
    drop.verification = Verification::drop;
    SurfaceTensionOptions exact;
    exact.coverage = CoverageMethod::exact;
    works.add("classify" + threads, [&stages, loop] { stages.candidates(loop); });
    works.add("expose_exact" + threads, [&stages, loop, exact] { stages.exposure(exact, loop); });
    works.add("expose_drop" + threads, [&stages, loop, drop] { stages.exposure(drop, loop); });
    works.add("expose_verify" + threads, [&stages, loop] { stages.exposure({}, loop); });
    works.add("normals" + threads, [&stages, loop] { stages.normals(loop); });
    works.add("curvature" + threads, [&stages, loop] { stages.curvature(loop); });
    works.add("force" + threads, [&stages, loop] { stages.force(loop); });
}

void add_references(const Fluid& fluid, Stages& stages, ExactCoverage& exact, Works& works) {
    const auto line = surface_line<Surface3D, float>(2);
    works.add("classify_reference", [&fluid, line] {
        const float h = fluid.state.support_radius;
        const auto range = neighbor_range<float>(h, 0.8);
        std::size_t found = 0;
        for (std::size_t i = 0; i < fluid.size(); ++i)
            found += is_surface(sum_features_reference<float, 3>(fluid.view(), i, range), line, h)
                         ? 1
                         : 0;
        benchmark::DoNotOptimize(found);
    });
    works.add("expose_reference", [&fluid, &stages, &exact] {
        find_exposure_reference<float, 3>(fluid.view(), fluid.radii(), stages.directions,
                                          stages.cells.coarse, {}, exact, stages.list);
    });
    works.add("normals_to_force_reference", [&fluid, &stages] {
        find_force_reference<float, 3>(fluid.view(), fluid.radii(), stages.options, stages.list);
    });
}

/// Whole steps, and what they are compared with.
struct Steps {
    const Fluid& fluid;
    SurfaceTension<float, 3> ours{with_samples({})};
    SurfaceTension<float, 3> paper{with_samples(paper_options())};
    std::vector<BeckerRow> rows = std::vector<BeckerRow>(2);
    std::vector<std::array<float, 3>> becker = {};

    template <class Loop>
    void add(const Loop& loop, Works& works) {
        const std::string threads = "/" + std::to_string(loop.workers());
        for (auto* tension : {&ours, &paper})
            works.add((tension == &ours ? "step" : "step_paper") + threads, [this, tension, loop] {
                tension->step(fluid.view(), fluid.size(), fluid.radii(), loop);
            });
        works.add("becker" + threads, [this, loop] {
            find_becker_force(fluid.view(), fluid.size(), fluid.state.support_radius, 1, loop,
                              rows.data(), becker);
        });
        works.add("momentum" + threads, [this, loop] {
            ours.balance_momentum<3>(fluid.view(), NoBoundary{}, fluid.radii(),
                                     fluid.state.positions.data(), loop);
        });
    }
};

Table times_of(const Medians& medians, const std::string& file, const Stages& stages) {
    const auto surface = std::count(stages.list.surface_class.begin(),
                                    stages.list.surface_class.end(), SurfaceClass::surface);
    Table table = table_of("surface-speed", "benchmark | median, ms {:.3f} | ns a particle {:.1f}");
    table.before = fmt::format("\n{}: {} particles, {} candidates, {} of them surface; {} "
                               "samples\n\n",
                               file, stages.fluid.size(), stages.list.size(), surface, samples);
    for (const auto& [name, seconds] : medians)
        table.add({name, seconds * 1e3, seconds * 1e9 / static_cast<double>(stages.fluid.size())});
    return table;
}

Tables surface_speed(const TableInput& input) {
    Tables tables;
    for (const auto& file : input.files) {
        const Fluid fluid{read_fluid_state_in_3d<float>(file)};
        Stages stages(fluid);
        Steps steps{fluid};
        ExactCoverage exact;
        Works works;
        steps.ours.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
        const auto add = [&](const auto& loop) {
            add_stages(stages, loop, works);
            steps.add(loop, works);
        };
        add(SerialLoop{});
        add(OpenMpLoop{2});
        add_references(fluid, stages, exact, works);
        const Medians medians = measure_by_name(works.all, input.timing);
        tables.push_back(times_of(medians, file.string(), stages));
        tables.push_back(ratios_of(
            medians,
            {{"whole step, against Becker 2007", "step/1", "becker/1"},
             {"whole step, against Becker 2007", "step/2", "becker/2"},
             {"whole step, speedup by a second thread", "step/1", "step/2"},
             {"classification, speedup over plain loops", "classify_reference", "classify/1"},
             {"coverage, speedup over plain loops", "expose_reference", "expose_verify/1"},
             {"momentum, part of the step", "momentum/2", "step/2"}}));
    }
    return tables;
}

} // namespace

TableGroup surface_speed_tables() {
    return {"Surface tension",
            {{"surface-speed", "SNAPSHOT...", 1, "the runtime's stages and step, and plain loops",
              surface_speed}}};
}

} // namespace meniscus
