#include "labeler.hpp"

#include "coverage.hpp"
#include "exact_labels.hpp"

#include <meniscus/data/boundary_rule.hpp>
#include <meniscus/data/errors.hpp>
#include <meniscus/data/neighbor_search.hpp>
#include <meniscus/data/particle_arrays.hpp>
#include <meniscus/data/text.hpp>
#include <meniscus/runtime/features.hpp>
#include <meniscus/version.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <numeric>
#include <omp.h>
#include <optional>

namespace meniscus {
namespace {

void check_options(const LabelOptions& options) {
    if (!(options.radius_ratio > 0 && options.radius_ratio < 1))
        throw InputError("radius ratio must lie between 0 and 1, found " +
                         number_text(options.radius_ratio));
    if (options.samples == 0)
        throw InputError("at least one sample a particle is needed");
}

/// What all particles share.
struct Work {
    double support_radius = 0;
    std::size_t samples = 0;
    std::uint64_t seed = 0;
    int dimension = 3;
    SamplingScheme scheme;
    NeighborRange<double> range{};
    double radius_ratio = 0;
    std::vector<std::uint8_t> valid;
    std::vector<double> masses;    ///< or empty
    std::vector<std::int64_t> ids; ///< or empty
    std::optional<NeighborGrid> grid;
    std::optional<NeighborGrid> boundary; ///< where there is one
    bool boundary_counts = false;
    double boundary_mass = 1;
    LabelMethod method = LabelMethod::exact;
    DirectionBlocks table; ///< empty where each particle draws its own directions
};

/// What each thread has of its own.
struct Workspace {
    FoundNeighbors found;
    Caps caps;
    std::unique_ptr<ExactLabels> exact = exact_labels();
    DirectionBlocks own_blocks;
    std::vector<Direction> own_directions;
};

void sort_particles(Work& work, const Snapshot& snapshot, const LabelOptions& options) {
    const auto phases = integer_values(snapshot, "phase", work.valid);
    work.grid.emplace(snapshot.positions, work.support_radius,
                      NeighborFilter{&work.valid, phases.empty() ? nullptr : &phases},
                      options.threads);
    if (snapshot.boundary.empty())
        return;
    check_boundary(snapshot);
    work.boundary.emplace(snapshot.boundary, work.support_radius, NeighborFilter{},
                          options.threads);
    work.boundary_counts = options.boundary_counts;
    work.boundary_mass = mean_mass(work.masses, work.valid);
}

Work prepare_work(const Snapshot& snapshot, double support_radius, const LabelOptions& options) {
    check_options(options);
    Work work;
    work.support_radius = support_radius;
    work.samples = options.samples;
    work.seed = options.seed;
    work.dimension = snapshot.dimension;
    work.method = options.method;
    work.range = neighbor_range<double>(support_radius, options.radius_ratio);
    work.radius_ratio = options.radius_ratio;
    work.valid = checked_positions(snapshot, options.skip_invalid);
    work.masses = checked_masses(snapshot, work.valid);
    sort_particles(work, snapshot, options);
    if (options.method == LabelMethod::exact)
        return work;
    work.ids = integer_values(snapshot, "id", work.valid);
    work.scheme = sampling_scheme(options.scheme);
    if (!work.scheme.per_particle) {
        std::vector<Direction> directions(work.samples);
        work.scheme.fill(work.dimension, work.seed, 0, directions);
        work.table = compact_blocks(std::move(directions));
    }
    return work;
}

/// Gathers what covers the particle at a place of the grid, and its features.
void gather_neighbors(const Work& work, std::size_t place, const Direction& center,
                      Workspace& workspace, Labels& labels) {
    Caps& caps = workspace.caps;
    FoundNeighbors& found = workspace.found;
    caps.radius_ratio = work.radius_ratio;
    caps.displacements.clear();
    const double scale = 1 / work.support_radius;
    const auto add_coverer = [&](const Direction& x) {
        caps.displacements.push_back({x[0] * scale, x[1] * scale, x[2] * scale});
    };
    FeatureSum<double, 3> sum;
    work.grid->find(place, found);
    for (std::size_t n = 0; n < found.size(); ++n) {
        const Direction& displacement = found.displacements[n];
        const double distance_squared = squared_length<double, 3>(displacement);
        const double mass = work.masses.empty() ? 1 : work.masses[found.particles[n]];
        sum.add(displacement, distance_squared, mass, work.range);
        if (work.range.contains(distance_squared))
            add_coverer(displacement);
    }
    if (work.boundary) {
        work.boundary->find_around(center, found);
        for (const Direction& displacement : found.displacements) {
            const double distance_squared = squared_length<double, 3>(displacement);
            if (work.boundary_counts)
                sum.add(displacement, distance_squared, work.boundary_mass, work.range);
            if (work.range.contains(distance_squared))
                add_coverer(displacement);
        }
    }
    const std::size_t i = work.grid->particle(place);
    labels.mass_offset[i] = mass_offset(sum, work.support_radius);
    labels.neighbor_count[i] = static_cast<std::uint32_t>(sum.count);
}

double exact_fraction(const Work& work, Workspace& workspace) {
    const double fraction = workspace.exact->uncovered_fraction(
        work.dimension, workspace.caps.displacements, work.radius_ratio);
    return fraction > zero_uncovered_fraction ? fraction : 0;
}

double sampled_fraction(const Work& work, std::size_t i, Workspace& workspace) {
    const DirectionBlocks* blocks = &work.table;
    if (work.scheme.per_particle) {
        workspace.own_directions.resize(work.samples);
        const auto key = work.ids.empty() ? i : static_cast<std::uint64_t>(work.ids[i]);
        work.scheme.fill(work.dimension, work.seed, key, workspace.own_directions);
        plain_blocks(workspace.own_directions, workspace.own_blocks);
        blocks = &workspace.own_blocks;
    }
    const std::size_t uncovered = count_uncovered(*blocks, workspace.caps);
    return static_cast<double>(uncovered) / static_cast<double>(work.samples);
}

void label_particle(const Work& work, const Snapshot& snapshot, std::size_t place,
                    Workspace& workspace, Labels& labels) {
    const std::size_t i = work.grid->particle(place);
    gather_neighbors(work, place, snapshot.positions[i], workspace, labels);
    labels.uncovered_fraction[i] = work.method == LabelMethod::exact
                                       ? exact_fraction(work, workspace)
                                       : sampled_fraction(work, i, workspace);
    labels.surface[i] = labels.uncovered_fraction[i] > zero_uncovered_fraction ? 1 : 0;
}

/// Runs work_on(begin, end, workspace) over all particles in parallel; reports progress from the
/// calling thread.
template <class WorkOn>
void for_all_particles(std::size_t count, const LabelOptions& options, WorkOn&& work_on) {
    constexpr std::size_t chunk = 256;
    const auto chunks = static_cast<std::int64_t>((count + chunk - 1) / chunk);
    const int threads = options.threads > 0 ? options.threads : omp_get_max_threads();
    std::atomic<std::size_t> done{0};
    std::exception_ptr failure; // must not leave the parallel region on its own
#pragma omp parallel num_threads(threads)
    {
        Workspace workspace;
#pragma omp for schedule(dynamic)
        for (std::int64_t c = 0; c < chunks; ++c) {
            const std::size_t begin = static_cast<std::size_t>(c) * chunk;
            const std::size_t end = std::min(begin + chunk, count);
            try {
                work_on(begin, end, workspace);
                done += end - begin;
                if (options.progress && omp_get_thread_num() == 0)
                    options.progress(done);
            } catch (...) {
#pragma omp critical
                failure = std::current_exception();
            }
        }
    }
    if (failure)
        std::rethrow_exception(failure);
}

/// 17 digits, not as few as read back to the same value: these bytes are part of what a labelled
/// file is recognized by.
std::string provenance_number(double value) {
    return rounded_text(value, 17);
}

} // namespace

Labels label_particles(const Snapshot& snapshot, double support_radius,
                       const LabelOptions& options) {
    const Work work = prepare_work(snapshot, support_radius, options);
    const std::size_t count = snapshot.size();
    Labels labels;
    labels.uncovered_fraction.assign(count, 0);
    labels.surface.assign(count, 0);
    labels.valid = work.valid;
    labels.mass_offset.assign(count, 0);
    labels.neighbor_count.assign(count, 0);
    // In the grid's order, where the neighbors of one particle are those of the next.
    for_all_particles(work.grid->size(), options,
                      [&](std::size_t begin, std::size_t end, Workspace& workspace) {
                          for (std::size_t place = begin; place < end; ++place)
                              label_particle(work, snapshot, place, workspace, labels);
                      });
    return labels;
}

void set_label_provenance(Snapshot& snapshot, double support_radius, const LabelOptions& options) {
    auto& provenance = snapshot.provenance;
    provenance["program"] = std::string("meniscus ") + program_version;
    for (const char* name : {"samples", "scheme", "seed", "boundary_particles"})
        provenance.erase(name);
    if (options.method == LabelMethod::exact) {
        provenance["method"] = "exact";
    } else {
        provenance["method"] = "monte-carlo";
        provenance["samples"] = std::to_string(options.samples);
        provenance["scheme"] = options.scheme;
        provenance["seed"] = std::to_string(options.seed);
    }
    if (!snapshot.boundary.empty())
        provenance["boundary_particles"] = std::to_string(snapshot.boundary.size());
    provenance["boundary_rule"] = boundary_rule_text(options.boundary_counts);
    provenance["radius_ratio"] = provenance_number(options.radius_ratio);
    provenance["support_radius"] = provenance_number(support_radius);
    provenance["neighbor_band"] = provenance_number(neighbor_band);
    provenance["label_bound"] = provenance_number(zero_uncovered_fraction);
    provenance["skip_invalid"] = options.skip_invalid ? "yes" : "no";
}

void add_labels(Snapshot& snapshot, const Labels& labels, double support_radius,
                const LabelOptions& options) {
    snapshot.support_radius = support_radius;
    set_array(snapshot, {"uncovered_fraction", 1, labels.uncovered_fraction});
    set_array(snapshot, {"surface", 1, labels.surface});
    set_array(snapshot, {"valid", 1, labels.valid});
    set_array(snapshot, {"mass_offset", 1, labels.mass_offset});
    set_array(snapshot, {"neighbor_count", 1, labels.neighbor_count});
    set_label_provenance(snapshot, support_radius, options);
}

double mean_neighbor_count(const Labels& labels) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < labels.valid.size(); ++i)
        if (labels.valid[i] != 0) {
            sum += labels.neighbor_count[i];
            ++count;
        }
    return count == 0 ? 0 : sum / static_cast<double>(count);
}

std::array<double, 2> plausible_neighbor_counts(int dimension) {
    if (dimension == 2)
        return {4, 35};
    return {8, 140};
}

} // namespace meniscus
