// How fast exact labels are beside Monte Carlo ones, each label run as a whole, with its neighbor
// search and its features:
//   exact            lambda of every particle, on one thread and on two
//   exact_surface    surface or not, without lambda
//   exact_reference  lambda by exact_reference.hpp, without vectors and cells
//   samples_N        Monte Carlo with N directions a particle
#include "support/tables.hpp"

#include "reference/exact_reference.hpp"
#include <meniscus/labeler/exact/exact_labels.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/runtime/coverage/exact_coverage.hpp>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr double radius_ratio = 0.8;

/// What label_particles does, with `decide(displacements / h)` in place of lambda.
template <class Decide>
void label_otherwise(const Snapshot& snapshot, const Decide& decide) {
    const double h = *snapshot.support_radius;
    const auto range = neighbor_range<double>(h, radius_ratio);
    FoundNeighbors found;
    std::vector<Direction> displacements;
    std::vector<double> offsets(snapshot.size());
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
    benchmark::DoNotOptimize(offsets.data());
}

Timed labels(const std::string& name, const Snapshot& snapshot, const LabelOptions& options) {
    return {[&snapshot, options] {
                benchmark::DoNotOptimize(
                    label_particles(snapshot, *snapshot.support_radius, options));
            },
            false, name};
}

std::vector<Timed> all_timed(const Snapshot& snapshot) {
    LabelOptions exact;
    exact.threads = 1;
    LabelOptions exact_on_two = exact;
    exact_on_two.threads = 2;
    std::vector<Timed> all = {labels("exact/1", snapshot, exact),
                              labels("exact/2", snapshot, exact_on_two)};
    const std::shared_ptr<ExactLabels> finder = exact_labels();
    const auto is_uncovered = [finder](const std::vector<Direction>& displacements) {
        return finder->is_uncovered(3, displacements, radius_ratio);
    };
    const auto reference = [](const std::vector<Direction>& displacements) {
        return uncovered_fraction_reference(displacements, radius_ratio);
    };
    all.push_back(
        {[&, is_uncovered] { label_otherwise(snapshot, is_uncovered); }, false, "exact_surface"});
    all.push_back(
        {[&, reference] { label_otherwise(snapshot, reference); }, true, "exact_reference"});
    LabelOptions sampled = exact;
    sampled.method = LabelMethod::monte_carlo;
    for (const std::size_t samples : {1000, 10000, 100000}) {
        sampled.samples = samples;
        all.push_back(labels("samples_" + std::to_string(samples), snapshot, sampled));
    }
    return all;
}

/// How many particles need no arc to tell whether they are surface.
std::string settled_text(const Snapshot& snapshot) {
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
    return fmt::format("Settled by cells: {:.1f} % covered, {:.1f} % not; undecided {:.2f} %.",
                       counts[0], counts[1], counts[2]);
}

Tables label_speed(const TableInput& input) {
    Tables tables;
    for (const auto& file : input.files) {
        const Snapshot snapshot = read_snapshot_in_3d(file);
        const Medians medians = measure_by_name(all_timed(snapshot), input.timing);
        Table table = table_of("label-speed", "benchmark | median, ms {:.3f}");
        table.before = fmt::format("\n{}: {} particles. {}\n\n", file.string(), snapshot.size(),
                                   settled_text(snapshot));
        for (const auto& [name, seconds] : medians)
            table.add({name, 1e3 * seconds});
        tables.push_back(table);
        tables.push_back(ratios_of(
            medians, {{"surface or not, against 1000 samples", "exact_surface", "samples_1000"},
                      {"with lambda, against 10,000 samples", "exact/1", "samples_10000"},
                      {"speedup over the plain reference", "exact_reference", "exact/1"},
                      {"speedup by a second thread", "exact/1", "exact/2"}}));
    }
    return tables;
}

} // namespace

TableGroup label_speed_tables() {
    return {
        "Labels and classification",
        {{"label-speed", "SNAPSHOT...", 1, "exact labels beside Monte Carlo ones", label_speed}}};
}

} // namespace meniscus
