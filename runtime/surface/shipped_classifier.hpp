// The classifier that comes with the project: for each dimension a few, each for a range of support
// radius over particle spacing, of which the options' own picks one. Each is a line in the paper's
// plane and a second one for its candidates, with boundary particles that count.
#pragma once

#include "../coefficients/surface_2d.hpp"
#include "../coefficients/surface_2d_wide.hpp"
#include "../coefficients/surface_2d_widest.hpp"
#include "../coefficients/surface_3d.hpp"
#include "../coefficients/surface_3d_wide.hpp"
#include "../coefficients/surface_3d_widest.hpp"
#include "option_table.hpp"

#include <algorithm>
#include <cstdio>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

namespace shipped_classifier {

/// How far a ratio may lie outside of the trained ranges: masses differ by as much in practice.
inline constexpr double tolerance = 0.06;

inline void refuse_ratio(double ratio, double min, double max) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "spacing_ratio is %.4g, and the classifier that ships was trained for %.3g to "
                  "%.3g: give k and d of a line of your own",
                  ratio, min, max);
    refuse(text);
}

/// Sets the last of the classifiers whose range begins below the ratio: between two ranges the one
/// for smaller ratios, which lets more through there. Below all of them the first as it is at its
/// smallest: fewer neighbors make candidates, so it misses none.
template <class First, class Second, class Third>
void set_by_ratio(SurfaceTensionOptions& options) {
    const double ratio = options.spacing_ratio;
    if (is_finite(ratio) && ratio > Third::max_spacing_ratio * (1 + tolerance))
        refuse_ratio(ratio, First::min_spacing_ratio, Third::max_spacing_ratio);
    options.spacing_ratio = (std::max)(ratio, First::min_spacing_ratio);
    if (ratio < Second::min_spacing_ratio * (1 - tolerance))
        set_classifier<First>(options);
    else if (ratio < Third::min_spacing_ratio * (1 - tolerance))
        set_classifier<Second>(options);
    else
        set_classifier<Third>(options);
    options.spacing_ratio = ratio;
}

} // namespace shipped_classifier

/// Sets the one for 2 or 3 dimensions and the options' spacing_ratio. Throws std::invalid_argument
/// (errors.hpp) above what they were trained on.
inline void set_shipped_classifier(SurfaceTensionOptions& options, int dimension) {
    using namespace shipped_classifier;
    if (dimension == 2)
        set_by_ratio<Surface2D, Surface2DWide, Surface2DWidest>(options);
    else
        set_by_ratio<Surface3D, Surface3DWide, Surface3DWidest>(options);
}

/// The first line of it, for hosts that apply it in their density loop, at so many spacings.
inline SurfaceLine<double> shipped_first_line(int dimension, double spacing_ratio) {
    SurfaceTensionOptions options;
    options.spacing_ratio = spacing_ratio;
    set_shipped_classifier(options, dimension);
    return {options.k, options.d};
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
