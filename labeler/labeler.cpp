#include "labeler.hpp"

#include "coverage.hpp"

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
    NeighborLists lists;
    DirectionBlocks table; ///< empty where each particle draws its own directions
};

/// What each thread has of its own.
struct Workspace {
    Caps caps;
    DirectionBlocks own_blocks;
    std::vector<Direction> own_directions;
};

Work prepare_work(const Snapshot& snapshot, double support_radius, const LabelOptions& options) {
    check_options(options);
    Work work;
    work.support_radius = support_radius;
    work.samples = options.samples;
    work.seed = options.seed;
    work.dimension = snapshot.dimension;
    work.scheme = sampling_scheme(options.scheme);
    work.range = neighbor_range<double>(support_radius, options.radius_ratio);
    work.radius_ratio = options.radius_ratio;
    work.valid = checked_positions(snapshot, options.skip_invalid);
    work.masses = checked_masses(snapshot, work.valid);
    work.ids = integer_values(snapshot, "id", work.valid);
    const auto phases = integer_values(snapshot, "phase", work.valid);
    work.lists = find_neighbors(snapshot.positions, support_radius,
                                {&work.valid, phases.empty() ? nullptr : &phases}, options.threads);
    if (!work.scheme.per_particle) {
        std::vector<Direction> directions(work.samples);
        work.scheme.fill(work.dimension, work.seed, 0, directions);
        work.table = compact_blocks(std::move(directions));
    }
    return work;
}

/// Gathers the neighbors of particle i: the caps and the features.
void gather_neighbors(const Work& work, const CsrNeighborhood<double, 3>& view, std::size_t i,
                      Caps& caps, Labels& labels) {
    caps.radius_ratio = work.radius_ratio;
    caps.displacements.clear();
    FeatureSum<double, 3> sum;
    view(i, [&](std::size_t, const Direction& displacement, double mass) {
        const double distance_squared = displacement[0] * displacement[0] +
                                        displacement[1] * displacement[1] +
                                        displacement[2] * displacement[2];
        sum.add(displacement, distance_squared, mass, work.range);
        if (work.range.contains(distance_squared))
            caps.displacements.push_back({displacement[0] / work.support_radius,
                                          displacement[1] / work.support_radius,
                                          displacement[2] / work.support_radius});
    });
    labels.mass_offset[i] = mass_offset(sum, work.support_radius);
    labels.neighbor_count[i] = static_cast<std::uint32_t>(sum.count);
}

void label_particle(const Work& work, const CsrNeighborhood<double, 3>& view, std::size_t i,
                    Workspace& workspace, Labels& labels) {
    gather_neighbors(work, view, i, workspace.caps, labels);
    const DirectionBlocks* blocks = &work.table;
    if (work.scheme.per_particle) {
        workspace.own_directions.resize(work.samples);
        const auto key = work.ids.empty() ? i : static_cast<std::uint64_t>(work.ids[i]);
        work.scheme.fill(work.dimension, work.seed, key, workspace.own_directions);
        plain_blocks(workspace.own_directions, workspace.own_blocks);
        blocks = &workspace.own_blocks;
    }
    const std::size_t uncovered = count_uncovered(*blocks, workspace.caps);
    labels.uncovered_fraction[i] =
        static_cast<double>(uncovered) / static_cast<double>(work.samples);
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
    if (count == 0)
        return labels;
    const CsrNeighborhood<double, 3> view{snapshot.positions[0].data(),
                                          work.masses.empty() ? nullptr : work.masses.data(),
                                          work.lists.offsets.data(), work.lists.neighbors.data()};
    for_all_particles(count, options,
                      [&](std::size_t begin, std::size_t end, Workspace& workspace) {
                          for (std::size_t i = begin; i < end; ++i)
                              if (work.valid[i] != 0)
                                  label_particle(work, view, i, workspace, labels);
                      });
    return labels;
}

std::map<std::string, std::string> label_provenance(double support_radius,
                                                    const LabelOptions& options) {
    return {{"program", std::string("meniscus ") + program_version},
            {"method", "monte-carlo"},
            {"samples", std::to_string(options.samples)},
            {"scheme", options.scheme},
            {"seed", std::to_string(options.seed)},
            {"radius_ratio", provenance_number(options.radius_ratio)},
            {"support_radius", provenance_number(support_radius)},
            {"neighbor_band", provenance_number(neighbor_band)},
            {"label_bound", provenance_number(zero_uncovered_fraction)},
            {"skip_invalid", options.skip_invalid ? "yes" : "no"}};
}

void add_labels(Snapshot& snapshot, const Labels& labels, double support_radius,
                const LabelOptions& options) {
    snapshot.support_radius = support_radius;
    set_array(snapshot, {"uncovered_fraction", 1, labels.uncovered_fraction});
    set_array(snapshot, {"surface", 1, labels.surface});
    set_array(snapshot, {"valid", 1, labels.valid});
    set_array(snapshot, {"mass_offset", 1, labels.mass_offset});
    set_array(snapshot, {"neighbor_count", 1, labels.neighbor_count});
    for (const auto& [name, value] : label_provenance(support_radius, options))
        snapshot.provenance[name] = value;
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
