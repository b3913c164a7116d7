#include "detail/sampling_schemes.hpp"

#include <meniscus/data/text/errors.hpp>

namespace meniscus {

std::string sampling_scheme_names() {
    std::string names;
    for (const SchemeRow& row : scheme_rows())
        names += (names.empty() ? "" : ", ") + row.names;
    return names;
}

SamplingScheme sampling_scheme(std::string_view name) {
    for (const SchemeRow& row : scheme_rows())
        if (const auto scheme = row.find(name))
            return *scheme;
    throw InputError("unknown sampling scheme '" + std::string(name) + "'; known are " +
                     sampling_scheme_names());
}

} // namespace meniscus
