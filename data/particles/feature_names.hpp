// Features by their names, as files and options have them (runtime/features/list.hpp).
#pragma once

#include <meniscus/runtime/features/list.hpp>

#include <string>
#include <vector>

namespace meniscus {

/// The place in the list of the feature of that name. Throws InputError, naming all there are,
/// where there is none.
std::size_t feature_named(const std::string& name);

/// The features of a plane. Throws InputError as above, and unless it is two different ones.
FeaturePair feature_pair(const std::vector<std::string>& names);

/// All names, with commas.
std::string feature_names();

/// "first,second", as the option takes them.
std::string names_of(const FeaturePair& pair);

} // namespace meniscus
