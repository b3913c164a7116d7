// The colors of classes in pictures, plots and pages (there in report/page/src/style.css): Okabe
// and Ito's, which people of every color vision can tell apart.
#pragma once

#include <meniscus/data/drawing/image.hpp>

namespace meniscus {

inline constexpr Color interior_color = {0, 114, 178};
inline constexpr Color passed_color = {0, 158, 115}; ///< by the line, although not surface
inline constexpr Color surface_color = {213, 94, 0};

} // namespace meniscus
