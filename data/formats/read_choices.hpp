// What the person who reads a file says of it, where the file leaves it open or in place of what it
// says: its dimension, which of its particles are fluid, which are walls, and which neither, and
// which of its states is meant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct ReadChoices {
    std::optional<int> dimension; ///< 2 or 3
    /// Each the name of an array of particles ("dam"), where the format has such, or point data and
    /// a value ("Type=3").
    std::vector<std::string> fluid;
    std::vector<std::string> walls;
    std::vector<std::string> ignored;
    /// All particles are of a boundary: none is told apart, and no plane is looked for.
    bool is_boundary = false;
    /// Which state of a file that holds several, from 0; without, the last.
    std::optional<std::uint64_t> frame = {};

    [[nodiscard]] bool choose_particles() const {
        return !fluid.empty() || !walls.empty() || !ignored.empty();
    }
};

} // namespace meniscus
