// The one place that counts errors: predictions held against uncovered fractions, particle by
// particle. Training, audit and comparisons add up the same counts.
#pragma once

#include <array>
#include <cstddef>

namespace meniscus {

/// Particles whose uncovered fraction lies in (lower, upper], whatever the label threshold.
struct LambdaBand {
    double lower = 0;
    double upper = 1;
    std::size_t particles = 0;
    std::size_t missed = 0; ///< taken for interior
};

/// Numbers of particles.
struct ErrorCounts {
    std::size_t particles = 0;
    std::size_t surface_particles = 0; ///< by label: lambda above the threshold
    std::size_t false_negatives = 0;   ///< surface by label, taken for interior
    std::size_t false_positives = 0;   ///< not surface by label, taken for surface
    /// False positives of which some is uncovered after all (0 < lambda <= label threshold).
    std::size_t uncovered_false_positives = 0;
    double surface_area = 0; ///< sum of lambda over surface particles
    double missed_area = 0;  ///< sum of lambda over false negatives
    /// (0, 0.5 %], (0.5 %, 2 %], above 2 %.
    std::array<LambdaBand, 3> bands = {LambdaBand{0, 0.005, 0, 0}, LambdaBand{0.005, 0.02, 0, 0},
                                       LambdaBand{0.02, 1, 0, 0}};

    /// Counts one particle of uncovered fraction lambda.
    void add(double lambda, double label_threshold, bool predicted) {
        const bool surface = lambda > label_threshold;
        ++particles;
        surface_particles += surface ? 1 : 0;
        false_negatives += surface && !predicted ? 1 : 0;
        false_positives += !surface && predicted ? 1 : 0;
        uncovered_false_positives += !surface && predicted && lambda > 0 ? 1 : 0;
        surface_area += surface ? lambda : 0;
        missed_area += surface && !predicted ? lambda : 0;
        for (LambdaBand& band : bands)
            if (lambda > band.lower && lambda <= band.upper) {
                ++band.particles;
                band.missed += predicted ? 0 : 1;
            }
    }

    void add(const ErrorCounts& other) {
        particles += other.particles;
        surface_particles += other.surface_particles;
        false_negatives += other.false_negatives;
        false_positives += other.false_positives;
        uncovered_false_positives += other.uncovered_false_positives;
        surface_area += other.surface_area;
        missed_area += other.missed_area;
        for (std::size_t b = 0; b < bands.size(); ++b) {
            bands[b].particles += other.bands[b].particles;
            bands[b].missed += other.bands[b].missed;
        }
    }
};

/// part / whole; 0 where the whole is.
inline double fraction(double part, double whole) {
    return whole == 0 ? 0 : part / whole;
}
inline double fraction(std::size_t part, std::size_t whole) {
    return fraction(static_cast<double>(part), static_cast<double>(whole));
}

/// Over all particles, over those that are not surface by label, over the surface particles, and of
/// the missed area in that of the surface; 0 where there are none.
inline double false_positive_rate(const ErrorCounts& counts) {
    return fraction(counts.false_positives, counts.particles);
}
inline double false_positive_rate_interior(const ErrorCounts& counts) {
    return fraction(counts.false_positives, counts.particles - counts.surface_particles);
}
inline double false_negative_rate(const ErrorCounts& counts) {
    return fraction(counts.false_negatives, counts.surface_particles);
}
inline double missed_area_fraction(const ErrorCounts& counts) {
    return fraction(counts.missed_area, counts.surface_area);
}

} // namespace meniscus
