// Arrays of one number an axis. Dimensions are int, as users write them; sizes of arrays are not.
#pragma once

#include <array>
#include <cstddef>

namespace meniscus {

template <int Dimension>
inline constexpr auto axis_count = static_cast<std::size_t>(Dimension);

template <class Real, int Dimension>
using Coordinates = std::array<Real, axis_count<Dimension>>;

} // namespace meniscus
