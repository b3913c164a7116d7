// Houdini's classic binary geometry (`.bgeo`, version 5) as the Partio library writes it for
// particles, which is how SPlisHSPlasH's Partio exporter stores a state: points with attributes and
// nothing else, gzip-compressed or not. Attributes keep their names; `id`, `velocity` and `density`
// coincide with ours, and Houdini's own name for a velocity, `v`, becomes ours.
#pragma once

#include "snapshot.hpp"

#include <filesystem>

namespace meniscus {

/// True where the file begins as classic geometry does, after decompression where it is compressed.
bool is_bgeo(const std::filesystem::path& file);

/// Reads positions and attributes of numbers; of attributes that index a table of texts, the index.
/// Throws InputError, naming the section, on anything that is not well formed, and on points that
/// belong to curves or surfaces. Memory is bounded by what the file's bytes can hold, whatever its
/// header claims.
Snapshot read_bgeo(const std::filesystem::path& file);

} // namespace meniscus
