// Whether boundary (wall) particles count as neighbors in the features, and the one text that says
// so in the provenance of labelled snapshots, in model files and in coefficient headers. A line is
// only worth something on features that were made by the rule it was trained with.
#pragma once

#include <optional>
#include <string_view>

namespace meniscus {

inline constexpr std::string_view boundary_counts_text = "boundary particles count";
inline constexpr std::string_view boundary_ignored_text = "boundary particles do not count";

/// The rule as text.
constexpr std::string_view boundary_rule_text(bool boundary_counts) {
    return boundary_counts ? boundary_counts_text : boundary_ignored_text;
}

/// Whether boundary particles count by the rule of that text; nothing where it is neither text.
constexpr std::optional<bool> boundary_counts_from(std::string_view rule) {
    if (rule != boundary_counts_text && rule != boundary_ignored_text)
        return {};
    return rule == boundary_counts_text;
}

} // namespace meniscus
