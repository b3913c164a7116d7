// How many particles a scene will have and what they will take, from the volumes and areas of its
// shapes: known before a single one is placed, so that a slip of a unit is refused at once and not
// after minutes and gigabytes.
#pragma once

#include "scene.hpp"

namespace meniscus {

/// What is expected of a scene. Particles of snapshots are not counted: their files hold them.
struct SceneSize {
    double fluid = 0;  ///< particles
    double walls = 0;  ///< particles
    double memory = 0; ///< bytes that a run takes, roughly
};

/// A mesh whose file cannot be read counts as none. Throws InputError, naming the entry, where one
/// would have more than 5e8 particles.
SceneSize expected_size(const Scene& scene);

/// Bytes that this process may take: what the machine has, or less where a limit is set (ulimit -v,
/// control group).
double memory_limit();

/// Throws as expected_size() does, and FailureError, with numbers, where they would take more than
/// memory_limit().
void check_size(const Scene& scene);

} // namespace meniscus
