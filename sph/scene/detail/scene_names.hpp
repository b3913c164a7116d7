// The words of scenes for enumerators, in their order, and which options of surface tension have no
// key: what reads scenes and what writes them as text share.
#pragma once

#include <string>
#include <vector>

namespace meniscus {

inline const std::vector<std::string> precision_names{"single", "double"};
inline const std::vector<std::string> kernel_names{"cubic_spline", "mueller"};
inline const std::vector<std::string> leaving_names{"few", "remove", "stop"};
inline const std::vector<std::string> log_names{"forces", "bodies"};

/// The text of an enumerator, whose list of names has their order.
template <class Kind>
const std::string& name_of(Kind kind, const std::vector<std::string>& names) {
    return names[static_cast<std::size_t>(kind)];
}

/// What coefficient and spacings give, so that the section has no keys for it.
inline bool comes_with_scene(const char* name) {
    return name == std::string("surface_tension") || name == std::string("spacing_ratio");
}

} // namespace meniscus
