// Fluids that are hard on a surface classifier: degenerate ones (coincident particles, sheets one
// particle thick), ones on the limits of what counts as a neighbor, ones at the ends of the number
// range, and ones that no program can get right, which must be refused. Each says which of its
// particles must be surface and which interior, and why, by geometry alone: nothing that is tested
// takes part.
//
// Two arguments carry most of them, for a radius ratio of 0.8:
// - Open. The cap that a neighbor covers is largest where it stands at 0.6 h, 53.2 degrees. Where a
//   direction has no neighbor within that angle, it is uncovered: surface.
// - Closed. On a lattice with h between 1.6 and 2.75 spacings, the 26 lattice neighbors (in two
//   dimensions 8) cover everything, with degrees to spare: interior. With h = 2 spacings, all but
//   one of them do.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace meniscus::test {

/// What a particle must be. Those of which geometry says neither are `either`.
enum class Expected : std::uint8_t { either, interior, surface };

/// In which number type the case cannot be right, because the type does not hold its positions, or
/// because they are no numbers: the library must say so.
enum class Refused : std::uint8_t { never, in_float, always };

struct HardCase {
    std::string name;
    std::string why; ///< what is expected and why, in words
    int dimension = 3;
    double support_radius = 1;      ///< h in m
    Positions positions;            ///< m; z is 0 in two dimensions
    std::vector<double> masses;     ///< kg, one a particle; empty where all are equal
    Positions boundary;             ///< wall particles, m
    std::vector<Expected> expected; ///< one a particle
    /// lambda of every particle where one formula gives it, else negative.
    double uncovered_fraction = -1;
    Refused refused = Refused::never;
    /// Why the shipped line misses particles that must be surface; empty where it must not.
    std::string line_misses;

    [[nodiscard]] std::size_t size() const { return positions.size(); }
    /// True where positions rounded to Real (float or double) still are the case.
    template <class Real>
    [[nodiscard]] bool is_refused() const {
        return refused == Refused::always ||
               (refused == Refused::in_float && sizeof(Real) == sizeof(float));
    }
};

/// Lattices of the cases have a spacing of 1, or in scaled ones of half the support radius; m.
double spacing_of(const HardCase& hard_case);

/// All cases of a dimension of 2 or 3. Names are unique, of lower-case letters, digits and
/// underscores.
std::vector<HardCase> hard_cases(int dimension);

/// The case turned about its first particle, which comes to stand at the origin.
HardCase turned_about_first(const HardCase& hard_case, std::uint64_t seed);

/// The same as a snapshot, with `mass` where masses differ.
Snapshot snapshot_of(const HardCase& hard_case);

} // namespace meniscus::test
