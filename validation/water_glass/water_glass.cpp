// A liquid that is poured into a glass (Huber et al. 2015, test 3): how coherent the jet is, what
// comes loose, and how the liquid stands in the glass, with walls that it wets more or less.
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "framework/scene_runs.hpp"
#include "glass_shape.hpp"
#include "studies.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace meniscus {
namespace {

/// That of scripts/make_scene_meshes.py.
Glass glass_of(const StudyRun& run) {
    const double scale = run.numbers.at("scale");
    return {0.8 * scale, 1.06 * scale, 2.22 * scale, 3 * scale};
}

/// A jet of fewer particles than these thousandths of all is none yet, or no more.
constexpr double least_jet = 10;

void add_jet(const SceneRun& done, const Glass& glass, const Workplace& place, Json& figures) {
    const double particles = done.log.at("particles").front();
    double sum = 0;
    double largest = 0;
    double droplets = 0;
    std::size_t most = 0;
    int frames = 0;
    std::size_t most_falling = 0;
    std::filesystem::path fullest;
    for (const auto& frame : done.frames) {
        const Jet jet = jet_of(read_vtkhdf(frame).positions, glass, done.scene.support_radius);
        if (static_cast<double>(jet.particles) < least_jet / 1000 * particles)
            continue;
        ++frames;
        if (jet.particles > most_falling) {
            most_falling = jet.particles;
            fullest = frame;
        }
        sum += static_cast<double>(jet.particles);
        largest += static_cast<double>(jet.largest);
        droplets += static_cast<double>(jet.droplets);
        most = std::max(most, jet.droplets);
    }
    figures["frames with a jet"] = frames;
    if (frames == 0)
        return;
    place.draw(fullest);
    figures["jet in one body, %"] = 100 * largest / sum;
    figures["droplets beside it"] = droplets / frames;
    figures["most droplets beside it"] = most;
}

/// Means over the last fifth of the run, in which the liquid still sways.
void add_level(const StudyRun& run, const SceneRun& done, const Glass& glass, Json& figures) {
    const Scene& scene = done.scene;
    std::vector<double> heights;
    std::vector<double> rises;
    for (std::size_t frame = 0; frame < done.frames.size(); ++frame) {
        if (done.log.at("time")[frame] < 0.8 * scene.duration)
            continue;
        const auto level = level_in(read_vtkhdf(done.frames[frame]).positions, glass,
                                    scene.particle_spacing, scene.support_radius);
        if (level) {
            heights.push_back(level->height);
            rises.push_back(1000 * level->rise_at_wall);
        }
    }
    figures["in the glass, %"] =
        100 * static_cast<double>(in_glass(read_vtkhdf(done.frames.back()).positions, glass)) /
        done.log.at("particles").front();
    if (heights.empty())
        return;
    figures["level, m"] = mean_and_deviation(heights).mean;
    figures["its deviation, m"] = mean_and_deviation(heights).deviation;
    figures["rise at the wall, mm"] = mean_and_deviation(rises).mean;
    figures["its deviation, mm"] = mean_and_deviation(rises).deviation;
    if (run.numbers.count("contact_angle") == 0)
        return;
    const double capillary_length =
        std::sqrt(scene.surface_tension.coefficient / (scene.rest_density * -scene.gravity[1]));
    figures["rise at a plane, mm"] =
        1000 * rise_at_plane(run.numbers.at("contact_angle"), capillary_length);
}

/// Of the particles above the ground: those that were spilled fall on and on.
double mean_speed(const SceneRun& done) {
    std::vector<double> speeds; // of frames
    for (const auto& frame : done.frames) {
        const Snapshot state = read_vtkhdf(frame);
        const auto& velocities =
            std::get<std::vector<float>>(find_array(state, "velocity")->values);
        std::vector<double> some;
        for (std::size_t i = 0; i < state.size(); ++i)
            if (state.positions[i][1] >= 0) {
                const float* velocity = &velocities[3 * i];
                some.push_back(std::hypot(velocity[0], velocity[1], velocity[2]));
            }
        if (!some.empty())
            speeds.push_back(mean_and_deviation(some).mean);
    }
    return mean_and_deviation(speeds).mean;
}

Json measure(const StudyRun& run, const Workplace& place) {
    const SceneRun done = run_to_end(scene_of(run), place);
    Json figures = {{"particles", done.log.at("particles").front()}};
    if (!done.failure.empty()) {
        figures["failure"] = done.failure;
        return figures;
    }
    const Glass glass = glass_of(run);
    add_jet(done, glass, place, figures);
    add_level(run, done, glass, figures);
    const std::vector<double>& bodies = done.log.at("bodies");
    figures["most bodies"] = *std::max_element(bodies.begin(), bodies.end());
    figures["bodies at the end"] = bodies.back();
    figures["mean speed, m/s"] = mean_speed(done);
    return figures;
}

const Json* run_of_force(const Json& result, const std::string& force) {
    for (const Json& run : result.at("runs"))
        if (label_of(run, "force") == force)
            return &run;
    return nullptr;
}

/// Adds whether a figure of the first of these runs is larger than those of the others.
void add_compared(Table& table, const std::string& finding, const Json& result,
                  const std::vector<std::string>& forces, const char* figure) {
    std::string found;
    std::optional<double> first;
    bool holds = true;
    for (const std::string& force : forces) {
        const Json* run = run_of_force(result, force);
        std::optional<double> value;
        if (run != nullptr)
            value = figure_of(*run, figure);
        found += fmt::format("{}{}: {}", found.empty() ? "" : "; ", force,
                             value ? fmt::format("{:.1f}", *value) : "-");
        const bool is_first = &force == &forces.front();
        holds = holds && value.has_value() && (is_first || first.value_or(0) > value.value_or(0));
        if (is_first)
            first = value;
    }
    add_finding(table, finding, found, holds);
}

/// Adds whether the liquid stands higher at the wall in the first of two runs, by more than it
/// sways.
void add_rises(Table& table, const std::string& finding, const Json& result,
               const std::string& higher, const std::string& lower) {
    std::vector<double> rises;
    double sways = 0;
    std::string found;
    for (const std::string& force : {higher, lower}) {
        const Json* run = run_of_force(result, force);
        const auto rise = run == nullptr ? std::nullopt : figure_of(*run, "rise at the wall, mm");
        if (!rise)
            continue;
        const double deviation = figure_of(*run, "its deviation, mm").value_or(0);
        rises.push_back(*rise);
        sways = std::max(sways, deviation);
        found += fmt::format("{}{}: {:.0f}, swaying by {:.0f}", found.empty() ? "" : "; ", force,
                             *rise, deviation);
    }
    add_finding(table, finding, found, rises.size() == 2 && rises[0] > rises[1] + sways);
}

Table findings(const Json& result) {
    Table table = table_of_findings("water_glass_findings");
    add_compared(
        table,
        "the jet is one with Akinci 2013, with others droplets detach (section 6.3), % of it in "
        "one body",
        result, {"Akinci 2013, 1", "Becker 2007, 0.08", "Huber 2015, 0.08", "He 2014, 1"},
        "jet in one body, %");
    double least = 1e300;
    double most = 0;
    for (const Json& run : result.at("runs"))
        if (const auto speed = figure_of(run, "mean speed, m/s")) {
            least = std::min(least, *speed);
            most = std::max(most, *speed);
        }
    add_finding(table, "mean speeds hardly differ: by less than a tenth here",
                fmt::format("{:.2f} to {:.2f} m/s", least, most), most < 1.1 * least);
    add_rises(table, "the liquid stands higher at walls that it wets, mm", result,
              "ours, 60 degrees", "ours, 90 degrees");
    add_rises(table, "and lower at those that it draws back from, mm", result, "ours, 90 degrees",
              "ours, 120 degrees");
    add_rises(table, "and higher at walls that attract it, mm", result,
              "Akinci 2013, 1, adhesion 1", "Akinci 2013, 1");
    return table;
}

std::vector<Table> tables(const Json& result, const Json& reference) {
    return {table_of_runs("water_glass", result, "force",
                          "particles {:.0f} | frames with a jet {:.0f} | jet in one body, % {:.1f} "
                          "| droplets beside it {:.1f} | most droplets beside it {:.0f} | most "
                          "bodies {:.0f} | bodies at the end {:.0f} | mean speed, m/s {:.3f}"),
            table_of_runs("water_glass_level", result, "force",
                          "in the glass, % {:.1f} | level, m {:.3f} | its deviation, m {:.3f} | "
                          "rise at the wall, mm {:.0f} | its deviation, mm {:.0f} | rise at a "
                          "plane, mm {:.0f}"),
            findings(result), table_of_sources(reference)};
}

} // namespace

Study water_glass_study() {
    return {
        "water_glass",
        "a liquid is poured into a glass: Huber's test 3, with contact angles of 60, 90 and 120 "
        "degrees",
        measure, tables};
}

} // namespace meniscus
