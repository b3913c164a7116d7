// What the ratio of radii r2 / r1 does to normals, curvature and classes, on the saddle, a ball and
// the state of a droplet.
#include "normal_schemes.hpp"
#include "support/tables.hpp"

#include <meniscus/runtime/surface/curvature.hpp>

#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace meniscus {
namespace {

constexpr std::size_t samples = 128;
constexpr std::size_t few_samples = 30; // and random, as published
constexpr std::size_t clouds = 8;
using List = SurfaceParticles<double, 3>;

struct RatioErrors {
    Spread angle;     ///< degrees
    Spread curvature; ///< of h kappa
    Spread lost;      ///< 1 for outermost particles that are not surface
    Spread beneath;   ///< 1 for other candidates that are
};

/// Against the known mean curvature, times h.
Spread curvature_error(const NormalCase& some, const List& list) {
    Spread error;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        if (some.measured[i] == 0 || list.surface_class[slot] != SurfaceClass::surface)
            continue;
        error.add(some.cloud.support_radius *
                  (list.curvature[slot] - some.cloud.mean_curvature[i]));
    }
    return error;
}

void add_classes(const NormalCase& some, const List& list, RatioErrors& errors) {
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        const bool is_surface = list.surface_class[slot] == SurfaceClass::surface;
        if (some.outermost[i] != 0)
            errors.lost.add(is_surface ? 0 : 1);
        else if (some.cloud.trusted[i] != 0)
            errors.beneath.add(is_surface ? 1 : 0);
    }
}

using Fill = void (*)(std::size_t seed, SampleDirections& directions);

void fill_outward(std::size_t seed, SampleDirections& directions) {
    fill_outward_directions<3>(samples, seed, directions);
}

void fill_few_random(std::size_t seed, SampleDirections& directions) {
    fill_from_scheme("random", 3, few_samples, seed, directions);
}

RatioErrors errors_of(const std::vector<NormalCase>& cases, const SurfaceTensionOptions& options,
                      Fill fill = fill_outward) {
    RatioErrors errors;
    SampleDirections directions;
    List list;
    for (std::size_t seed = 0; seed < cases.size(); ++seed) {
        fill(seed, directions);
        expose<3>(cases[seed], directions, options, list);
        find_curvature<double, 3>(options.radius_ratio,
                                  UniformRadius<double>{cases[seed].cloud.support_radius},
                                  SerialLoop{}, list);
        if (!cases[seed].cloud.normal.empty()) {
            errors.angle.add(angular_error<3>(cases[seed], list));
            errors.curvature.add(curvature_error(cases[seed], list));
        }
        add_classes(cases[seed], list, errors);
    }
    return errors;
}

/// Nothing where nothing is known.
Cell mean_cell(const Spread& error) {
    return error.weights > 0 ? Cell(error.mean()) : Cell("");
}

Cell root_cell(const Spread& error) {
    return error.weights > 0 ? Cell(error.root_mean_square()) : Cell("");
}

void add_rows(const std::string& name, const std::vector<NormalCase>& cases, Table& table) {
    for (const double ratio : {0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9}) {
        SurfaceTensionOptions sampled;
        sampled.radius_ratio = ratio;
        sampled.verification = Verification::drop;
        SurfaceTensionOptions exact = sampled;
        exact.coverage = CoverageMethod::exact;
        const RatioErrors of_samples = errors_of(cases, sampled);
        const RatioErrors of_exact = errors_of(cases, exact);
        const RatioErrors of_few = errors_of(cases, sampled, fill_few_random);
        table.add({name, ratio, mean_cell(of_samples.angle), mean_cell(of_exact.angle),
                   root_cell(of_samples.curvature), root_cell(of_exact.curvature),
                   100 * of_few.lost.mean(), 100 * of_samples.lost.mean(),
                   100 * of_exact.lost.mean(), 100 * of_exact.beneath.mean()});
    }
}

template <class Make>
std::vector<NormalCase> several(const Make& make) {
    std::vector<NormalCase> cases;
    for (std::size_t seed = 0; seed < clouds; ++seed)
        cases.push_back(make(seed));
    return cases;
}

Tables ratio_tables(const TableInput& input) {
    Table table = table_of(
        "normals-ratio",
        fmt::format(
            "case | r2/r1 {{:.2f}} | degrees, {0} samples {{:.2f}} | exact {{:.2f}} | error "
            "of h kappa, {0} samples {{:.3f}} | exact {{:.3f}} | lost %, {1} random {{:.2f}} "
            "| {0} samples {{:.2f}} | exact {{:.2f}} | beneath % {{:.1f}}",
            samples, few_samples));
    add_rows("saddle", several([](std::uint64_t seed) { return saddle_case(2, seed); }), table);
    add_rows("ball", several(ball_case), table);
    for (const auto& droplet : input.files)
        add_rows(droplet.stem().string(), {state_case(droplet)}, table);
    return {table};
}

} // namespace

TableGroup normal_ratio_tables() {
    return {"Normals",
            {{"normals-ratio", "SNAPSHOT...", 1, "what the ratio of radii does, with droplets",
              ratio_tables}}};
}

} // namespace meniscus
