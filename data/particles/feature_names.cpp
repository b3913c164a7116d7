#include "feature_names.hpp"

#include <meniscus/data/text/errors.hpp>

namespace meniscus {

std::size_t feature_named(const std::string& name) {
    const std::size_t place = find_feature(name);
    if (place == feature_count)
        throw InputError("'" + name + "' is no feature; expected one of " + feature_names());
    return place;
}

FeaturePair feature_pair(const std::vector<std::string>& names) {
    if (names.size() != 2 || names[0] == names[1])
        throw InputError("a line needs two different features, found " +
                         std::to_string(names.size()) + (names.size() == 2 ? " alike" : "") +
                         "; give two of " + feature_names());
    return {feature_named(names[0]), feature_named(names[1])};
}

std::string feature_names() {
    std::string names;
    for (const FeatureRow& row : feature_list)
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

std::string names_of(const FeaturePair& pair) {
    return std::string(feature_list[pair.first].name) + "," + feature_list[pair.second].name;
}

} // namespace meniscus
