#include "labeler.hpp"

#include <meniscus/labeler/exact/exact_labels.hpp>
#include <meniscus/labeler/monte_carlo/coverage.hpp>

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>
#include <meniscus/runtime/features/scaled_features.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace meniscus {
namespace {

void check_options(const LabelOptions& options) {
    if (!(options.boundary_weight >= 0 && options.boundary_weight <= 10))
        throw InputError("boundary weight must lie between 0 and 10, found " +
                         number_text(options.boundary_weight));
    if (!(options.radius_ratio > 0 && options.radius_ratio < 1))
        throw InputError("radius ratio must lie between 0 and 1, found " +
                         number_text(options.radius_ratio));
    if (options.samples == 0)
        throw InputError("at least one sample a particle is needed");
}

/// What all particles share.
struct Work {
    SupportRadii radii = 0;
    std::size_t samples = 0;
    std::uint64_t seed = 0;
    int dimension = 3;
    SamplingScheme scheme;
    NeighborRange<double> range{}; ///< of radius 1 where radii vary
    double radius_ratio = 0;
    std::vector<std::uint8_t> valid;
    std::vector<double> masses;    ///< or empty
    std::vector<std::int64_t> ids; ///< or empty
    std::optional<NeighborGrid> grid;
    std::optional<PreparedBoundary> own_boundary;
    const PreparedBoundary* boundary = nullptr; ///< where there is one
    double spacing_ratio = 0;                   ///< measured_spacing_ratio()
    bool sums_kernels = false;                  ///< to measure it
    double boundary_share = 0;                  ///< of its weights
    LabelMethod method = LabelMethod::exact;
    std::vector<std::size_t> features; ///< beside the paper's
    DirectionBlocks table;             ///< empty where each particle draws its own directions
};

/// What each thread has of its own.
struct Workspace {
    FoundNeighbors found;
    Caps caps;
    std::unique_ptr<ExactLabels> exact = exact_labels();
    DirectionBlocks own_blocks;
    std::vector<Direction> own_directions;
    std::vector<FeatureNeighbor<double, 2>>
        in_the_plane; ///< that count, where features are asked for
    std::vector<FeatureNeighbor<double, 3>> in_space;

    template <int Dimension>
    auto& counted() {
        if constexpr (Dimension == 2)
            return in_the_plane;
        else
            return in_space;
    }
};

/// What the options say, and what the particles hold beside their positions; `work.valid` is set.
void set_common(Work& work, const Snapshot& snapshot, const SupportRadii& radii,
                const LabelOptions& options) {
    work.radii = radii;
    work.samples = options.samples;
    work.seed = options.seed;
    work.dimension = snapshot.dimension;
    work.method = options.method;
    work.features = options.features;
    work.range = neighbor_range<double>(radii.vary() ? 1 : radii.max, options.radius_ratio);
    work.radius_ratio = options.radius_ratio;
    work.boundary_share = options.boundary_weight;
    work.masses = checked_masses(snapshot, work.valid);
}

void set_directions(Work& work, const Snapshot& snapshot, const LabelOptions& options) {
    if (options.method != LabelMethod::monte_carlo)
        return;
    work.ids = integer_values(snapshot, "id", work.valid);
    work.scheme = sampling_scheme(options.scheme);
    if (!work.scheme.per_particle) {
        std::vector<Direction> directions(work.samples);
        work.scheme.fill(work.dimension, work.seed, 0, directions);
        work.table = compact_blocks(std::move(directions));
    }
}

/// Work points to the boundary that it holds, so that it stays where it is.
void prepare_work(Work& work, const Snapshot& snapshot, const SupportRadii& radii,
                  const LabelOptions& options) {
    check_options(options);
    work.valid = checked_positions(snapshot, radii, options.skip_invalid);
    set_common(work, snapshot, radii, options);
    if (const auto stored = stored_spacing_ratio(snapshot, work.radii))
        work.spacing_ratio = *stored;
    else if (is_spacing_needed_first(snapshot, options))
        work.spacing_ratio =
            measured_spacing_ratio(snapshot, work.radii, work.valid, options.threads);
    else
        work.sums_kernels = true;
    const auto phases = integer_values(snapshot, "phase", work.valid);
    work.grid.emplace(snapshot.positions, work.radii,
                      NeighborFilter{&work.valid, phases.empty() ? nullptr : &phases},
                      options.threads);
    if (!snapshot.boundary.empty()) {
        work.own_boundary.emplace(
            prepared_boundary(snapshot, radii, work.valid, work.spacing_ratio, options));
        work.boundary = &*work.own_boundary;
    }
    set_directions(work, snapshot, options);
}

void prepare_work(Work& work, const Snapshot& snapshot, const StatePart& part, double radius,
                  const LabelOptions& options) {
    check_options(options);
    work.valid.assign(snapshot.size(), 1);
    set_common(work, snapshot, radius, options);
    work.spacing_ratio = part.spacing_ratio;
    work.sums_kernels = part.wants_kernel_sums;
    const auto phases = integer_values(snapshot, "phase", work.valid);
    work.grid.emplace(snapshot.positions, part.layout,
                      NeighborFilter{&work.valid, phases.empty() ? nullptr : &phases},
                      options.threads);
    work.boundary = part.boundary;
    set_directions(work, snapshot, options);
    if (work.ids.empty())
        work.ids.assign(part.numbers.begin(), part.numbers.end());
}

double mass_of(const Work& work, std::size_t particle) {
    return work.masses.empty() ? 1 : work.masses[particle];
}

Direction in_radii(const Direction& displacement, double inverse_radius) {
    return {displacement[0] * inverse_radius, displacement[1] * inverse_radius,
            displacement[2] * inverse_radius};
}

/// Sets the features of particle i that are asked for, from the neighbors that count.
template <int Dimension>
void set_features(const Work& work, std::size_t i, Workspace& workspace, Labels& labels) {
    const auto& counted = workspace.counted<Dimension>();
    for (std::size_t f = 0; f < work.features.size(); ++f)
        labels.features[f][i] =
            feature_value<double, Dimension>(work.features[f], counted.data(), counted.size());
}

/// Adds a neighbor to those that count, where features are asked for.
template <int Dimension, class Radii>
void count_for_features(const Work& work, const Direction& displacement, double mass, std::size_t i,
                        std::size_t j, const Radii& radii, Workspace& workspace) {
    if (!work.features.empty())
        visit_if_in_range<Dimension>(
            displacement, mass, i, j, radii, work.range,
            [&](const auto& neighbor) { workspace.counted<Dimension>().push_back(neighbor); });
}

/// The same for a boundary particle.
template <int Dimension, class Radii>
void count_boundary(const Work& work, const Direction& displacement, double mean_mass,
                    double weight, std::size_t i, const Radii& radii, Workspace& workspace) {
    if (!work.features.empty())
        visit_if_in_range<Dimension>(displacement, weight * mean_mass, i, i, radii, work.range,
                                     [&](auto neighbor) {
                                         neighbor.count = weight;
                                         workspace.counted<Dimension>().push_back(neighbor);
                                     });
}

/// Gathers what covers particle i, which stands at a place of the grid, and its features, as
/// UniformRadius or VaryingRadii have it.
template <int Dimension, class Radii>
void gather(const Work& work, std::size_t place, std::size_t i, const Direction& center,
            const Radii& radii, Workspace& workspace, Labels& labels) {
    FoundNeighbors& found = workspace.found;
    FeatureSum<double, Dimension, double> sum;
    const auto cover = [&](const Direction& displacement, std::size_t j) {
        const Direction scaled = in_radii(displacement, radii.inverse_of_pair(i, j));
        // One radius is told apart in m, as its features are.
        const Direction& measured = Radii::varies ? scaled : displacement;
        if (work.range.contains(squared_length<double, 3>(measured)))
            workspace.caps.displacements.push_back(scaled);
    };
    work.grid->find(place, found);
    if (work.sums_kernels)
        labels.kernel_sums[i] = kernel_sum(found, i, work.radii, Dimension, true);
    for (std::size_t n = 0; n < found.size(); ++n) {
        const Direction& displacement = found.displacements[n];
        const std::size_t j = found.particles[n];
        const double mass = mass_of(work, j);
        if constexpr (Radii::varies)
            add_scaled(displacement, mass, i, j, radii, work.range, sum);
        else
            sum.add(displacement, squared_length<double, Dimension>(displacement), mass,
                    work.range);
        count_for_features<Dimension>(work, displacement, mass, i, j, radii, workspace);
        cover(displacement, j);
    }
    if (work.boundary != nullptr) {
        const double mean_mass = sum.count == 0 ? 1 : sum.mean_mass();
        work.boundary->grid.find_around(center, work.radii.of(i), found);
        for (std::size_t n = 0; n < found.size(); ++n) {
            const Direction& displacement = found.displacements[n];
            cover(displacement, i);
            if (work.boundary->weights.at_radius.empty())
                continue;
            const double weight =
                work.boundary_share *
                work.boundary->weights.of(found.particles[n], work.radii.of(i), Dimension);
            if constexpr (Radii::varies) {
                const Direction scaled = in_radii(displacement, radii.inverse_of_pair(i, i));
                sum.add_boundary(scaled, squared_length<double, Dimension>(scaled), weight,
                                 work.range);
            } else {
                sum.add_boundary(displacement, squared_length<double, Dimension>(displacement),
                                 weight, work.range);
            }
            count_boundary<Dimension>(work, displacement, mean_mass, weight, i, radii, workspace);
        }
    }
    labels.mass_offset[i] = mass_offset(sum, Radii::varies ? 1.0 : work.radii.max);
    labels.neighbor_count[i] = sum.count;
    set_features<Dimension>(work, i, workspace, labels);
}

template <int Dimension>
void gather(const Work& work, std::size_t place, std::size_t i, const Direction& center,
            Workspace& workspace, Labels& labels) {
    if (work.radii.vary())
        gather<Dimension>(work, place, i, center, VaryingRadii<double>{work.radii.each.data()},
                          workspace, labels);
    else
        gather<Dimension>(work, place, i, center, UniformRadius<double>{work.radii.max}, workspace,
                          labels);
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
    workspace.caps.radius_ratio = work.radius_ratio;
    workspace.caps.displacements.clear();
    workspace.in_the_plane.clear();
    workspace.in_space.clear();
    const Direction& center = snapshot.positions[i];
    if (work.dimension == 2)
        gather<2>(work, place, i, center, workspace, labels);
    else
        gather<3>(work, place, i, center, workspace, labels);
    if (work.method == LabelMethod::features_only)
        return;
    labels.uncovered_fraction[i] = work.method == LabelMethod::exact
                                       ? exact_fraction(work, workspace)
                                       : sampled_fraction(work, i, workspace);
    labels.surface[i] = labels.uncovered_fraction[i] > zero_uncovered_fraction ? 1 : 0;
}

/// Runs work_on(begin, end, workspace) over all particles in parallel; reports progress from the
/// calling thread.
template <class WorkOn>
void for_all_particles(std::size_t count, const LabelOptions& options, WorkOn&& work_on) {
    const auto loop = loop_over(options.threads);
    std::vector<Workspace> workspaces(loop.workers());
    std::atomic<std::size_t> done{0};
    loop(count, [&](std::size_t begin, std::size_t end, int worker) {
        work_on(begin, end, workspaces[worker]);
        done += end - begin;
        if (options.progress && worker == 0)
            options.progress(done);
    });
}

/// 17 digits, not as few as read back to the same value: these bytes are part of what a labelled
/// file is recognized by.
std::string provenance_number(double value) {
    return rounded_text(value, 17);
}

/// Not one of the paper's, which are always stored.
bool is_other_feature(std::size_t feature) {
    return feature < feature_count && feature != FeaturePair{}.first &&
           feature != FeaturePair{}.second;
}

void remove_other_features(Snapshot& snapshot) {
    auto& arrays = snapshot.point_data;
    arrays.erase(std::remove_if(arrays.begin(), arrays.end(),
                                [](const PointArray& array) {
                                    return is_other_feature(find_feature(array.name));
                                }),
                 arrays.end());
}

Labels empty_labels(const Work& work, std::size_t count) {
    Labels labels;
    labels.uncovered_fraction.assign(count, 0);
    labels.surface.assign(count, 0);
    labels.valid = work.valid;
    labels.spacing_ratio = work.spacing_ratio;
    labels.mass_offset.assign(count, 0);
    labels.neighbor_count.assign(count, 0);
    labels.features.assign(work.features.size(), std::vector<double>(count, 0));
    if (work.sums_kernels)
        labels.kernel_sums.assign(count, std::numeric_limits<double>::quiet_NaN());
    return labels;
}

/// By the sums of all particles or, where all of them are in crowds, with these.
double spacing_by_sums(const Work& work, const Snapshot& snapshot, std::vector<double> sums,
                       const LabelOptions& options) {
    if (const auto ratio = spacing_ratio_of_sums(std::move(sums), snapshot, work.radii))
        return *ratio;
    return spacing_ratio_of_sums(
               kernel_sums(*work.grid, work.radii, work.dimension, options.threads, false),
               snapshot, work.radii)
        .value_or(1);
}

} // namespace

bool is_spacing_needed_first(const Snapshot& outline, const LabelOptions& options) {
    return find_array(outline, "phase") != nullptr ||
           (!outline.boundary.empty() && options.boundary_weight > 0);
}

PreparedBoundary prepared_boundary(const Snapshot& snapshot, const SupportRadii& radii,
                                   const std::vector<std::uint8_t>& valid, double spacing_ratio,
                                   const LabelOptions& options) {
    check_boundary(snapshot);
    PreparedBoundary boundary{
        NeighborGrid(snapshot.boundary, radii.min, NeighborFilter{}, options.threads), {}};
    if (options.boundary_weight > 0)
        boundary.weights = boundary_weights(snapshot, radii, valid, spacing_ratio, options.threads);
    return boundary;
}

Labels label_particles(const Snapshot& snapshot, const SupportRadii& radii,
                       const LabelOptions& options) {
    Work work;
    prepare_work(work, snapshot, radii, options);
    Labels labels = empty_labels(work, snapshot.size());
    if (auto doubt = doubtful_positions(snapshot, radii, work.valid); !doubt.empty())
        labels.warnings.push_back(std::move(doubt));
    // In the grid's order, where the neighbors of one particle are those of the next.
    for_all_particles(work.grid->size(), options,
                      [&](std::size_t begin, std::size_t end, Workspace& workspace) {
                          for (std::size_t place = begin; place < end; ++place)
                              label_particle(work, snapshot, place, workspace, labels);
                      });
    if (work.sums_kernels)
        labels.spacing_ratio =
            spacing_by_sums(work, snapshot, std::exchange(labels.kernel_sums, {}), options);
    return labels;
}

Labels label_part(const Snapshot& snapshot, const StatePart& part, double radius,
                  const LabelOptions& options) {
    Work work;
    prepare_work(work, snapshot, part, radius, options);
    Labels labels = empty_labels(work, snapshot.size());
    for_all_particles(work.grid->size(), options,
                      [&](std::size_t begin, std::size_t end, Workspace& workspace) {
                          for (std::size_t place = begin; place < end; ++place)
                              if (part.own[work.grid->particle(place)] != 0)
                                  label_particle(work, snapshot, place, workspace, labels);
                      });
    return labels;
}

void set_label_provenance(Snapshot& snapshot, const SupportRadii& radii,
                          const LabelOptions& options) {
    auto& provenance = snapshot.provenance;
    provenance["program"] = std::string("meniscus ") + program_version;
    for (const char* name :
         {"samples", "scheme", "seed", "boundary_particles", "boundary_rule", "features"})
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
    for (const std::size_t feature : options.features)
        provenance["features"] +=
            (provenance["features"].empty() ? "" : ",") + std::string(feature_list[feature].name);
    provenance["boundary_weight"] = number_text(options.boundary_weight);
    if (!snapshot.particle_volume)
        provenance["particle_volume"] = "measured";
    provenance["radius_ratio"] = provenance_number(options.radius_ratio);
    provenance["support_radius"] = provenance_number(radii.min);
    if (radii.vary())
        provenance["support_radius"] += " to " + provenance_number(radii.max);
    provenance["neighbor_band"] = provenance_number(neighbor_band);
    provenance["label_bound"] = provenance_number(zero_uncovered_fraction);
    provenance["skip_invalid"] = options.skip_invalid ? "yes" : "no";
}

void add_labels(Snapshot& snapshot, const Labels& labels, const SupportRadii& radii,
                const LabelOptions& options) {
    if (radii.vary())
        snapshot.support_radius.reset();
    else
        snapshot.support_radius = radii.max;
    // As it is stored already, perhaps in float, it stays.
    if (radii.vary() && (find_array(snapshot, "support_radius") == nullptr ||
                         scalar_values(snapshot, "support_radius") != radii.each))
        set_array(snapshot, {"support_radius", 1, radii.each});
    remove_other_features(snapshot);
    set_array(snapshot, {"uncovered_fraction", 1, labels.uncovered_fraction});
    set_array(snapshot, {"surface", 1, stored_classes(labels.surface)});
    set_array(snapshot, {"valid", 1, stored_classes(labels.valid)});
    set_array(snapshot, {"mass_offset", 1, labels.mass_offset});
    if (has_real_counts(snapshot, radii, options))
        set_array(snapshot, {"neighbor_count", 1, labels.neighbor_count});
    else
        set_array(snapshot, {"neighbor_count", 1,
                             std::vector<std::uint32_t>(labels.neighbor_count.begin(),
                                                        labels.neighbor_count.end())});
    for (std::size_t f = 0; f < labels.features.size(); ++f)
        if (is_other_feature(options.features[f]))
            set_array(snapshot, {feature_list[options.features[f]].name, 1, labels.features[f]});
    set_label_provenance(snapshot, radii, options);
    if (!radii.vary() && !snapshot.particle_volume)
        snapshot.particle_volume = std::pow(radii.max / labels.spacing_ratio, snapshot.dimension);
}

bool has_real_counts(const Snapshot& snapshot, const SupportRadii& radii,
                     const LabelOptions& options) {
    return radii.vary() || (options.boundary_weight > 0 && !snapshot.boundary.empty());
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
        return {4, 75};
    return {8, 450};
}

} // namespace meniscus
