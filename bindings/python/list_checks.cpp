#include "list_checks.hpp"

#include <meniscus/data/text/errors.hpp>

#include <algorithm>

namespace meniscus {
namespace {

template <class Offset>
void check_offsets(const ListArrays& lists, const std::string& name) {
    const auto* offsets = static_cast<const Offset*>(lists.offsets);
    for (std::size_t i = 0; i < lists.rows; ++i)
        if (offsets[i] > offsets[i + 1])
            throw InputError(name + "[" + std::to_string(i + 1) +
                             "] is smaller than the one before");
    if (offsets[lists.rows] > lists.entries)
        throw InputError(name + " ends with " + std::to_string(offsets[lists.rows]) +
                         ", more than the number of indices, " + std::to_string(lists.entries));
}

void check_indices(const ListArrays& lists, const std::string& name) {
    const auto count = static_cast<std::uint32_t>(lists.particles);
    std::uint32_t wrong = 0; // a loop without a way out is done in vectors
    for (std::size_t n = 0; n < lists.entries; ++n)
        wrong |= static_cast<std::uint32_t>(lists.indices[n] >= count);
    if (wrong == 0)
        return;
    const auto* first = std::find_if(lists.indices, lists.indices + lists.entries,
                                     [&](std::uint32_t index) { return index >= count; });
    throw InputError(name + "[" + std::to_string(first - lists.indices) + "] is " +
                     std::to_string(*first) + ", expected a particle below " +
                     std::to_string(count));
}

} // namespace

void check_lists_exist(const ListArrays& lists, const std::string& prefix) {
    if (lists.wide)
        check_offsets<std::uint64_t>(lists, prefix + "offsets");
    else
        check_offsets<std::uint32_t>(lists, prefix + "offsets");
    check_indices(lists, prefix + "indices");
}

} // namespace meniscus
