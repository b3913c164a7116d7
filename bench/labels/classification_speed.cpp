// How fast labelling and classification are, as ratios within one run:
//   labels    Monte Carlo labels, fast kernel against the scalar reference, one thread against two
//   classify  the line over given neighbor lists against a loop that only gathers and adds
//   fused     the line inside a density loop against that loop alone
#include "density_loop.hpp"
#include "support/tables.hpp"

#include <meniscus/labeler/labeler.hpp>
#include <meniscus/labeler/monte_carlo/coverage.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace meniscus {
namespace {

constexpr std::size_t label_samples = 10000;

void label_fast(const Snapshot& snapshot, int threads) {
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = label_samples;
    options.threads = threads;
    benchmark::DoNotOptimize(label_particles(snapshot, *snapshot.support_radius, options));
}

/// What label_particles does, with the reference in place of the kernel.
void label_reference(const Snapshot& snapshot, const std::vector<Direction>& directions) {
    const double h = *snapshot.support_radius;
    const auto range = neighbor_range<double>(h, 0.8);
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

/// A state with masses, and with what the loops write.
template <class Real>
struct Host {
    FluidState<Real> fluid;
    std::vector<Real> masses;
    std::vector<Real> sums;
    std::vector<std::uint8_t> surface;

    explicit Host(FluidState<Real> state)
        : fluid(std::move(state)), masses(fluid.size(), Real(1)), sums(fluid.positions.size()),
          surface(fluid.size()) {}

    [[nodiscard]] CsrNeighborhood<Real, 3> view(bool equal_masses) const {
        auto view = fluid.template view<3>();
        view.masses = equal_masses ? nullptr : masses.data();
        return view;
    }
};

/// The baseline of classification: fetches every neighbor and adds up the displacements.
template <class Real>
void gather_and_add(Host<Real>& host) {
    const Real* positions = host.fluid.positions.data();
    const NeighborLists& lists = host.fluid.lists;
    for (std::size_t i = 0; i < host.fluid.size(); ++i) {
        Real sum[3] = {0, 0, 0};
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const std::size_t j = lists.neighbors[n];
            for (int axis = 0; axis < 3; ++axis)
                sum[axis] += positions[j * 3 + axis] - positions[i * 3 + axis];
        }
        for (int axis = 0; axis < 3; ++axis)
            host.sums[i * 3 + axis] = sum[axis];
    }
}

template <class Real, class View>
void classify_lists(Host<Real>& host, const View& view) {
    constexpr auto line = surface_line<Surface3D, Real>(2);
    const auto range = neighbor_range<Real>(host.fluid.support_radius, Surface3D::radius_ratio);
    classify<Real, 3>(view, 0, host.fluid.size(), host.fluid.support_radius, line, range,
                      host.surface.data());
}

/// Both lines, as the surface-tension step applies them.
template <class Real>
std::function<void()> two_lines(Host<Real>& host) {
    struct Stage {
        SurfaceTensionOptions options = completed({}, 3);
        ExposureMemory memory;
        SurfaceParticles<Real, 3> list;
    };
    const auto stage = std::make_shared<Stage>();
    return [&host, stage] {
        find_candidates<Real, 3>(host.view(true), NoBoundary{}, host.fluid.size(),
                                 UniformRadius<Real>{host.fluid.support_radius}, stage->options,
                                 SerialLoop{}, &stage->memory, stage->list);
    };
}

template <class Real, Fused fused>
void density_pass(Host<Real>& host) {
    density_loop<Real, fused>(host.fluid.positions.data(), host.masses.data(), host.fluid.lists,
                              host.fluid.size(), host.fluid.support_radius, host.sums.data(),
                              host.surface.data());
}

template <class Real>
void add_loops(const std::string& type, Host<Real>& host, std::vector<Timed>& all) {
    const auto add = [&](const std::string& name, std::function<void()> run) {
        all.push_back({std::move(run), false, name + "/" + type});
    };
    add("gather_and_add", [&] { gather_and_add(host); });
    add("classify", [&] { classify_lists(host, host.view(true)); });
    add("classify_two_lines", two_lines(host));
    add("classify_masses", [&] { classify_lists(host, host.view(false)); });
    add("classify_exact_lists",
        [&] { classify_lists(host, ExactCsrNeighborhood<Real, 3>{host.view(true)}); });
    add("classify_reference", [&] {
        const auto view = host.view(true); // not as a CSR view: the plain path
        classify_lists(host, [&](std::size_t i, auto&& visit) {
            view(i, std::forward<decltype(visit)>(visit));
        });
    });
    add("density", [&] { density_pass<Real, Fused::nothing>(host); });
    add("density_fused", [&] { density_pass<Real, Fused::equal_masses>(host); });
    add("density_fused_masses", [&] { density_pass<Real, Fused::masses>(host); });
}

std::vector<Ratio> ratios() {
    std::vector<Ratio> all = {
        {"fast labels, speedup over the scalar reference", "label_reference", "label/1_thread"},
        {"fast labels, speedup by a second thread", "label/1_thread", "label/2_threads"}};
    for (const std::string type : {"/float", "/double"}) {
        const auto add = [&](const char* what, const std::string& over, const std::string& under) {
            all.push_back({what, over + type, under + type});
        };
        add("classification over lists", "classify", "gather_and_add");
        add("the same, masses that differ", "classify_masses", "gather_and_add");
        add("the same, exact lists", "classify_exact_lists", "gather_and_add");
        add("the same, plain reference", "classify_reference", "gather_and_add");
        add("fused into a density loop", "density_fused", "density");
        add("the same, masses that differ", "density_fused_masses", "density");
    }
    return all;
}

Tables classification_speed(const TableInput& input) {
    const auto& file = input.files[0];
    const Snapshot snapshot = read_snapshot_in_3d(file);
    Host<float> in_float(fluid_state<float>(snapshot, file.string()));
    Host<double> in_double(fluid_state<double>(snapshot, file.string()));
    std::vector<Direction> directions(label_samples);
    sampling_scheme("halton").fill(3, 0, 0, directions);
    std::vector<Timed> all = {
        {[&] { label_reference(snapshot, directions); }, true, "label_reference"},
        {[&] { label_fast(snapshot, 1); }, false, "label/1_thread"},
        {[&] { label_fast(snapshot, 2); }, false, "label/2_threads"}};
    add_loops("float", in_float, all);
    add_loops("double", in_double, all);
    const Medians medians = measure_by_name(all, input.timing);
    Table table = table_of("speed", "benchmark | median, ms {:.3f}");
    table.before = fmt::format("{}: {} particles; labels with {} samples, {}\n\n", file.string(),
                               snapshot.size(), label_samples, name_of(instruction_set_up_to()));
    for (const auto& [name, seconds] : medians)
        table.add({name, 1e3 * seconds});
    return {table, ratios_of(medians, ratios())};
}

} // namespace

TableGroup classification_tables() {
    return {"Labels and classification",
            {{"speed", "SNAPSHOT", 1, "labels and classification, against plain loops",
              classification_speed}}};
}

} // namespace meniscus
