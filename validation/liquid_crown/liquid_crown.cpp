// A drop that falls into a pool (Huber et al. 2015, test 2): height and slope of the crown,
// droplets that come loose, and the mean speed, for the lowest and the highest coefficient of each
// model.
#include "crown_shape.hpp"
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "framework/scene_runs.hpp"
#include "framework/spread.hpp"
#include "studies.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {
namespace {

/// The frame in which the crown is highest: the first maximum of the top of the largest body once
/// the drop is part of it and the top has begun to rise again.
std::size_t crown_frame(const SceneRun& done) {
    const std::vector<double>& tops = done.log.at("largest_top");
    const double particles = done.log.at("particles").front();
    std::size_t frame = 0; // of impact: the largest body has all but a hundredth
    while (frame + 1 < tops.size() && done.log.at("largest_body")[frame] < 0.99 * particles)
        ++frame;
    while (frame + 1 < tops.size() && tops[frame + 1] < tops[frame])
        ++frame;
    while (frame + 1 < tops.size() && tops[frame + 1] >= tops[frame])
        ++frame;
    return frame;
}

Json measure(const StudyRun& run, const Workplace& place) {
    const SceneRun done = run_to_end(disturbed(scene_of(run), run.numbers.at("seed")), place);
    Json figures = {{"particles", done.log.at("particles").front()}};
    if (!done.failure.empty()) {
        figures["failure"] = done.failure;
        return figures;
    }
    const std::size_t frame = crown_frame(done);
    place.draw(done.frames[frame]);
    const std::vector<double>& bodies = done.log.at("bodies");
    const double pool = run.numbers.at("pool_depth");
    figures["highest after, s"] = done.log.at("time")[frame];
    figures["height over the pool, m"] = done.log.at("largest_top")[frame] - pool;
    figures["slope, degrees"] =
        crown_slope(read_vtkhdf(done.frames[frame]).positions, pool + done.scene.particle_spacing);
    figures["droplets then"] = bodies[frame] - 1;
    figures["most droplets"] =
        *std::max_element(bodies.begin() + static_cast<std::ptrdiff_t>(frame), bodies.end()) - 1;
    figures["mean speed, m/s"] = mean_and_deviation(done.log.at("mean_speed")).mean;
    return figures;
}

/// Runs of a result, by solver and force.
Seeds runs_with(const Json& result, const std::string& solver, const std::string& force) {
    for (const Seeds& seeds : by_seeds(result, {"solver", "force"}))
        if (seeds.labels == std::vector<std::string>{solver, force})
            return seeds;
    return {};
}

/// A figure of two sets of runs, as text and whether all of the first are larger.
struct Compared {
    std::string found;
    int larger = 0;
    int pairs = 0;

    void add(const std::string& name, const Seeds& one, const Seeds& other, const char* figure) {
        const std::vector<double> a = one.values(figure);
        const std::vector<double> b = other.values(figure);
        if (a.empty() || b.empty())
            return;
        found += fmt::format("{}{}: {:.2f} and {:.2f}", found.empty() ? "" : "; ", name,
                             mean_and_deviation(a).mean, mean_and_deviation(b).mean);
        const bool apart =
            *std::min_element(a.begin(), a.end()) > *std::max_element(b.begin(), b.end());
        larger += apart ? 1 : 0;
        ++pairs;
    }
    [[nodiscard]] bool all() const { return pairs > 0 && larger == pairs; }
    [[nodiscard]] std::string text() const {
        return fmt::format("in {} of {} pairs for every seed: {}", larger, pairs, found);
    }
};

Table findings(const Json& result) {
    Table table = table_of_findings("liquid_crown_findings");
    Compared heights;
    Compared by_solver;
    Compared droplets;
    for (const auto& [low, high] :
         {std::pair{"Akinci 2013, 0.2", "Akinci 2013, 1"},
          std::pair{"Becker 2007, 0.02", "Becker 2007, 0.08"},
          std::pair{"Huber 2015, 0.02", "Huber 2015, 0.08"},
          std::pair{"He 2014, 0.2", "He 2014, 1.8"}, std::pair{"ours, 20", "ours, 100"}}) {
        const char* const height = "height over the pool, m";
        heights.add(fmt::format("{} and {}", low, high), runs_with(result, "IISPH", low),
                    runs_with(result, "IISPH", high), height);
        by_solver.add(high, runs_with(result, "IISPH", high), runs_with(result, "WCSPH", high),
                      height);
        droplets.add(high, runs_with(result, "IISPH", high), runs_with(result, "WCSPH", high),
                     "most droplets");
    }
    add_finding(table, "the crown is higher with a lower coefficient (section 6.2), m",
                heights.text(), heights.all());
    add_finding(table, "with IISPH it is higher than with WCSPH, m", by_solver.text(),
                by_solver.all());
    add_finding(table, "and more droplets come loose", droplets.text(), droplets.all());
    return table;
}

std::vector<Table> tables(const Json& result, const Json& /*reference*/) {
    return {table_of_spread("liquid_crown", result, "solver | force",
                            "highest after, s {:.2f} | height over the pool, m "
                            "{:.2f} | slope, degrees {:.0f} | droplets then {:.0f} | most droplets "
                            "{:.0f} | mean speed, m/s {:.3f}"),
            findings(result)};
}

} // namespace

Study liquid_crown_study() {
    return {"liquid_crown", "a drop falls into a pool: Huber's test 2", measure, tables};
}

} // namespace meniscus
