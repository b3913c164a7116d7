// Ground truth: decides, slowly and precisely, which particles of a snapshot are surface. Around
// each particle stands a sphere of radius r1 = h; the spheres of radius r2 around its neighbors
// cover part of it; what stays uncovered, as a fraction, is lambda, and the particle is surface
// where lambda > 0 (2020 paper, sections 3.1 and 3.2). In two dimensions spheres are circles.
#pragma once

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/particles/support_radii.hpp>
#include <meniscus/data/slabs/part_of_state.hpp>
#include <meniscus/runtime/coverage/exact_coverage.hpp>
#include <meniscus/runtime/features/list.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

/// How lambda is found: by the arcs that bound the uncovered part, or as the uncovered share of
/// many directions. Or not at all, where only features are wanted: lambda is 0 then, and
/// there is nothing for add_labels.
enum class LabelMethod { exact, monte_carlo, features_only };

struct LabelOptions {
    LabelMethod method = LabelMethod::exact;
    double radius_ratio = 0.8;              ///< r2 / r1, in (0, 1)
    std::size_t samples = 100000;           ///< Monte Carlo: directions a particle
    std::string scheme = "halton";          ///< Monte Carlo: name of a sampling scheme
    std::uint64_t seed = 0;                 ///< Monte Carlo; 0: Halton's sequence as it is
    std::vector<std::size_t> features = {}; ///< places in feature_list, beside the paper's
    /// The share of its volume by which a boundary particle counts in the features; 0: it only
    /// covers.
    double boundary_weight = default_boundary_weight;
    bool skip_invalid = false; ///< leave out particles whose positions cannot be worked with
    int threads = 0;           ///< 0: all cores; the labels do not depend on it
    /// Called now and then from the calling thread with the number of particles done.
    std::function<void(std::size_t)> progress = {};
};

/// One entry a particle, in the snapshot's order.
struct Labels {
    std::vector<double> uncovered_fraction; ///< lambda; 0 where not valid
    std::vector<std::uint8_t> surface;      ///< 1 where lambda > zero_uncovered_fraction
    std::vector<std::uint8_t> valid;        ///< 0 where left out
    std::vector<double> mass_offset;        ///< feature x (eq. 1)
    std::vector<double> neighbor_count; ///< feature y; whole unless radii vary or a boundary counts
    std::vector<std::vector<double>> features; ///< of LabelOptions::features
    double spacing_ratio = 1; ///< measured_spacing_ratio() (data/particles/particle_volumes.hpp)
    std::vector<double> kernel_sums;   ///< that it comes from, where StatePart asks for them
    std::vector<std::string> warnings; ///< one line each, for standard error
};

/// Labels all particles with these support radii (support_radii() has those of a snapshot, a number
/// in m serves all). A `phase` array keeps phases apart, a `mass` array weights the features, an
/// `id` array keys random directions. The snapshot's boundary particles cover, whatever the phase:
/// a particle at a wall is not at the free surface. With boundary_weight they count in the features
/// too, whatever the phase, by that share of their volume (data/particles/particle_volumes.hpp).
/// Where radii vary, each pair is measured in its mean radius
/// (runtime/neighbors/support_radius.hpp, scaled_features.hpp), and a boundary particle has the
/// radius of the particle it is a neighbor of. Throws InputError where an option is out of range,
/// where a position is not finite, or too far from the origin for its number type
/// (checked_positions; how many, and the first index) unless skip_invalid, where a mass is not
/// positive, or where the neighbor search refuses; likewise for the boundary.
Labels label_particles(const Snapshot& snapshot, const SupportRadii& radii,
                       const LabelOptions& options);

/// Boundary particles made ready for all parts of a state.
struct PreparedBoundary {
    NeighborGrid grid;
    BoundaryWeights weights; ///< none where they count in no feature
};

/// The boundary of a snapshot, which must have one, for fluid particles with this support radius
/// (m) and spacing ratio. Throws InputError as label_particles does.
PreparedBoundary prepared_boundary(const Snapshot& snapshot, const SupportRadii& radii,
                                   const std::vector<std::uint8_t>& valid, double spacing_ratio,
                                   const LabelOptions& options);

/// Whether labels depend on the spacing ratio, or on neighbors that a kernel sum leaves out, so
/// that it must be known before; else it is measured as particles are labelled, by the same search.
bool is_spacing_needed_first(const Snapshot& outline, const LabelOptions& options);

/// What a part of a state takes over from the whole, which has one support radius, so that its
/// particles get the labels that they have there.
struct StatePart : PartOfState {
    double spacing_ratio = 1;                   ///< measured_spacing_ratio() of the whole
    const PreparedBoundary* boundary = nullptr; ///< where there is one
    bool wants_kernel_sums = false;             ///< in Labels
};

/// Labels the own particles of a part, which must be valid and have around them all that are closer
/// than their radius (m). The part's `boundary` is not looked at. Throws as label_particles does.
Labels label_part(const Snapshot& snapshot, const StatePart& part, double radius,
                  const LabelOptions& options);

/// Adds the labels as point data (uncovered_fraction, surface, valid, mass_offset, neighbor_count,
/// other features by their names), the radii as the snapshot's own, the volume of a particle where
/// it had to be measured, and set_label_provenance. What
/// an earlier labelling stored of features that are not asked for now is gone.
void add_labels(Snapshot& snapshot, const Labels& labels, const SupportRadii& radii,
                const LabelOptions& options);

/// Whether the file's neighbor counts are real numbers: radii vary, or a boundary counts.
bool has_real_counts(const Snapshot& snapshot, const SupportRadii& radii,
                     const LabelOptions& options);

/// Says in the provenance how the labels are made with these options: program, method, with Monte
/// Carlo samples, scheme and seed, radius_ratio, support_radius (smallest to largest where they
/// vary), neighbor_band, label_bound, skip_invalid, boundary_weight, particle_volume where it is
/// measured, boundary_particles where there are some, and features where others than the paper's
/// are stored. What an earlier labelling said is gone.
void set_label_provenance(Snapshot& snapshot, const SupportRadii& radii,
                          const LabelOptions& options);

/// Mean neighbor count over valid particles; 0 where there are none.
double mean_neighbor_count(const Labels& labels);

/// The mean neighbor counts that a sensible support radius gives: support radii from 1.5 to 4.7
/// particle spacings, a surface layer included. {lowest, highest}
std::array<double, 2> plausible_neighbor_counts(int dimension);

} // namespace meniscus
