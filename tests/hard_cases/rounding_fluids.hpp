// The fluids on which the rounding band is measured and tested.
#pragma once

#include "neighborhoods.hpp"
#include "rounding.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <filesystem>
#include <functional>

namespace meniscus::test {

/// The fluid with coordinates that float holds, and no walls.
inline HardCase in_float(HardCase fluid) {
    fluid.positions = rounded_to<float>(fluid.positions);
    fluid.support_radius = static_cast<double>(static_cast<float>(fluid.support_radius));
    fluid.boundary.clear();
    fluid.masses.clear();
    return fluid;
}

/// All hard cases that float can hold.
inline void for_hard_cases(const std::function<void(const HardCase&)>& visit) {
    for (const int dimension : {2, 3})
        for (const HardCase& hard_case : hard_cases(dimension))
            if (!hard_case.is_refused<float>())
                visit(in_float(hard_case));
}

/// Random neighborhoods as small fluids.
inline void for_random_fluids(std::uint64_t count,
                              const std::function<void(const HardCase&)>& visit) {
    for (const int dimension : {2, 3})
        for (std::uint64_t number = 0; number < count; ++number) {
            HardCase fluid;
            fluid.dimension = dimension;
            fluid.positions = neighborhood(dimension, 6000000 + number).neighbors;
            fluid.positions.push_back({0, 0, 0});
            visit(in_float(fluid));
        }
}

/// The sample snapshots of a folder; all, or those of fewer than so many particles.
inline void for_samples(const std::filesystem::path& folder, std::size_t fewer_than,
                        const std::function<void(const HardCase&)>& visit) {
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        if (file.path().extension() != ".vtkhdf")
            continue;
        const Snapshot snapshot = read_vtkhdf(file.path());
        if (!snapshot.support_radius || snapshot.size() >= fewer_than)
            continue;
        HardCase fluid;
        fluid.name = file.path().stem().string();
        fluid.dimension = snapshot.dimension;
        fluid.positions = snapshot.positions;
        fluid.support_radius = *snapshot.support_radius;
        visit(in_float(fluid));
    }
}

} // namespace meniscus::test
