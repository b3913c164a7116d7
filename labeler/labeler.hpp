// Ground truth: decides, slowly and precisely, which particles of a snapshot are surface. Around
// each particle stands a sphere of radius r1 = h; the spheres of radius r2 around its neighbors
// cover part of it; what stays uncovered, as a fraction, is lambda, and the particle is surface
// where lambda > 0 (2020 paper, sections 3.1 and 3.2). In two dimensions spheres are circles.
#pragma once

#include <meniscus/data/snapshot.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

/// Uncovered fractions at or below this are zero: the rounding of double in the test of a single
/// direction, far below one sample.
inline constexpr double zero_uncovered_fraction = 1e-9;

struct LabelOptions {
    double radius_ratio = 0.8;     ///< r2 / r1, in (0, 1)
    std::size_t samples = 100000;  ///< directions a particle
    std::string scheme = "halton"; ///< name of a sampling scheme
    std::uint64_t seed = 0;        ///< 0: Halton's sequence as it is
    bool skip_invalid = false;     ///< leave particles with non-finite positions out
    int threads = 0;               ///< 0: all cores; the labels do not depend on it
    /// Called now and then from the calling thread with the number of particles done.
    std::function<void(std::size_t)> progress = {};
};

/// One entry a particle, in the snapshot's order.
struct Labels {
    std::vector<double> uncovered_fraction;    ///< lambda; 0 where not valid
    std::vector<std::uint8_t> surface;         ///< 1 where lambda > zero_uncovered_fraction
    std::vector<std::uint8_t> valid;           ///< 0 where left out
    std::vector<double> mass_offset;           ///< feature x (eq. 1)
    std::vector<std::uint32_t> neighbor_count; ///< feature y
};

/// Labels all particles with support radius `support_radius` (m). A `phase` array keeps phases
/// apart, a `mass` array weights the features, an `id` array keys random directions. Throws
/// InputError where an option is out of range, where a position is not finite (how many, and the
/// first index) unless skip_invalid, where a mass is not positive, or where the neighbor search
/// refuses.
Labels label_particles(const Snapshot& snapshot, double support_radius,
                       const LabelOptions& options);

/// Adds the labels as point data (uncovered_fraction, surface, valid, mass_offset, neighbor_count)
/// and says in the provenance how they were made: method, samples, scheme, seed, radius_ratio,
/// skip_invalid, label_bound, program.
void add_labels(Snapshot& snapshot, const Labels& labels, double support_radius,
                const LabelOptions& options);

/// The provenance entries that add_labels writes for these options.
std::map<std::string, std::string> label_provenance(double support_radius,
                                                    const LabelOptions& options);

/// Mean neighbor count over valid particles; 0 where there are none.
double mean_neighbor_count(const Labels& labels);

/// The mean neighbor counts that a sensible support radius gives: support radii from 1.5 to 3.2
/// particle spacings, a surface layer included. {lowest, highest}
std::array<double, 2> plausible_neighbor_counts(int dimension);

} // namespace meniscus
