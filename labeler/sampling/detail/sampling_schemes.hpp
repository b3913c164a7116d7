// The list of sampling schemes: a new one is its file, with a function that is declared here, and
// its place in the list.
#pragma once

#include <meniscus/labeler/sampling/directions.hpp>

#include <optional>
#include <utility>

namespace meniscus {

/// One scheme, or several whose names follow a rule.
struct SchemeRow {
    std::string names; ///< as messages and help give them
    /// The scheme of that name, where it is of this row.
    std::function<std::optional<SamplingScheme>(std::string_view name)> find;
};

SchemeRow halton_row();
SchemeRow halton_in_bases_row();
SchemeRow random_row();
SchemeRow table_row();
SchemeRow blue_noise_row();

inline std::vector<SchemeRow> scheme_rows() {
    return {halton_row(), random_row(), table_row(), blue_noise_row(), halton_in_bases_row()};
}

/// The row of one scheme.
inline SchemeRow row_of(SamplingScheme scheme) {
    const std::string name = scheme.name;
    return {name, [scheme = std::move(scheme)](std::string_view wanted) {
                return wanted == scheme.name ? std::make_optional(scheme) : std::nullopt;
            }};
}

} // namespace meniscus
