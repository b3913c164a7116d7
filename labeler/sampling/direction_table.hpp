// A table of precomputed random directions in single precision (2020 paper, section 3.3: 16,384 of
// them, read by index modulo the table's size). Looking directions up is cheaper than drawing them.
// Each particle reads a slice that begins at an index of its own, so that particles do not share
// their error; a slice longer than the table repeats it, and more samples than that gain nothing.
#pragma once

#include <meniscus/runtime/math/random_directions.hpp>

#include <cstddef>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <int Dimension>
class DirectionTable {
public:
    static constexpr std::size_t size = 16384;

    /// Draws the directions; another seed makes another table. Allocates size * Dimension floats.
    explicit DirectionTable(std::uint64_t seed = 0) : seed_(seed), directions_(size) {
        RandomDirections random(seed, table_stream);
        for (auto& direction : directions_) {
            const auto exact = random.next<Dimension>();
            for (int axis = 0; axis < Dimension; ++axis)
                direction[axis] = static_cast<float>(exact[axis]);
        }
    }

    /// The direction at `index` modulo the table's size; its length is 1 within 1e-7.
    const std::array<float, Dimension>& operator[](std::size_t index) const {
        return directions_[index % size];
    }

    /// Where the slice of a particle begins, by its id.
    [[nodiscard]] std::size_t slice_begin(std::uint64_t particle) const {
        return mix_bits(mix_bits(seed_) ^ particle) % size;
    }

    [[nodiscard]] std::uint64_t seed() const { return seed_; }

private:
    /// Keeps the table's stream apart from those of particles.
    static constexpr std::uint64_t table_stream = 0x7461626c65ULL;

    std::uint64_t seed_;
    std::vector<std::array<float, Dimension>> directions_;
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
