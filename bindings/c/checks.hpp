// What comes in through the C interface, looked at before it is used. All throw
// std::invalid_argument, naming the argument or the member.
#pragma once

#include "meniscus.h"

#include <meniscus/bindings/step/surface_step.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace meniscus {

inline void demand(bool holds, const char* what) {
    if (!holds)
        throw std::invalid_argument(what);
}

/// Throws where a struct is NULL or of another version.
template <class Struct>
void check_struct(const Struct* given, const char* name) {
    if (given == nullptr)
        throw std::invalid_argument(std::string(name) + " is NULL");
    if (given->size != sizeof(Struct))
        throw std::invalid_argument(
            std::string(name) + ".size is " + std::to_string(given->size) + ", expected " +
            std::to_string(sizeof(Struct)) +
            ": not set, or the program was built with the meniscus.h of another version");
}

inline bool is_positive(double value) {
    return value > 0 && std::isfinite(value);
}

/// The stride, or the dimension where it is 0. Throws where it is less than that, or so large that
/// no array of `count` particles can be.
std::size_t checked_stride(const char* name, std::size_t stride, std::size_t dimension,
                           std::size_t count);

/// The most walls that a particle may be told of.
inline constexpr std::size_t max_walls = 1024;

/// What a handle takes.
struct ArrayKind {
    std::size_t dimension;
    bool is_double;
};

/// Throws where the particles cannot be read.
void check_particles(const meniscus_particles* particles, const ArrayKind& kind);

/// Throws, naming the first particle, where something is wrong with what checked particles hold.
void check_contents(const meniscus_particles& particles, const ArrayKind& kind);

/// Checked particles, as the step takes them.
StepParticles step_particles(const meniscus_particles& from);

} // namespace meniscus
