// The table of options of surface tension: each once, with its range, its unit and its meaning. The
// check of the runtime, the C interface, the options of `meniscus classify`, the keys of scenes and
// what snapshots say of how they were made are all read from here. A new option is a row here and
// the member that it names, in SurfaceTensionOptions and in meniscus_options.
#pragma once

#include "../errors.hpp"
#include "../features/classifier.hpp"
#include "surface_options.hpp"

#include <cfloat>
#include <cstdio>
#include <limits>
#include <type_traits>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The values that an option may have: numbers from min to max, or words, each an enumerator.
struct OptionRange {
    double min;
    double max;
    const char* text; ///< goes on after "must be"
    const char* words[2] = {nullptr, nullptr};
};

namespace option_ranges {

inline constexpr OptionRange line = {-1e6, 1e6, "between -1000000 and 1000000"};
inline constexpr OptionRange below_1 = {DBL_MIN, 1 - DBL_EPSILON / 2, "above 0 and below 1"};
inline constexpr OptionRange share = {0, 1, "between 0 and 1"};
inline constexpr OptionRange samples = {4, 16384, "a whole number from 4 to 16384"};
inline constexpr OptionRange seed = {0, 0x1p64, "a whole number from 0 to 18446744073709551615"};
inline constexpr OptionRange passes = {0, 1000, "a whole number from 0 to 1000"};
inline constexpr OptionRange finite = {-DBL_MAX, DBL_MAX, "finite"};
inline constexpr OptionRange positive = {DBL_MIN, DBL_MAX, "positive and finite"};
inline constexpr OptionRange spacings = {0.1, 1000, "between 0.1 and 1000"};
inline constexpr OptionRange contact_angle = {10, 170, "between 10 and 170"};
inline constexpr OptionRange weight = {0, 10, "between 0 and 10"};
inline constexpr OptionRange pressure = {0, 10, "between 0 and 10"};
inline constexpr OptionRange coverage = {0, 1, "sampled or exact", {"sampled", "exact"}};
inline constexpr OptionRange verification = {0, 1, "exact or drop", {"exact", "drop"}};
inline constexpr OptionRange curvature = {0, 1, "closed or mapped", {"closed", "mapped"}};
inline constexpr OptionRange force = {0, 1, "paper or calibrated", {"paper", "calibrated"}};

} // namespace option_ranges

/// ROW(name, range, only for coverage by samples, unit, meaning) for each option.
// clang-format off
#define MENISCUS_SURFACE_TENSION_OPTIONS(ROW)                                                      \
    ROW(k, line, false, "neighbors",                                                               \
        "Slope of the classifier's line: candidates have y <= k x + d")                            \
    ROW(d, line, false, "neighbors", "Height of the classifier's line")                            \
    ROW(boundary_weight, weight, false, "",                                                        \
        "Share of its volume by which a boundary particle counts in the features of the lines; "   \
        "0: it only covers")                                                                       \
    ROW(radius_ratio, below_1, false, "", "r2 / r1 that the line was trained with")                \
    ROW(coverage, coverage, false, "",                                                             \
        "Uncovered part of a candidate's sphere from samples, or in closed form (slower)")         \
    ROW(samples, samples, true, "", "Samples of a candidate's sphere")                             \
    ROW(seed, seed, true, "", "Seed of the samples")                                              \
    ROW(verification, verification, true, "",                                                      \
        "Candidates without an uncovered sample: the exact test decides, or they are covered")     \
    ROW(fade, share, false, "",                                                                    \
        "Exposure at which a surface particle has its full weight, over that on a flat surface; "  \
        "0: always")                                                                               \
    ROW(normal_passes, passes, false, "", "Smoothing passes of the normals")                       \
    ROW(tau, share, false, "", "Share of the neighbors in a smoothing pass")                       \
    ROW(covariance_share, share, false, "",                                                        \
        "Share of the minor axis of the surface particles around in normals")                      \
    ROW(curvature, curvature, false, "",                                                           \
        "Curvature from the uncovered fraction alone, or by the map over the turning of the "      \
        "normals")                                                                                 \
    ROW(curvature_passes, passes, false, "", "Smoothing passes of the curvature")                  \
    ROW(force, force, false, "",                                                                   \
        "The paper's force, or the one in which sigma is what it says")                            \
    ROW(surface_tension, finite, false, "N/m", "Sigma")                                            \
    ROW(spacing_ratio, spacings, false, "", "Support radius over particle spacing at rest")        \
    ROW(contact_angle, contact_angle, false, "degrees",                                            \
        "At which the surface meets a wall when both are at rest, measured in the fluid")          \
    ROW(ambient_pressure, pressure, false, "(D - 1) sigma / h",                                    \
        "Of the air, which keeps the fluid's own pressure above zero where the surface is hollow")
// clang-format on

/// A row of the table.
template <class Value>
struct SurfaceOption {
    const char* name;
    Value SurfaceTensionOptions::*member;
    const OptionRange& range;
    bool only_sampled; ///< without a meaning for CoverageMethod::exact
    const char* unit;  ///< "" where it has none
    const char* meaning;
};

/// True for k and d, which are given both or neither.
template <class Value>
bool is_of_line(const SurfaceOption<Value>& option) {
    return &option.range == &option_ranges::line;
}

/// Calls visit(SurfaceOption<Value>) for each option, in the order of the table.
template <class Visit>
void for_each_surface_option(const Visit& visit) {
#define MENISCUS_ROW(name, range, only_sampled, unit, meaning)                                     \
    visit(SurfaceOption<decltype(SurfaceTensionOptions::name)>{                                    \
        #name, &SurfaceTensionOptions::name, option_ranges::range, only_sampled, unit, meaning});
    MENISCUS_SURFACE_TENSION_OPTIONS(MENISCUS_ROW)
#undef MENISCUS_ROW
}

/// The 2020 paper's method as published: sampled coverage alone, the closed form smoothed once,
/// every surface particle with weight 1, and its force times the face of a particle.
inline SurfaceTensionOptions paper_options() {
    SurfaceTensionOptions options{};
    options.verification = Verification::drop;
    options.fade = 0;
    options.curvature = CurvatureForm::closed;
    options.curvature_passes = 1;
    options.force = ForceForm::paper;
    return options;
}

/// Sets the line of the classifier.
inline void set_line(SurfaceTensionOptions& options, const SurfaceLine<double>& line) {
    options.k = line.k;
    options.d = line.d;
}

/// A first line that leaves all to the second.
inline constexpr SurfaceLine<double> line_that_passes_all{0, 1e6};

/// Sets what makes the classifier of an exported coefficient struct: its lines, for the options'
/// spacing_ratio where they follow it, the boundary's weight and the radius ratio. A line of other
/// features than the paper's becomes the second one, after a first that leaves all to it.
template <class Coefficients>
void set_classifier(SurfaceTensionOptions& options) {
    const double ratio = options.spacing_ratio;
    options.second_line = {};
    if constexpr (has_features_of_paper<Coefficients>)
        set_line(options, surface_line<Coefficients, double>(ratio));
    else
        set_line(options, line_that_passes_all);
    if constexpr (!has_features_of_paper<Coefficients>)
        options.second_line = as_second_line<Coefficients>(count_scale<Coefficients>(ratio));
    else if constexpr (has_second_line<Coefficients>)
        options.second_line =
            as_second_line<typename Coefficients::SecondLine>(count_scale<Coefficients>(ratio));
    options.boundary_weight = boundary_weight<Coefficients>;
    options.radius_ratio = Coefficients::radius_ratio;
}

/// True where both k and d are NaN, which asks for the classifier that ships.
inline bool takes_shipped_line(const SurfaceTensionOptions& options) {
    const auto is_nan = [](double value) {
        return bits_of(value) << 1 > bits_of(std::numeric_limits<double>::infinity()) << 1;
    };
    return is_nan(options.k) && is_nan(options.d);
}

/// False for what is not a number, too.
inline bool is_in_range(const OptionRange& range, double value) {
    return is_finite(value) && value >= range.min && value <= range.max;
}

/// Throws std::invalid_argument (errors.hpp), naming the option and its range, where the value is
/// outside.
inline void check_option(const char* name, const OptionRange& range, double value) {
    if (is_in_range(range, value))
        return;
    char text[160];
    if (range.words[0] != nullptr)
        std::snprintf(text, sizeof text, "%s must be 0 (%s) or 1 (%s), found %.9g", name,
                      range.words[0], range.words[1], value);
    else
        std::snprintf(text, sizeof text, "%s must be %s, found %.9g", name, range.text, value);
    refuse(text);
}

/// Throws as check_option() does where a value is out of the range of the option that the member
/// is.
template <class Value>
void check_option(Value SurfaceTensionOptions::*member, Value value) {
    for_each_surface_option([&](const auto& option) {
        if constexpr (std::is_same_v<decltype(option.member), Value SurfaceTensionOptions::*>)
            if (option.member == member)
                check_option(option.name, option.range, static_cast<double>(value));
    });
}

inline void check(const SecondLine& line) {
    if (!line.is_there)
        return;
    if (line.x >= feature_count || line.y >= feature_count || line.x == line.y)
        refuse("second_line must be of two different features of features/list.hpp");
    check_option("second_line.k", option_ranges::line, line.k);
    check_option("second_line.d", option_ranges::line, line.d);
}

/// Throws std::invalid_argument (errors.hpp), naming the option and its range, where one is out of
/// it or the curvature map is of another dimension.
inline void check(const SurfaceTensionOptions& options, int dimension) {
    const bool shipped_line = takes_shipped_line(options);
    for_each_surface_option([&](const auto& option) {
        if (!(shipped_line && is_of_line(option)))
            check_option(option.name, option.range, static_cast<double>(options.*option.member));
    });
    check(options.second_line);
    const CurvatureMap& map = options.curvature_map;
    const int of_map = map.dimension;
    bool is_map = map.min <= map.max;
    for (const double value : {map.min, map.max, map.coefficients[0], map.coefficients[1],
                               map.coefficients[2], map.coefficients[3]})
        is_map = is_map && is_finite(value);
    if (options.curvature == CurvatureForm::mapped && of_map != 0 && !is_map)
        refuse("curvature_map must have finite coefficients and a range from min to max");
    if (options.curvature == CurvatureForm::mapped && of_map != 0 && of_map != dimension)
        refuse("curvature_map is not of the dimension of the fluid");
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
