// The options of surface tension as plain data: no function and no instruction set, so that they
// may pass between files that are compiled for different ones. What each means, its unit and its
// range stand once, in option_table.hpp; the C interface, the command line and scenes have the same
// names.
#pragma once

#include "../features/classifier_options.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace meniscus {

/// How the uncovered part of a candidate is found.
enum class CoverageMethod { sampled, exact };

/// What becomes of a candidate that no sample finds uncovered.
enum class Verification {
    exact, ///< the exact test decides
    drop,  ///< covered (2020 paper)
};

/// How curvature is found: from the uncovered fraction, or by a map (curvature_map.hpp).
enum class CurvatureForm { closed, mapped };

/// Which force (surface_force.hpp).
enum class ForceForm { paper, calibrated };

/// h kappa = sum of coefficients times 1, turning, square, closed form (curvature_map.hpp).
struct CurvatureMap {
    static constexpr int terms = 4;
    int dimension; ///< 0: no map
    double coefficients[terms];
    double min; ///< turning in training; beyond, the map goes straight on
    double max;
    bool averaged = true; ///< over the surface particles around, after mapping
};

/// What a scene needs. The defaults are the project's own choices in two and three dimensions;
/// `paper_options` gives the 2020 paper's.
struct SurfaceTensionOptions {
    double k = std::numeric_limits<double>::quiet_NaN(); ///< both NaN: the classifier that ships
    double d = std::numeric_limits<double>::quiet_NaN(); ///< for the dimension, boundary included
    double boundary_weight = 0;
    double radius_ratio = 0.8;
    CoverageMethod coverage = CoverageMethod::sampled;
    std::size_t samples = 128;
    std::uint64_t seed = 0;
    Verification verification = Verification::exact;
    double fade = 1.0 / 3;
    int normal_passes = 1;
    double tau = 0.5;
    double covariance_share = 0;
    CurvatureForm curvature = CurvatureForm::mapped;
    int curvature_passes = 0;
    ForceForm force = ForceForm::calibrated;
    double surface_tension = 0.072;
    double spacing_ratio = 2;
    double contact_angle = 90;    ///< of walls, degrees
    double ambient_pressure = 0;  ///< in (D - 1) sigma / h (surface_force.hpp)
    SecondLine second_line{};     ///< of the classifier
    CurvatureMap curvature_map{}; ///< of dimension 0: the one that ships for the dimension
};

} // namespace meniscus
