// The coefficient header is how a model reaches a solver: a C++ file of constexpr values that the
// runtime consumes as a template argument (classify<Coefficients>, curvature_map<Coefficients>),
// with what the model was trained on as comments. It includes nothing and compiles alone, so it can
// be copied anywhere.
#pragma once

#include <meniscus/classifier/curvature/curvature_model.hpp>
#include <meniscus/classifier/model/model.hpp>

#include <string>

namespace meniscus {

/// The header's text: `namespace meniscus { struct NAME { ... }; }` with k, d, dimension,
/// radius_ratio, label_threshold, min_ and max_bulk_neighbor_count, min_ and max_spacing_ratio (0
/// where not known); where the line is not in the paper's features also their names (features)
/// and its side (surface_above). Numbers read back to the same bits. Throws InputError where
/// `struct_name` is not a C++ identifier that a program may use, or where the model has a number
/// that is not finite.
std::string coefficient_header(const Model& model, const std::string& struct_name);

/// The header of a curvature map, for curvature_map<NAME>(): dimension, coefficients, least and
/// largest turning, averaged, and what it holds for: radius_ratio, fade, tau, normal_passes,
/// min_ and max_spacing_ratio. Throws as above.
std::string coefficient_header(const CurvatureModel& model, const std::string& struct_name);

} // namespace meniscus
