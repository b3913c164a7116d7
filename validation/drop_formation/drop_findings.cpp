#include "drop_findings.hpp"

#include "framework/measures.hpp"
#include "framework/run_tables.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace meniscus {
namespace {

const std::vector<std::string> models = {"Becker 2007", "Huber 2015", "Akinci 2013", "He 2014",
                                         "ours"};
const std::vector<std::string> solvers = {"IISPH", "PCISPH", "WCSPH", "DFSPH"};

std::string model_of(const Json& run) {
    const std::string force = label_of(run, "force");
    return force.substr(0, force.find(','));
}

/// Runs of a model with a solver, by rising coefficient.
std::vector<const Json*> runs_of(const Json& result, const std::string& model,
                                 const std::string& solver) {
    std::vector<const Json*> some;
    for (const Json& run : result.at("runs"))
        if (model_of(run) == model && label_of(run, "solver") == solver)
            some.push_back(&run);
    std::sort(some.begin(), some.end(), [](const Json* one, const Json* other) {
        return figure_of(*one, "coefficient") < figure_of(*other, "coefficient");
    });
    return some;
}

std::vector<double> figures_of(const std::vector<const Json*>& runs, const std::string& figure) {
    std::vector<double> values;
    for (const Json* run : runs)
        if (const auto value = figure_of(*run, figure))
            values.push_back(*value);
    return values;
}

/// Mean over the coefficients; NaN where all runs failed.
double aggregated(const Json& result, const std::string& model, const std::string& solver,
                  const std::string& figure) {
    return mean_and_deviation(figures_of(runs_of(result, model, solver), figure)).mean;
}

/// The same of two solvers, over the coefficients at which both came to their end.
std::pair<double, double> aggregated_in_pairs(const Json& result, const std::string& model,
                                              const std::string& solver, const std::string& other,
                                              const std::string& figure) {
    std::vector<double> values;
    std::vector<double> others;
    for (const Json* run : runs_of(result, model, solver))
        for (const Json* same : runs_of(result, model, other))
            if (label_of(*run, "force") == label_of(*same, "force") && figure_of(*run, figure) &&
                figure_of(*same, figure)) {
                values.push_back(*figure_of(*run, figure));
                others.push_back(*figure_of(*same, figure));
            }
    return {mean_and_deviation(values).mean, mean_and_deviation(others).mean};
}

/// Of the largest coefficient; NaN where it has none.
double at_largest(const Json& result, const std::string& model, const std::string& solver,
                  const std::string& figure) {
    const auto runs = runs_of(result, model, solver);
    const auto value = runs.empty() ? std::nullopt : figure_of(*runs.back(), figure);
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

Figures with_deviation(const std::vector<double>& values) {
    const auto spread = mean_and_deviation(values);
    return {spread.mean, spread.deviation};
}

} // namespace

bool is_largest_coefficient(const Json& result, const Json& run) {
    const auto runs = runs_of(result, model_of(run), label_of(run, "solver"));
    return runs.back() == &run;
}

Table table_of_models(const Json& result) {
    Table table = table_of(
        "drop_formation",
        "model | solver | runs that came to their end | mean speed, m/s / deviation {:.4f} | force "
        "of surface tension, N / deviation {:.3f} | of pressure, N / deviation {:.3f}");
    for (const std::string& model : models)
        for (const std::string& solver : solvers) {
            const auto runs = runs_of(result, model, solver);
            const auto speeds = figures_of(runs, "mean speed, m/s");
            if (runs.empty())
                continue;
            table.add({model, solver, fmt::format("{} of {}", speeds.size(), runs.size()),
                       with_deviation(speeds), with_deviation(figures_of(runs, "tension force, N")),
                       with_deviation(figures_of(runs, "pressure force, N"))});
        }
    return table;
}

Table table_of_ends(const Json& result) {
    Json largest = result;
    largest["runs"] = Json::array();
    for (const Json& run : result.at("runs"))
        if (is_largest_coefficient(result, run))
            largest["runs"].push_back(run);
    return table_of_runs("drop_formation_ends", largest, "force | solver",
                         "off a sphere at the end, % {:.2f} | round after, s {:.2f} | aspect at "
                         "the end {:.3f} | speed at the end, m/s {:.4f} | maxima of the speed "
                         "{:.0f} | pairs closer than half a spacing, % {:.1f}");
}

Table table_of_times(const Json& result, const Json& reference) {
    Table table = table_of("drop_formation_times",
                           "force | surface tension, s {:.3f} | pressure, s {:.3f} | all, s {:.3f} "
                           "| surface tension over Becker's {:.2f} | published {:.2f} | all over "
                           "Becker's {:.2f} | published {:.2f}");
    const auto over = [&](const Json& run, const char* figure) {
        const auto becker = runs_of(result, "Becker 2007", "IISPH");
        return figure_of(run, figure).value_or(0) / figure_of(*becker.front(), figure).value_or(0);
    };
    const auto published_ratio = [&](const std::string& force, const char* what) -> Cell {
        const std::string key = fmt::format("{}: {}, s", force, what);
        if (!reference.at("numbers").contains(key))
            return {};
        return published(reference, key) /
               published(reference, fmt::format("Becker 2007, 0.02: {}, s", what));
    };
    for (const Json& run : result.at("runs")) {
        if (label_of(run, "solver") != "IISPH" || !figure_of(run, "all, s"))
            continue;
        const std::string force = label_of(run, "force");
        table.add({force, figure_of(run, "surface tension, s"), figure_of(run, "pressure, s"),
                   figure_of(run, "all, s"), over(run, "surface tension, s"),
                   published_ratio(force, "surface tension"), over(run, "all, s"),
                   published_ratio(force, "all")});
    }
    return table;
}

namespace {

/// The model with the largest, or smallest, of values that are there.
template <class Better>
std::string best_model(const Json& result, const char* figure, bool at_the_largest,
                       const std::vector<std::string>& some, const Better& better) {
    std::string best;
    double best_value = std::numeric_limits<double>::quiet_NaN();
    for (const std::string& model : some) {
        const double value = at_the_largest ? at_largest(result, model, "IISPH", figure)
                                            : aggregated(result, model, "IISPH", figure);
        if (value == value && (best.empty() || better(value, best_value))) {
            best = model;
            best_value = value;
        }
    }
    return best;
}

const std::vector<std::string> rivals = {"Becker 2007", "Huber 2015", "Akinci 2013", "He 2014"};

void add_speed_findings(const Json& result, const Json& reference, Table& table) {
    const auto speed = [&](const char* model, const char* solver = "IISPH") {
        return aggregated(result, model, solver, "mean speed, m/s");
    };
    const std::string fastest = best_model(result, "mean speed, m/s", false, rivals,
                                           [](double a, double b) { return a > b; });
    add_finding(table, "velocities are highest with Akinci 2013 (section 6.1)",
                fmt::format("highest of the rivals' with {}; {:.3f} m/s with Akinci, {:.3f} with "
                            "Becker, {:.3f} with He, {:.3f} with ours",
                            fastest, speed("Akinci 2013"), speed("Becker 2007"), speed("He 2014"),
                            speed("ours")),
                fastest == "Akinci 2013");
    const double ratio = speed("Akinci 2013") / speed("He 2014");
    add_finding(table, "with He 2014 they are up to 100 times lower",
                fmt::format("{:.0f} times lower than Akinci's", ratio),
                ratio > 1 && ratio <= published(reference, "speed of Akinci 2013 over that of He "
                                                           "2014, at most"));
    const double becker = at_largest(result, "Becker 2007", "IISPH", "speed at the end, m/s");
    const double huber = at_largest(result, "Huber 2015", "IISPH", "speed at the end, m/s");
    add_finding(table, "the cut cohesion ends slower than Becker 2007",
                fmt::format("{:.4f} m/s, Becker's {:.4f}", huber, becker), huber < becker);
    const bool damps = speed("Akinci 2013", "WCSPH") < speed("Akinci 2013") &&
                       speed("Becker 2007", "WCSPH") < speed("Becker 2007");
    add_finding(table, "WCSPH dampens Akinci 2013 and Becker 2007 (section 7)",
                fmt::format("{:.3f} and {:.3f} m/s, with IISPH {:.3f} and {:.3f}",
                            speed("Akinci 2013", "WCSPH"), speed("Becker 2007", "WCSPH"),
                            speed("Akinci 2013"), speed("Becker 2007")),
                damps);
}

void add_maxima_findings(const Json& result, const Json& reference, Table& table) {
    for (const char* force : {"Akinci 2013, 1", "Becker 2007, 0.08", "He 2014, 1.8"}) {
        const std::string model = std::string(force).substr(0, std::string(force).find(','));
        const double maxima = at_largest(result, model, "IISPH", "maxima of the speed");
        const double expected = published(reference, fmt::format("maxima of the speed, {}", force));
        add_finding(table,
                    fmt::format("the speed has {:.0f} local maxima with {}", expected, force),
                    fmt::format("{:.0f}", maxima), maxima == expected);
    }
}

void add_force_findings(const Json& result, Table& table) {
    const std::string largest = best_model(result, "tension force, N", false, rivals,
                                           [](double a, double b) { return a > b; });
    const std::string smallest = best_model(result, "tension force, N", false, rivals,
                                            [](double a, double b) { return a < b; });
    add_finding(table, "forces are largest with Akinci 2013, smallest with He 2014",
                fmt::format("largest with {}, smallest with {}", largest, smallest),
                largest == "Akinci 2013" && smallest == "He 2014");
    bool lower = true;
    std::string found;
    for (const char* model : {"Akinci 2013", "Becker 2007"})
        for (const char* solver : {"PCISPH", "WCSPH"}) {
            const auto [pressure, iisph] =
                aggregated_in_pairs(result, model, solver, "IISPH", "pressure force, N");
            lower = lower && pressure < iisph;
            found += fmt::format("{}{} with {}: {:.3f} N, IISPH {:.3f}", found.empty() ? "" : "; ",
                                 model, solver, pressure, iisph);
        }
    add_finding(table, "pressure forces are lower with PCISPH and WCSPH than with IISPH", found,
                lower);
}

void add_shape_findings(const Json& result, Table& table) {
    const std::string first = best_model(result, "round after, s", true, models,
                                         [](double a, double b) { return a < b; });
    add_finding(table, "Becker 2007 and Akinci 2013 reach the sphere first, long before He 2014",
                first.empty() ? "none gets there"
                              : fmt::format("{} is first, after {:.2f} s", first,
                                            at_largest(result, first, "IISPH", "round after, s")),
                first == "Becker 2007" || first == "Akinci 2013" || first == "Huber 2015");
    const auto he = runs_of(result, "He 2014", "IISPH");
    const auto off =
        he.empty() ? std::nullopt : figure_of(*he.front(), "off a sphere at the end, %");
    add_finding(table, "He 2014 with its lowest coefficient forms no sphere",
                fmt::format("{:.1f} % off", off.value_or(0)), off.value_or(0) > 3);
    const char* close = "pairs closer than half a spacing, %";
    const double becker = aggregated(result, "Becker 2007", "IISPH", close);
    const double huber = aggregated(result, "Huber 2015", "IISPH", close);
    add_finding(table, "Becker 2007 clusters, and the cut cohesion does less",
                fmt::format("{:.1f} % of the particles have a neighbor closer than half a "
                            "spacing, cut {:.1f} %",
                            becker, huber),
                becker > huber);
}

} // namespace

Table table_of_drop_findings(const Json& result, const Json& reference) {
    Table table = table_of_findings("drop_formation_findings");
    add_speed_findings(result, reference, table);
    add_maxima_findings(result, reference, table);
    add_force_findings(result, table);
    add_shape_findings(result, table);
    return table;
}

} // namespace meniscus
