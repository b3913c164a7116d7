// Stand-in: what is logged can be read.
#pragma once

#include <sstream>

namespace Utilities {
inline std::ostringstream& log() {
    static std::ostringstream text;
    return text;
}
} // namespace Utilities

#define LOG_WARN Utilities::log()
