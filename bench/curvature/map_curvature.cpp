// What a calibrated curvature needs and is worth: the terms of its map, the 2019 preprint's Table
// 2, with a map for dense clouds, and nearly spherical droplets of a solver.
#include "curvature_errors.hpp"
#include "support/tables.hpp"

#include <meniscus/classifier/curvature/curvature_model.hpp>
#include <meniscus/runtime/math/vector3.hpp>

#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr std::uint64_t first_seed = 7000;

/// Root mean square over the rows of a model, relative to the curvature, at least 0.1.
std::vector<Cell> residuals(const char* name, const CurvatureModel& model) {
    Spread biases;
    double max = 0;
    Spread deviations;
    for (const CurvatureResidual& row : model.residuals) {
        const double scale = std::fmax(std::fabs(row.curvature), 0.1);
        biases.add(row.bias / scale);
        max = std::fmax(max, row.max_bias / scale);
        deviations.add(row.deviation);
    }
    return {name, 100 * biases.root_mean_square(), 100 * max, deviations.mean()};
}

Tables ablation(const TableInput& input) {
    Calibration calibration = read_calibration(input.files[0]);
    const auto groups = curvature_groups(calibration, [](std::size_t, std::size_t) {});
    Table table = table_of(
        "curvature-ablation",
        "terms | bias, root mean square {:.1f} % | bias, largest {:.1f} % | deviation {:.3f}");
    const auto try_terms = [&](const char* name, const std::vector<bool>& has_term) {
        calibration.has_term = has_term;
        table.add(residuals(name, fit_curvature_model(groups, calibration)));
    };
    try_terms("closed form", {true, false, false, true});
    try_terms("turning", {true, true, false, false});
    try_terms("turning, closed form", {true, true, false, true});
    try_terms("turning, square", {true, true, true, false});
    try_terms("turning, square, closed form", {true, true, true, true});
    return {table};
}

/// A row of the preprint's Table 2: mean and deviation of 40 measurements.
struct Published {
    int samples;
    double mean[6], deviation[6];
};
constexpr Published published[] = {
    {50, {0.145, -0.273, 0.038, -0.049, 0.424, -0.634}, {0.365, 0.332, 0.325, 0.322, 0.275, 0.345}},
    {200,
     {0.199, -0.241, 0.052, -0.014, 0.431, -0.584},
     {0.125, 0.159, 0.142, 0.142, 0.173, 0.150}},
    {1000,
     {0.196, -0.238, 0.046, -0.033, 0.426, -0.583},
     {0.067, 0.070, 0.070, 0.068, 0.063, 0.085}},
    {10000,
     {0.194, -0.238, 0.030, -0.034, 0.428, -0.589},
     {0.021, 0.023, 0.019, 0.021, 0.019, 0.021}}};

/// The stages that a model was trained with.
Calibration stages_of(const CurvatureModel& model) {
    Calibration calibration;
    calibration.radius_ratio = model.radius_ratio;
    calibration.fade = model.fade;
    calibration.tau = model.tau;
    calibration.normal_passes = model.normal_passes;
    calibration.averaged = model.map.averaged;
    return calibration;
}

/// Closed form and calibrated, over clouds drawn anew.
std::array<Spread, 2> measure(const CurvatureModel& model, const Shape& shape,
                              const std::array<double, 3>& place, int samples, int repeats) {
    const Calibration stages = stages_of(model);
    std::vector<std::array<double, 2>> estimates(static_cast<std::size_t>(repeats));
#pragma omp parallel for schedule(dynamic)
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(repeat);
        const DenseCloud cloud = dense_cloud(shape, place, {1000, 300, 0}, seed);
        const CurvatureSample sample = dense_sample(cloud, stages, samples, seed);
        estimates[static_cast<std::size_t>(repeat)] = {
            sample.closed_form,
            curvature_of(model.map, {sample.turning, sample.square}, sample.closed_form)};
    }
    std::array<Spread, 2> spreads;
    for (const auto& estimate : estimates)
        for (std::size_t form : {0, 1})
            spreads[form].add(estimate[form]);
    return spreads;
}

/// One of the six measurements of a row: at each tip from inside and from outside.
std::vector<Cell> ellipsoid_row(const CurvatureModel& model, const Published& row, std::size_t cell,
                                int repeats) {
    static const Shape shape = ellipsoid({5, 10, 20}); // 100, 200, 400 for h = 20
    constexpr std::array<double, 3> tips[] = {{0, 10, 0}, {5, 0, 0}, {0, 0, 20}};
    const Shape side = cell % 2 == 0 ? shape : outside(shape);
    const auto& tip = tips[cell / 2];
    const double truth = nearest_surface_point(side, tip).mean_curvature;
    const auto [closed, calibrated] = measure(model, side, tip, row.samples, repeats);
    const double bias = std::fabs(row.mean[cell] - truth);
    // What 40 measurements can tell from none.
    const bool is_told = bias > row.deviation[cell] / std::sqrt(40.0);
    return {row.samples,
            truth,
            fmt::format("{:+.3f} +- {:.3f}", row.mean[cell], row.deviation[cell]),
            fmt::format("{:+.3f} +- {:.3f}", closed.mean(), closed.deviation()),
            fmt::format("{:+.4f} +- {:.4f}", calibrated.mean(), calibrated.deviation()),
            is_told ? Cell(std::fabs(calibrated.mean() - truth) / bias) : Cell("within noise"),
            calibrated.deviation() / row.deviation[cell]};
}

Tables ellipsoids(const TableInput& input) {
    constexpr int repeats = 400;
    const CurvatureModel model = read_curvature_model(input.files[0]);
    Table table = table_of("curvature-ellipsoid",
                           "samples | h kappa {:+.4f} | paper | closed form | calibrated | bias, "
                           "of the paper's {:.2f} | deviation, of the paper's {:.2f}");
    for (const Published& row : published)
        for (std::size_t cell = 0; cell < 6; ++cell)
            table.add(ellipsoid_row(model, row, cell, repeats));
    return {table};
}

/// Of the ball with the same mean squared distance from the center of mass.
double gyration_radius(const Positions& positions) {
    const double share = 1 / static_cast<double>(positions.size());
    Vector3 center = {0, 0, 0};
    for (const auto& position : positions)
        center = sum(center, scaled(share, position));
    double squares = 0;
    for (const auto& position : positions) {
        const Vector3 arm = difference(position, center);
        squares += share * dot(arm, arm);
    }
    return std::sqrt(squares * 5 / 3);
}

std::vector<Cell> droplet_row(const std::filesystem::path& file) {
    const Snapshot snapshot = read_snapshot_in_3d(file);
    const auto state = fluid_state<double>(snapshot, file.string());
    const double h = state.support_radius;
    const auto count = static_cast<double>(state.size());
    const double spacing_radius = std::cbrt(3 * count / (4 * pi)) * state.spacing;
    std::vector<Cell> row = {file.stem().string(), state.size(),
                             h / gyration_radius(snapshot.positions), h / spacing_radius};
    for (const CurvatureMap& map : {closed_form_map(3), shipped_curvature_map(3)}) {
        SurfaceTensionOptions options;
        options.curvature_map = map;
        SurfaceTension<double, 3> tension(options);
        tension.step(state.view<3>(), state.size(), UniformRadius<double>{h}, OpenMpLoop{});
        Spread curvature;
        const auto& surface = tension.surface();
        for (std::size_t slot = 0; slot < surface.size(); ++slot)
            curvature.add(h * surface.curvature[slot], surface.weight[slot]);
        row.emplace_back(fmt::format("{:.4f} +- {:.3f}", curvature.mean(), curvature.deviation()));
    }
    return row;
}

Tables droplets(const TableInput& input) {
    Table table =
        table_of("curvature-droplet", "state | particles | h / R, by gyration {:.4f} | h / R, by N "
                                      "spacing^3 {:.4f} | closed form | calibrated");
    for (const auto& file : input.files)
        table.add(droplet_row(file));
    return {table};
}

} // namespace

TableGroup curvature_map_tables() {
    return {"Curvature",
            {{"curvature-ablation", "CONFIG", 1,
              "which terms a map needs, on a calibration's clouds", ablation},
             {"curvature-ellipsoid", "MODEL", 1, "the 2019 preprint's Table 2", ellipsoids},
             {"curvature-droplet", "SNAPSHOT...", 1, "on nearly spherical droplets", droplets}}};
}

} // namespace meniscus
