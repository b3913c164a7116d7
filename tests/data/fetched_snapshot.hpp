// A snapshot in memory that is fetched part by part, as what is larger than memory is written.
#pragma once

#include <meniscus/data/formats/vtkhdf.hpp>

#include <type_traits>
#include <variant>

namespace meniscus {

/// Some of the values of an array: those of `count` particles from `first` on.
inline ArrayValues some_of(const PointArray& array, std::uint64_t first, std::uint64_t count) {
    return std::visit(
        [&](const auto& values) -> ArrayValues {
            const auto width = static_cast<std::uint64_t>(array.components);
            const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first * width);
            return std::decay_t<decltype(values)>(
                begin, begin + static_cast<std::ptrdiff_t>(count * width));
        },
        array.values);
}

/// Of a snapshot that must outlive it.
inline FetchedSnapshot fetched_from(const Snapshot& snapshot, std::uint64_t rows_at_once) {
    FetchedSnapshot fetched;
    fetched.frame = snapshot;
    fetched.frame.positions.clear();
    for (PointArray& array : fetched.frame.point_data)
        std::visit([](auto& values) { values.clear(); }, array.values);
    fetched.size = snapshot.size();
    fetched.rows_at_once = rows_at_once;
    fetched.positions = [&snapshot](std::uint64_t first, std::uint64_t count) {
        const auto begin = snapshot.positions.begin() + static_cast<std::ptrdiff_t>(first);
        return Positions(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    fetched.values = [&snapshot](std::size_t place, std::uint64_t first, std::uint64_t count) {
        return some_of(snapshot.point_data[place], first, count);
    };
    return fetched;
}

} // namespace meniscus
