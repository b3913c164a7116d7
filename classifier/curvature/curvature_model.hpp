// A curvature model is a map from how normals turn to mean curvature
// (runtime/surface/curvature_map.hpp) together with what it was trained on and how far off it was
// there. Stored as JSON, exported as a coefficient header (header_export.hpp).
#pragma once

#include "curvature_samples.hpp"
#include <meniscus/classifier/model/model.hpp>

#include <meniscus/runtime/surface/curvature_map.hpp>

#include <functional>

namespace meniscus {

/// How far off the map is on clouds of one shape and arrangement, whatever their spacing and
/// sampling, as h kappa.
struct CurvatureResidual {
    std::string shape; ///< "sphere", "outside of sphere", ...
    std::string arrangement;
    double size = 0; ///< h / R
    std::size_t particles = 0;
    double curvature = 0; ///< mean of the truth
    double bias = 0;      ///< mean of estimate - truth
    double max_bias = 0;  ///< of one of its groups, in absolute value
    double deviation = 0; ///< of the estimate's error about each group's mean
};

struct CurvatureModel {
    CurvatureMap map{};
    std::string clouds; ///< "filled" or "dense"
    double radius_ratio = 0.8;
    double fade = 0;
    double tau = 0;
    int normal_passes = 0;
    Range spacing_ratio; ///< h / particle spacing seen in training
    double bias_penalty = 0;
    double min_curvature = 0;
    std::uint64_t seed = 0;
    std::size_t cloud_count = 0;
    std::size_t particles = 0;
    std::vector<CurvatureResidual> residuals;
    std::string file; ///< where it was read from, for messages; not stored
};

/// Fits a map to groups of samples, with the calibration's terms: least squares of the variance of
/// each group's errors plus `bias_penalty` times its squared mean error, because regression on all
/// samples alike shrinks towards their mean and is then biased at every curvature. Coefficients are
/// rounded to six digits, where machines agree. Throws InputError where there is no group,
/// FailureError where libtorch is not there.
CurvatureModel fit_curvature_model(const std::vector<CurvatureGroup>& groups,
                                   const Calibration& calibration);

/// The same on the groups that the calibration itself gives. Throws InputError where a cloud cannot
/// be filled or none has a surface particle, FailureError as above.
CurvatureModel calibrate(const Calibration& calibration,
                         const std::function<void(std::size_t, std::size_t)>& progress);

/// How far off the map is on all clouds of one shape, in any size and arrangement, one line each:
/// "sphere, h/R 0.1 to 0.7: off by at most 0.051, +- 0.024".
std::vector<std::string> residual_lines(const CurvatureModel& model);

/// Reads a curvature model. Throws InputError, naming file and key, where it is no JSON, where a
/// key is missing or of the wrong type, where a number is not finite or not plausible, or where it
/// is a model of another kind.
CurvatureModel read_curvature_model(const std::filesystem::path& file);

/// The same from text; `file` is for messages.
CurvatureModel curvature_model_from_json(const std::string& text,
                                         const std::filesystem::path& file);

/// The model as JSON text (stable key order), ending in a line break.
std::string curvature_model_to_json(const CurvatureModel& model);

/// Whether the file says of itself that it is a curvature model. Throws InputError where it is not
/// JSON or cannot be read.
bool is_curvature_model(const std::filesystem::path& file);

/// Throws InputError, naming the model, where it is of another dimension.
void check_dimension(const CurvatureModel& model, int dimension, const std::string& file);

} // namespace meniscus
