// The paper's look-up table of 16,384 random directions in single precision (2020 paper, section
// 3.3), read in slices that begin where the particle's id says. Up to 16,384 samples a particle
// this is as good as random directions; beyond, the slice repeats the table and the error stops
// falling. Directions are brought to length 1 in double: float leaves them off by up to 1e-7, by
// which the test of coverage would shift every cap's edge.
#include "detail/sampling_schemes.hpp"

#include "direction_table.hpp"

#include <cmath>

namespace meniscus {
namespace {

/// The table of that seed; kept from call to call, since a run has one seed and many particles.
template <int Dimension>
const DirectionTable<Dimension>& table_of(std::uint64_t seed) {
    thread_local std::optional<DirectionTable<Dimension>> table;
    if (!table || table->seed() != seed)
        table.emplace(seed);
    return *table;
}

template <int Dimension>
void fill_from_table(std::uint64_t seed, std::uint64_t particle,
                     std::vector<Direction>& directions) {
    const auto& table = table_of<Dimension>(seed);
    std::size_t index = table.slice_begin(particle);
    for (Direction& direction : directions) {
        const auto& stored = table[index++];
        direction = {};
        double square = 0;
        for (int axis = 0; axis < Dimension; ++axis) {
            direction[axis] = stored[axis];
            square += direction[axis] * direction[axis];
        }
        const double length = std::sqrt(square);
        for (double& coordinate : direction)
            coordinate /= length;
    }
}

void fill_table(int dimension, std::uint64_t seed, std::uint64_t particle,
                std::vector<Direction>& directions) {
    if (dimension == 2)
        fill_from_table<2>(seed, particle, directions);
    else
        fill_from_table<3>(seed, particle, directions);
}

} // namespace

SchemeRow table_row() {
    return row_of({"table", true, fill_table});
}

} // namespace meniscus
