// Whether the last number of a text without a line break at its end may have lost digits. Programs
// end a file with a line break; people and some scripts do not.
#pragma once

#include <string_view>
#include <vector>

namespace meniscus {

/// True unless the numbers before it, in the same column or list, show that `last` is whole: it has
/// as many decimals as all of them, or where theirs differ as many significant digits as any; a
/// whole number is the same as the one before, or the next.
bool may_be_cut(std::string_view last, const std::vector<std::string_view>& before);

} // namespace meniscus
