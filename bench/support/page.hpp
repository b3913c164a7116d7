// Tables and their plots as one page of HTML, which holds everything itself and opens from disk.
#pragma once

#include "table.hpp"

#include <string>
#include <vector>

namespace meniscus {

/// Title and a paragraph on what was measured, then each table below its title, with its plots. A
/// click on a heading sorts the rows by that column, numbers by their size.
std::string tables_page(const std::string& title, const std::string& about,
                        const std::vector<Table>& tables);

} // namespace meniscus
