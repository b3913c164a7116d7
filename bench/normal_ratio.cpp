#include "normal_schemes.hpp"
#include "normal_tables.hpp"

#include <meniscus/runtime/curvature.hpp>

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
    MeanError angle;     ///< degrees
    MeanError curvature; ///< squared, of h kappa
    MeanError lost;      ///< 1 for outermost particles that are not surface
    MeanError beneath;   ///< 1 for other candidates that are
};

/// Against the known mean curvature.
MeanError squared_curvature_error(const NormalCase& some, const List& list) {
    MeanError error;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        if (some.measured[i] == 0 || list.surface_class[slot] != SurfaceClass::surface)
            continue;
        const double difference =
            some.cloud.support_radius * (list.curvature[slot] - some.cloud.mean_curvature[i]);
        error.add(difference * difference);
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

RatioErrors errors_of(const std::vector<NormalCase>& cases, const ExposureOptions& options,
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
            errors.curvature.add(squared_curvature_error(cases[seed], list));
        }
        add_classes(cases[seed], list, errors);
    }
    return errors;
}

std::string cell(const MeanError& error, bool squared, int digits) {
    if (error.count == 0)
        return "";
    return fmt::format("{:.{}f}", squared ? std::sqrt(error.mean()) : error.mean(), digits);
}

void print_rows(const std::string& name, const std::vector<NormalCase>& cases) {
    for (const double ratio : {0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9}) {
        ExposureOptions sampled;
        sampled.radius_ratio = ratio;
        sampled.verification = Verification::drop;
        ExposureOptions exact = sampled;
        exact.method = CoverageMethod::exact;
        const RatioErrors of_samples = errors_of(cases, sampled);
        const RatioErrors of_exact = errors_of(cases, exact);
        const RatioErrors of_few = errors_of(cases, sampled, fill_few_random);
        fmt::print("| {} | {:.2f} | {} | {} | {} | {} |", name, ratio,
                   cell(of_samples.angle, false, 2), cell(of_exact.angle, false, 2),
                   cell(of_samples.curvature, true, 3), cell(of_exact.curvature, true, 3));
        for (const RatioErrors* of : {&of_few, &of_samples, &of_exact})
            fmt::print(" {:.2f} |", 100 * of->lost.mean());
        fmt::print(" {:.1f} |\n", 100 * of_exact.beneath.mean());
    }
}

template <class Make>
std::vector<NormalCase> several(const Make& make) {
    std::vector<NormalCase> cases;
    for (std::size_t seed = 0; seed < clouds; ++seed)
        cases.push_back(make(seed));
    return cases;
}

} // namespace

void print_ratio_table(const std::filesystem::path& droplet) {
    fmt::print("| case | r2/r1 | degrees, {0} samples | exact | error of h kappa, {0} samples | "
               "exact | lost %, {1} random | {0} samples | exact | beneath % |\n"
               "|---|---|---|---|---|---|---|---|---|---|\n",
               samples, few_samples);
    print_rows("saddle", several([](std::uint64_t seed) { return saddle_case(2, seed); }));
    print_rows("ball", several(ball_case));
    print_rows(droplet.stem().string(), {state_case(droplet)});
}

} // namespace meniscus
