// The plane of a line's two features with the particles of labelled states in it: the picture of
// what a line does.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/drawing/chart.hpp>

#include <filesystem>
#include <vector>

namespace meniscus {

/// A panel for each line of the model, the second one with what the first lets through. Surface is
/// by label, above the model's threshold; interior particles that a line lets through, and surface
/// that it misses, are series of their own. Counts are scaled to the support radius that the line
/// is for. Throws InputError, naming the file, where one was not labelled or is of another kind
/// than the model.
Chart feature_planes(const Model& model, const std::vector<std::filesystem::path>& files,
                     int threads);

} // namespace meniscus
