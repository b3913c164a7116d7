// The names by which programs know the quantities that we use: DualSPHysics' `Rhop` is our
// `density`, Houdini's `v` our `velocity`. One table for all formats.
#pragma once

#include "snapshot.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace meniscus {

struct KnownName {
    std::string_view ours; ///< `velocity`, `density`, `mass`, `id`, `phase` or `support_radius`
    std::size_t rank;      ///< the smaller, the likelier that it is meant
};

/// What a name stands for, in letters of any case; nothing where it is none of those known.
std::optional<KnownName> known_name(std::string_view name);

/// Gives arrays our names, the likeliest where several have one meaning; others keep theirs. A
/// velocity becomes three components a particle, be it stored as two, or as one array each
/// ("vx", "vy", "vz"; "u", "v", "w").
void use_our_names(Snapshot& snapshot);

} // namespace meniscus
