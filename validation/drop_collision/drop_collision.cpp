// Two equal drops that meet: do they stay one? The Weber number is We = rho D U^2 / sigma with the
// relative speed U, the impact parameter X the distance of their ways over D. By Ashgriz and Poo
// (1990) drops that meet head on part again ("reflexive separation") from We = 18.7 on, and those
// with X = 0.5 by stretching from We = 22.2 on.
#include "framework/run_tables.hpp"
#include "framework/scene_runs.hpp"
#include "framework/spread.hpp"
#include "studies.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr double radius = 0.5; // m, of each drop in the scene

/// The scene's two drops on their ways along x, a drop's radius apart at the start.
Scene meeting(const StudyRun& run) {
    Scene scene = scene_of(run);
    const double sigma = scene.surface_tension.coefficient;
    const double speed =
        std::sqrt(run.numbers.at("weber") * sigma / (scene.rest_density * 2 * radius));
    const double aside = run.numbers.at("impact") * radius;
    for (const int side : {-1, 1}) {
        FluidBody drop;
        drop.shape = SphereShape{{side * 1.5 * radius, side * aside, 0}, {radius, radius, radius}};
        drop.velocity = {-side * speed / 2, 0, 0};
        scene.fluid.push_back(drop);
    }
    scene.fluid.erase(scene.fluid.begin());
    return disturbed(scene, run.numbers.at("seed"));
}

Json measure(const StudyRun& run, const Workplace& place) {
    const SceneRun done = run_to_end(meeting(run), place);
    const double particles = done.log.at("particles").front();
    Json figures = {{"particles", particles}, {"weber", run.numbers.at("weber")}};
    if (!done.failure.empty()) {
        figures["failure"] = done.failure;
        return figures;
    }
    place.draw(done.frames.back());
    const std::vector<double>& aspects = done.log.at("largest_aspect");
    const double largest = done.log.at("largest_body").back() / particles;
    figures["bodies"] = done.log.at("bodies").back();
    figures["most bodies"] =
        *std::max_element(done.log.at("bodies").begin(), done.log.at("bodies").end());
    figures["largest body, %"] = 100 * largest;
    figures["largest aspect"] = *std::max_element(aspects.begin(), aspects.end());
    figures["outcome"] = largest > 0.75 ? "one drop" : "parted";
    return figures;
}

/// "one drop", "parted", or both with how often.
std::string outcome_of(const Seeds& seeds) {
    std::size_t parted = 0;
    std::size_t ended = 0;
    for (const Json* run : seeds.runs) {
        const std::string outcome = run->at("figures").value("outcome", std::string());
        ended += outcome.empty() ? 0 : 1;
        parted += outcome == "parted" ? 1 : 0;
    }
    if (ended == 0)
        return "none came to its end";
    if (parted == 0 || parted == ended)
        return parted == 0 ? "one drop" : "parted";
    return fmt::format("parted in {} of {}", parted, ended);
}

std::vector<Table> tables(const Json& result, const Json& reference) {
    Table table = table_of_spread(
        "drop_collision", result, "way | Weber number",
        "largest aspect {:.2f} | most bodies {:.0f} | bodies {:.0f} | largest body, % {:.1f}");
    table.columns.push_back({"outcome", "outcome"});
    table.columns.push_back({"published", "Ashgriz and Poo 1990"});
    table.columns.push_back({"agrees", "agrees"});
    const auto all = by_seeds(result, {"way", "Weber number"});
    for (std::size_t n = 0; n < table.rows.size(); ++n) {
        const Json& run = *all[n].runs.front();
        const bool head_on = label_of(run, "way") == "head on";
        const double limit =
            published(reference, head_on ? "head on, parts from We" : "X = 0.5, parts from We");
        const std::string expected =
            figure_of(run, "weber").value_or(0) > limit ? "parted" : "one drop";
        const std::string outcome = outcome_of(all[n]);
        table.rows[n].insert(table.rows[n].end(),
                             {outcome, expected, outcome == expected ? "yes" : "**no**"});
    }
    return {table, table_of_sources(reference)};
}

} // namespace

Study drop_collision_study() {
    return {"drop_collision", "two drops that meet stay one or part, by Weber number", measure,
            tables};
}

} // namespace meniscus
