// Tables of a study's runs.
#pragma once

#include "study.hpp"

#include <optional>
#include <string>

namespace meniscus {

/// A row for each run: the values of the axes that `axes` names ("drop | solver"), then the figures
/// of these names as table_of() takes columns ("pressure {:.3f}"). A run that failed has its
/// failure in place of the first figure, and figures that it lacks are empty.
Table table_of_runs(const std::string& name, const Json& result, const std::string& axes,
                    const std::string& figures);

/// A figure of a run; nothing where it has none.
std::optional<double> figure_of(const Json& run, const std::string& figure);

/// A value of a run's axis.
std::string label_of(const Json& run, const std::string& axis);

/// A number of the reference: {"numbers": {KEY: {"value", "source"}}}. Throws InputError where
/// there is none of that key.
double published(const Json& reference, const std::string& key);

/// Where the reference has its numbers from, a row each.
Table table_of_sources(const Json& reference);

/// A finding of a paper, and what is found here: columns "finding", "found", "holds".
Table table_of_findings(const std::string& name);
void add_finding(Table& table, const std::string& finding, const std::string& found, bool holds);

/// What ran: size, particles where there are, hours and memory, as a sentence.
std::string what_ran(const Json& result);

} // namespace meniscus
