// How true the curvature is on filled clouds that no map was trained on, by the closed form (2020
// paper, eqs. 14 and 17) and calibrated.
#include "curvature_errors.hpp"
#include "support/tables.hpp"

#include <cmath>
#include <fmt/format.h>

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

/// A shape whose mean curvature is `scale`, or about that, on both sides.
struct Case {
    std::string name;
    Shape shape;
    double scale; ///< h kappa; biases are relative to it
};

/// Both maps' errors, exact and with 128 samples, on clouds of one spacing after another.
template <int Dimension>
void add_row(const Case& one, const Standing& standing, std::uint64_t& seed, Table& table) {
    const int repeats = std::fabs(one.scale) < 0.15 ? 1 : 3; // small shapes have few particles
    MapErrors exact;
    MapErrors sampled;
    double max_bias = 0;
    for (const double ratio : spacing_ratios) {
        MapErrors here;
        for (int repeat = 0; repeat < repeats; ++repeat) {
            CloudOptions options = known_cloud(standing.jitter, ratio);
            options.arrangement = standing.kind;
            options.seed = seed++;
            const auto known = curvature_cloud(one.shape, options);
            add_curvature_errors<Dimension>(known, 0, OpenMpLoop{}, exact);
            add_curvature_errors<Dimension>(known, 128, OpenMpLoop{}, here);
        }
        max_bias = std::fmax(max_bias, std::fabs(here[1].mean()));
        for (const std::size_t map : {0, 1})
            sampled[map].add(here[map]);
    }
    const double percent = 100 / std::fabs(one.scale);
    table.add({one.name, one.scale, standing.name});
    for (const std::size_t map : {0, 1})
        for (const Spread& errors : {exact[map], sampled[map]})
            table.rows.back().emplace_back(
                fmt::format("{:+.1f} % +- {:.3f}", percent * errors.mean(), errors.deviation()));
    table.rows.back().emplace_back(percent * max_bias);
}

template <int Dimension>
Tables errors_on(const char* name, const std::vector<Case>& cases) {
    Table table = table_of(name, "shape | h kappa {:+.2f} | particles | closed, exact | closed, "
                                 "128 | calibrated, exact | calibrated, 128 | largest {:.1f} %");
    std::uint64_t seed = 7000;
    for (const Case& one : cases)
        for (const Standing& standing : standings)
            add_row<Dimension>(one, standing, seed, table);
    return {table};
}

/// With the inside of the same shape out of the fluid.
void add_both_sides(const char* inside, const std::string& outside_name, const Shape& shape,
                    double scale, std::vector<Case>& cases) {
    cases.push_back({inside, shape, scale});
    cases.push_back({outside_name, outside(shape), -scale});
}

Tables filled(const TableInput&) {
    std::vector<Case> cases;
    for (const double curvature : {0.05, 0.17, 0.35, 0.47})
        add_both_sides("sphere", "cavity", sphere(1 / curvature), curvature, cases);
    add_both_sides("cylinder", "outside of cylinder", cylinder(2, 12), 0.25, cases);
    add_both_sides("ellipsoid", "outside of ellipsoid", ellipsoid({3, 4, 6}), 0.25, cases);
    add_both_sides("torus", "outside of torus", torus(5, 2.2), 0.22, cases);
    return errors_on<3>("curvature-filled", cases);
}

Tables circles(const TableInput&) {
    std::vector<Case> cases;
    for (const double curvature : {0.05, 0.17, 0.35, 0.47})
        add_both_sides("circle", "cavity", circle(1 / curvature), curvature, cases);
    return errors_on<2>("curvature-circles", cases);
}

} // namespace

TableGroup curvature_cloud_tables() {
    return {"Curvature",
            {{"curvature-filled", "", 0, "on filled clouds that no map was trained on", filled},
             {"curvature-circles", "", 0, "the same in two dimensions", circles}}};
}

} // namespace meniscus
