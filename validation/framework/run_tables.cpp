#include "run_tables.hpp"

#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {
namespace {

Cell cell_of(const Json& value) {
    if (value.is_number())
        return value.get<double>();
    if (value.is_string())
        return value.get<std::string>();
    return {};
}

/// The first clause: failures go on with where it was and what to do.
std::string short_failure(const std::string& failure) {
    return failure.substr(0, std::min(failure.find(';'), failure.find(" (step")));
}

} // namespace

Table table_of_runs(const std::string& name, const Json& result, const std::string& axes,
                    const std::string& figures) {
    const std::vector<Column> of_axes = table_of("", axes).columns;
    const std::vector<Column> of_figures = table_of("", figures).columns;
    Table table = table_of(name, axes + " | " + figures);
    for (const Json& run : result.at("runs")) {
        std::vector<Cell> row;
        for (const Column& axis : of_axes)
            row.emplace_back(label_of(run, axis.heading));
        const Json& found = run.at("figures");
        for (const Column& figure : of_figures)
            row.push_back(cell_of(found.value(figure.heading, Json())));
        if (found.contains("failure"))
            row[of_axes.size()] = short_failure(found["failure"].get<std::string>());
        table.add(row);
    }
    return table;
}

std::optional<double> figure_of(const Json& run, const std::string& figure) {
    const Json& figures = run.at("figures");
    if (!figures.contains(figure) || !figures[figure].is_number())
        return {};
    return figures[figure].get<double>();
}

std::string label_of(const Json& run, const std::string& axis) {
    return run.at("labels").value(axis, std::string());
}

double published(const Json& reference, const std::string& key) {
    const JsonReader numbers = JsonReader(reference, "reference.json", "").object_at("numbers");
    return numbers.object_at(key.c_str()).number("value", -1e300, 1e300);
}

Table table_of_sources(const Json& reference) {
    Table table = table_of("sources", "published or exact | value {:.6g} | source");
    for (const auto& [key, number] : reference.at("numbers").items())
        table.add({key, cell_of(number.at("value")), number.at("source").get<std::string>()});
    return table;
}

Table table_of_findings(const std::string& name) {
    return table_of(name, "finding | found here | holds");
}

void add_finding(Table& table, const std::string& finding, const std::string& found, bool holds) {
    table.add({finding, found, holds ? "yes" : "**no**"});
}

std::string what_ran(const Json& result) {
    return fmt::format("{}: {} runs, {:.2f} hours on {} threads, {:.0f} MiB\n",
                       result.at("size").get<std::string>(), result.at("runs").size(),
                       result.at("hours").get<double>(), result.at("threads").get<int>(),
                       result.at("peak_memory_mib").get<double>());
}

} // namespace meniscus
