// The free-surface detectors of other codes, for the audit: what a solver's own flag would say of a
// snapshot. Each is a number a particle, its *response*, and a threshold that the user of that code
// sets; in the response stands what follows the threshold there, too (a cone, a second layer), so
// that the least threshold that would miss nothing can be read off. Plain and in double, for whole
// snapshots; bench/detectors/ has the same methods as fast as they can be made.
//
// Lengths are the snapshot's: its support radius is the kernel's, twice the smoothing length of all
// of these codes. Volumes are m / rho where a snapshot has arrays `mass` and `density`, as in those
// codes, else that of a particle at rest. Boundary particles count as neighbors, each with its own
// volume (data/particles/particle_volumes.hpp). docs/detectors.md names the sources.
#pragma once

#include <meniscus/classifier/model/classify_snapshot.hpp>

#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct DetectorKind {
    std::string name;                 ///< on the command line
    std::string method;               ///< for people, in a line
    std::string source;               ///< program or paper
    std::string quantity;             ///< that the threshold is on, with its unit
    std::optional<double> default_2d; ///< nothing where the code knows no plane
    double default_3d = 0;            ///< its authors' threshold
    double min_threshold = 0;
    double max_threshold = 0;
    bool surface_is_below = true; ///< of the threshold, else above

    /// For 2 or 3 dimensions; throws InputError where the code has none for it.
    [[nodiscard]] double default_threshold(int dimension) const;

    /// Whether a particle of that response is surface.
    [[nodiscard]] bool flags(double response, double threshold) const {
        return surface_is_below ? response < threshold : response > threshold;
    }
    /// By which responses and thresholds are multiplied for surface to lie below.
    [[nodiscard]] double sign() const { return surface_is_below ? 1 : -1; }
    /// A response that no threshold makes surface, and one that every threshold does.
    [[nodiscard]] double never() const;
    [[nodiscard]] double always() const { return -never(); }
};

/// dualsphysics, sphinxsys, chrono, marrone, barecasco.
const std::vector<DetectorKind>& detector_kinds();

/// The one of that name; throws InputError, listing them, where there is none.
const DetectorKind& detector_kind(const std::string& name);

/// One entry a particle, in the snapshot's order; 0 for those that are not valid. `neighborhoods`
/// are find_neighborhoods() with a boundary weight of 1. `threads` 0 takes all cores. Throws
/// InputError where radii vary, where the code knows no such dimension, or where a density is not
/// positive and finite.
std::vector<double> detector_responses(const DetectorKind& kind, const Snapshot& snapshot,
                                       const Neighborhoods& neighborhoods, int threads = 0);

} // namespace meniscus
