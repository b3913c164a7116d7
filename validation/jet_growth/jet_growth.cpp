// A jet at rest whose radius has a wave along it: surface tension makes the wave grow where it is
// longer than the jet is round, by Rayleigh's rate.
// Scenes have no periodic ends: the jet is so long that its ends, which draw back at about
// sqrt(2 sigma / (rho R)), do not reach the wave in its middle while that is looked at.
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "framework/scene_runs.hpp"
#include "rayleigh_rate.hpp"
#include "studies.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/runtime/math/angles.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr double radius = 0.5;     // m
constexpr double first_wave = 0.1; // of the radius, over R
constexpr double growth = 2;       // up to which the wave is looked at

/// 1/s.
double rate_of(const Scene& scene, double wave_number) {
    return rayleigh_rate(wave_number * radius) *
           std::sqrt(scene.surface_tension.coefficient /
                     (scene.rest_density * std::pow(radius, 3)));
}

/// Around the x axis, one wave in the middle and room for the ends; moved such that radii have the
/// wave and volumes stay.
Positions waved_jet(double spacing, double wave_number) {
    const double half = pi / wave_number + 9 * radius;
    const int along = static_cast<int>(half / spacing);
    const int across = static_cast<int>(radius / spacing);
    Positions positions;
    for (int i = -along; i <= along; ++i)
        for (int j = -across; j <= across; ++j)
            for (int k = -across; k <= across; ++k) {
                if (std::hypot(j, k) * spacing >= radius)
                    continue;
                const double x = i * spacing;
                const double wider = 1 + first_wave * std::cos(wave_number * x);
                positions.push_back({x - 2 * first_wave / wave_number * std::sin(wave_number * x),
                                     j * spacing * wider, k * spacing * wider});
            }
    return positions;
}

/// The wave in the middle, as its share of the radius there.
double wave_in(const Positions& positions, double wave_number, double particles_a_length) {
    double sum = 0;
    for (const Place& place : positions)
        if (std::abs(place[0]) < pi / wave_number)
            sum += std::cos(wave_number * place[0]);
    return sum / (particles_a_length * 2 * pi / wave_number);
}

Scene jet(Scene scene, double wave_number, const Workplace& place) {
    Snapshot first;
    first.positions = waved_jet(scene.particle_spacing, wave_number);
    first.support_radius = scene.support_radius;
    first.particle_spacing = scene.particle_spacing;
    SnapshotShape shape;
    shape.file = place.folder / "first.vtkhdf";
    write_vtkhdf(first, shape.file);
    scene.fluid = {{shape, {}}};
    scene.duration = 1.45 * std::acosh(growth) / rate_of(scene, wave_number);
    scene.frame_interval = scene.duration / 60;
    return scene;
}

Json measure(const StudyRun& run, const Workplace& place) {
    const double wave_number = run.numbers.at("kR") / radius;
    const SceneRun done = run_to_end(jet(scene_of(run), wave_number, place), place);
    place.draw(done.frames.back());
    const Scene& scene = done.scene;
    const double exact = rate_of(scene, wave_number);
    Json figures = {{"particles", done.log.at("particles").front()},
                    {"Rayleigh's rate, 1/s", exact}};
    std::vector<double> waves;
    for (const auto& frame : done.frames)
        waves.push_back(wave_in(read_vtkhdf(frame).positions, wave_number,
                                pi * radius * radius / std::pow(scene.particle_spacing, 3)));
    const double first = waves.front();
    std::size_t grown = 0;
    while (grown < waves.size() && waves[grown] < growth * first)
        ++grown;
    if (grown < waves.size()) {
        const double rate = std::acosh(waves[grown] / first) / done.log.at("time")[grown];
        figures["rate, 1/s"] = rate;
        figures["rate off, %"] = 100 * (rate / exact - 1);
    } else {
        figures["failure"] = done.failure.empty() ? "the wave does not double" : done.failure;
    }
    for (double& wave : waves)
        wave /= first;
    figures["time"] = done.log.at("time");
    figures["wave"] = waves;
    figures["largest wave over the first"] = *std::max_element(waves.begin(), waves.end());
    figures["wave at the end over the first"] = waves.back();
    figures["bodies at the end"] = done.log.at("bodies").back();
    return figures;
}

std::vector<Table> tables(const Json& result, const Json& reference) {
    return {table_of_runs("jet_growth", result, "spacing | k R",
                          "rate off, % {:+.1f} | rate, 1/s {:.3f} | Rayleigh's rate, 1/s {:.3f} | "
                          "largest wave over the first {:.2f} | wave at the end over the first "
                          "{:.2f} | bodies at the end {:.0f} | "
                          "particles {:.0f}"),
            table_of_sources(reference)};
}

/// The waves over time, beside cosh of Rayleigh's rate.
std::vector<Table> plots(const Json& result) {
    Table table = table_of("jet_growth_wave", "time, s | wave over the first | run");
    for (const Json& run : result.at("runs")) {
        const Json& figures = run.at("figures");
        const std::string name =
            "k R = " + label_of(run, "k R") + ", spacing " + label_of(run, "spacing");
        const double rate = figures.at("Rayleigh's rate, 1/s");
        for (std::size_t n = 0; n < figures.at("wave").size(); ++n) {
            const double time = figures["time"][n];
            table.add({time, figures["wave"][n].get<double>(), name});
            table.add({time, std::cosh(rate * time), "Rayleigh, k R = " + label_of(run, "k R")});
        }
    }
    Plot plot{"jet_growth.svg", "The wave on a jet", "time, s", "wave over the first", "run"};
    plot.logarithmic_x = plot.logarithmic_y = false;
    plot.joined = true;
    table.plots = {plot};
    return {table};
}

} // namespace

Study jet_growth_study() {
    return {"jet_growth", "the wave on a jet that breaks it, beside Rayleigh's rate", measure,
            tables, plots};
}

} // namespace meniscus
