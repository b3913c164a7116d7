// Values for tests of the table of options: another one within the range, and those out of it.
#pragma once

#include <meniscus/runtime/surface/option_table.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace meniscus {

/// Sets the option to another value within its range.
template <class Value>
void set_other(const SurfaceOption<Value>& option, SurfaceTensionOptions& options) {
    Value& value = options.*option.member;
    if constexpr (std::is_enum_v<Value>)
        value = static_cast<Value>(1 - static_cast<int>(value));
    else if constexpr (std::is_integral_v<Value>)
        value += 1;
    else
        value = 0.3 + value / 2;
}

/// The values next to the ends of its range, and what is no number.
template <class Value>
std::vector<Value> values_out_of_range(const SurfaceOption<Value>& option) {
    const double min = option.range.min;
    const double max = option.range.max;
    if constexpr (std::is_floating_point_v<Value>) {
        const double infinity = std::numeric_limits<double>::infinity();
        return {std::nextafter(min, -infinity), std::nextafter(max, infinity), infinity,
                std::numeric_limits<double>::quiet_NaN()};
    } else if (max > 1e19) { // every value of a seed is in range
        return {};
    } else {
        return {static_cast<Value>(static_cast<long>(min) - 1),
                static_cast<Value>(static_cast<long>(max) + 1)};
    }
}

/// What an error says of the range: all words of it.
inline std::vector<std::string> words_of(const OptionRange& range) {
    if (range.words[0] != nullptr)
        return {range.words[0], range.words[1]};
    return {range.text};
}

} // namespace meniscus
