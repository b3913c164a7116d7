// Particles as balls, seen from afar (orthographic), the nearer in front of the farther: what a
// page or a paper shows of a state.
#pragma once

#include "coloring.hpp"
#include <meniscus/data/drawing/image.hpp>

#include <meniscus/data/particles/snapshot.hpp>

#include <optional>
#include <string>

namespace meniscus {

/// A plane across one axis; what lies beyond it, where the coordinate is larger, is left out, or
/// what lies before it.
struct Cut {
    std::size_t axis = 0;
    std::optional<double> place; ///< in m; nothing: the middle of the fluid
    bool keeps_larger = false;
};

struct PictureOptions {
    int width = 1200;
    int height = 800;
    double azimuth = 30;   ///< degrees to the right of the z axis that the picture is seen from
    double elevation = 20; ///< degrees above the plane of x and z; y is upward
    std::optional<Cut> cut;
    bool with_boundary = false;
    double diameter = 0; ///< of the balls, m
    std::string title;
};

/// Draws the particles whose positions are finite, with title and legend; states of two dimensions
/// from straight above, whatever the angles.
Image draw_particles(const Snapshot& snapshot, const Coloring& coloring,
                     const PictureOptions& options);

} // namespace meniscus
