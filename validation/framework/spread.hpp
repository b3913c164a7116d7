// Runs that are chaotic come out otherwise from a start that differs by next to nothing. A study
// shows how far by an axis "seed", whose runs differ in nothing else, and looks at all of them
// together.
#pragma once

#include "study.hpp"

#include <meniscus/sph/scene/scene.hpp>

#include <string>
#include <vector>

namespace meniscus {

/// The scene with its last body of fluid moved by a thousandth of a spacing in the plane of x and
/// z, to another side for each seed; seed 0 is the scene itself.
Scene disturbed(Scene scene, double seed);

/// Runs of a result that differ in their seed alone.
struct Seeds {
    std::vector<std::string> labels; ///< values of the axes asked for
    std::vector<const Json*> runs;   ///< of the result, which must outlive this

    /// Of the runs that have the figure.
    [[nodiscard]] std::vector<double> values(const std::string& figure) const;
};

/// The runs of a result by their values of these axes, in the order of the first of each.
std::vector<Seeds> by_seeds(const Json& result, const std::vector<std::string>& axes);

/// A row for each Seeds: the values of the axes, how many runs came to their end, and mean, least
/// and most of these figures, named as table_of_runs() takes them.
Table table_of_spread(const std::string& name, const Json& result, const std::string& axes,
                      const std::string& figures);

} // namespace meniscus
