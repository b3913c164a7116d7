// How particles of a picture are colored: by a class, each with a color and a name, or by a number
// on a scale. The colors can be told apart by people of every color vision.
#pragma once

#include <meniscus/data/drawing/image.hpp>

#include <meniscus/data/particles/snapshot.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meniscus {

struct Coloring {
    std::vector<Color> colors;                          ///< one a particle
    std::string quantity;                               ///< what the colors stand for
    std::vector<std::pair<Color, std::string>> classes; ///< with their names; empty on a scale
    double low = 0;                                     ///< of the scale
    double high = 1;
    bool is_signed = false; ///< the scale goes from blue by way of gray to red, else it is viridis
};

/// A color of a scale at a share from 0 to 1.
Color scale_color(bool is_signed, double share);

/// Colors by `quantity`: "class", which is the class that classify has stored, else the label, else
/// one color for all; or point data by its name, vectors by their length. A scale goes from the
/// smallest value to the largest unless `range` says otherwise, and is symmetric about 0 where
/// values have both signs. Values that are not finite are gray. Throws InputError, naming all there
/// are, where there is no such point data.
Coloring coloring_of(const Snapshot& snapshot, const std::string& quantity,
                     const std::optional<std::pair<double, double>>& range);

} // namespace meniscus
