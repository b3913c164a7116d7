// How true the curvature is, by the closed form (2020 paper, eqs. 14 and 17) and calibrated.
//   filled    on filled clouds that no map was trained on
//   circles   the same in two dimensions
//   ablation CONFIG...   which terms a map needs, on the clouds of a calibration
//   ellipsoid MODEL [REPEATS]   the 2019 preprint's Table 2, with a map for dense clouds
//   droplet SNAPSHOT...   on nearly spherical droplets of a solver
// Usage: curvature_accuracy TABLE [ARGUMENTS]
#include "curvature_errors.hpp"

#include <meniscus/classifier/curvature_model.hpp>
#include <meniscus/data/errors.hpp>
#include <meniscus/data/snapshot_files.hpp>

#include <cstdio>
#include <fmt/format.h>
#include <string>

namespace meniscus {
namespace {

/// How particles stand in the tables.
struct Standing {
    const char* name;
    Arrangement kind;
    double jitter;
};
constexpr Standing standings[] = {{"relaxed", Arrangement::relaxed, 0},
                                  {"relaxed, jitter 0.15", Arrangement::relaxed, 0.15},
                                  {"lattice", Arrangement::lattice, 0}};

/// Not those of any calibration in configs/curvature.
constexpr double spacing_ratios[] = {1.9, 2.15, 2.5};

constexpr std::uint64_t first_seed = 7000;

/// A shape whose mean curvature is `scale`, or about that, on both sides.
struct Case {
    std::string name;
    Shape shape;
    double scale; ///< h kappa; biases are relative to it
};

/// Both maps' errors, exact and with 128 samples, on clouds of one spacing after another.
template <int Dimension>
void print_row(const Case& one, const Standing& standing, std::uint64_t& seed) {
    const std::vector<CurvatureMap> maps = {closed_form_map(Dimension),
                                            shipped_curvature_map(Dimension)};
    const int repeats = std::fabs(one.scale) < 0.15 ? 1 : 3; // small shapes have few particles
    Spread exact[2];
    Spread sampled[2];
    double largest_bias = 0;
    for (const double ratio : spacing_ratios) {
        Spread here[2];
        for (int repeat = 0; repeat < repeats; ++repeat) {
            const KnownCloud<Dimension> cloud(one.shape, ratio, standing.kind, standing.jitter,
                                              seed++);
            cloud.add_errors(maps, 0, OpenMpLoop{}, exact);
            cloud.add_errors(maps, 128, OpenMpLoop{}, here);
        }
        largest_bias = std::fmax(largest_bias, std::fabs(here[1].mean()));
        for (const int map : {0, 1})
            sampled[map].add(here[map]);
    }
    const double percent = 100 / std::fabs(one.scale);
    fmt::print("| {} | {:+.2f} | {} |", one.name, one.scale, standing.name);
    for (const int map : {0, 1})
        for (const Spread& errors : {exact[map], sampled[map]})
            fmt::print(" {:+.1f} % +- {:.3f} |", percent * errors.mean(), errors.deviation());
    fmt::print(" {:.1f} % |\n", percent * largest_bias);
}

template <int Dimension>
void print_errors(const std::vector<Case>& cases) {
    fmt::print("| shape | h kappa | particles | closed, exact | closed, 128 | calibrated, exact | "
               "calibrated, 128 | largest |\n|---|---|---|---|---|---|---|---|\n");
    std::uint64_t seed = first_seed;
    for (const Case& one : cases)
        for (const Standing& standing : standings)
            print_row<Dimension>(one, standing, seed);
}

void print_filled() {
    std::vector<Case> cases;
    for (const double curvature : {0.05, 0.17, 0.35, 0.47}) {
        cases.push_back({"sphere", sphere(1 / curvature), curvature});
        cases.push_back({"cavity", outside(sphere(1 / curvature)), -curvature});
    }
    const auto add = [&](const std::string& name, const Shape& shape, double scale) {
        cases.push_back({name, shape, scale});
        cases.push_back({"outside of " + name, outside(shape), -scale});
    };
    add("cylinder", cylinder(2, 12), 0.25);
    add("ellipsoid", ellipsoid({3, 4, 6}), 0.25);
    add("torus", torus(5, 2.2), 0.22);
    print_errors<3>(cases);
}

void print_circles() {
    std::vector<Case> cases;
    for (const double curvature : {0.05, 0.17, 0.35, 0.47}) {
        cases.push_back({"circle", circle(1 / curvature), curvature});
        cases.push_back({"cavity", outside(circle(1 / curvature)), -curvature});
    }
    print_errors<2>(cases);
}

/// Root mean square over the rows of a model, relative to the curvature, at least 0.1.
void print_residuals(const std::string& name, const CurvatureModel& model) {
    Spread biases;
    double largest = 0;
    Spread deviations;
    for (const CurvatureResidual& row : model.residuals) {
        const double scale = std::fmax(std::fabs(row.curvature), 0.1);
        biases.add(row.bias * row.bias / scale / scale);
        largest = std::fmax(largest, row.largest_bias / scale);
        deviations.add(row.deviation);
    }
    fmt::print("| {} | {:.1f} % | {:.1f} % | {:.3f} |\n", name, 100 * std::sqrt(biases.mean()),
               100 * largest, deviations.mean());
}

void print_ablation(const std::string& file) {
    Calibration calibration = read_calibration(file);
    const auto groups = curvature_groups(calibration, [](std::size_t, std::size_t) {});
    fmt::print("| terms | bias, root mean square | bias, largest | deviation |\n"
               "|---|---|---|---|\n");
    const auto try_terms = [&](const std::string& name, const std::vector<bool>& has_term) {
        calibration.has_term = has_term;
        print_residuals(name, fit_curvature_model(groups, calibration));
    };
    try_terms("closed form", {true, false, false, true});
    try_terms("turning", {true, true, false, false});
    try_terms("turning, closed form", {true, true, false, true});
    try_terms("turning, square", {true, true, true, false});
    try_terms("turning, square, closed form", {true, true, true, true});
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

void print_ellipsoid(const std::string& file, int repeats) {
    const CurvatureModel model = read_curvature_model(file);
    const Shape shape = ellipsoid({5, 10, 20}); // 100, 200, 400 for h = 20
    const std::array<double, 3> tips[] = {{0, 10, 0}, {5, 0, 0}, {0, 0, 20}};
    fmt::print("| samples | h kappa | paper | closed form | calibrated | bias, of the paper's | "
               "deviation, of the paper's |\n|---|---|---|---|---|---|---|\n");
    for (const Published& row : published)
        for (int cell = 0; cell < 6; ++cell) {
            const Shape& side = cell % 2 == 0 ? shape : outside(shape);
            const auto& tip = tips[cell / 2];
            const double truth = nearest_surface_point(side, tip).mean_curvature;
            const auto [closed, calibrated] = measure(model, side, tip, row.samples, repeats);
            const double bias = std::fabs(row.mean[cell] - truth);
            // What 40 measurements can tell from none.
            const bool is_told = bias > row.deviation[cell] / std::sqrt(40.0);
            fmt::print("| {} | {:+.4f} | {:+.3f} +- {:.3f} | {:+.3f} +- {:.3f} | {:+.4f} +- {:.4f} "
                       "| {} | {:.2f} |\n",
                       row.samples, truth, row.mean[cell], row.deviation[cell], closed.mean(),
                       closed.deviation(), calibrated.mean(), calibrated.deviation(),
                       is_told ? fmt::format("{:.2f}", std::fabs(calibrated.mean() - truth) / bias)
                               : "within noise",
                       calibrated.deviation() / row.deviation[cell]);
        }
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

void print_droplet(const std::string& file) {
    const Snapshot snapshot = read_snapshot(file);
    if (!snapshot.support_radius || snapshot.dimension != 3)
        throw InputError(file + " must be in 3D and store its support radius");
    const double h = *snapshot.support_radius;
    const double spacing = snapshot.particle_spacing.value_or(h / 2);
    const double count = static_cast<double>(snapshot.size());
    const double spacing_radius = std::cbrt(3 * count / (4 * pi)) * spacing;
    std::vector<double> positions;
    for (const auto& position : snapshot.positions)
        positions.insert(positions.end(), position.begin(), position.end());
    const NeighborLists lists = find_neighbors(snapshot.positions, h);
    const CsrNeighborhood<double, 3> view{positions.data(), nullptr, lists.offsets.data(),
                                          lists.neighbors.data()};
    const std::string stem = file.substr(file.rfind('/') + 1);
    fmt::print("| {} | {} | {:.4f} | {:.4f} |", stem.substr(0, stem.find('.')), snapshot.size(),
               h / gyration_radius(snapshot.positions), h / spacing_radius);
    for (const CurvatureMap& map : {closed_form_map(3), shipped_curvature_map(3)}) {
        SurfaceTensionOptions options = shipped_options<3>();
        options.map = map;
        SurfaceTension<double, 3> tension(options);
        tension.step(view, snapshot.size(), UniformRadius<double>{h}, OpenMpLoop{});
        Spread curvature;
        const auto& surface = tension.surface();
        for (std::size_t slot = 0; slot < surface.size(); ++slot)
            curvature.add(h * surface.curvature[slot], surface.weight[slot]);
        fmt::print(" {:.4f} +- {:.3f} |", curvature.mean(), curvature.deviation());
    }
    fmt::print("\n");
}

int run(const std::vector<std::string>& words) {
    const std::string table = words.empty() ? "" : words[0];
    const bool has_file = words.size() > 1;
    if (table == "filled")
        print_filled();
    else if (table == "circles")
        print_circles();
    else if (table == "ablation" && has_file)
        print_ablation(words[1]);
    else if (table == "ellipsoid" && has_file)
        print_ellipsoid(words[1], words.size() > 2 ? std::stoi(words[2]) : 400);
    else if (table == "droplet" && has_file) {
        fmt::print("| state | particles | h / R, by gyration | h / R, by N spacing^3 | closed form "
                   "| calibrated |\n|---|---|---|---|---|---|\n");
        for (std::size_t i = 1; i < words.size(); ++i)
            print_droplet(words[i]);
    } else
        throw InputError("usage: curvature_accuracy filled | circles | ablation CONFIG | "
                         "ellipsoid MODEL [REPEATS] | droplet SNAPSHOT...");
    return 0;
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        return meniscus::run({arguments + 1, arguments + argument_count});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "curvature_accuracy: %s\n", error.what());
        return 2;
    }
}
