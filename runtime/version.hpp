// The version of the project, the one place where it stands: CMake reads it from here.
#pragma once

#define MENISCUS_VERSION "0.1.0"

namespace meniscus {

inline constexpr const char* program_version = MENISCUS_VERSION;

} // namespace meniscus
