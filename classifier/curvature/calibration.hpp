// What a curvature map is trained on: a JSON file that says which clouds of particles to fill
// (configs/curvature/ has those of the shipped maps, docs/curvature.md every key). Lengths are in
// support radii. Two kinds of clouds: `filled` ones are as a solver has them, one particle per
// spacing^dimension, and every surface particle is a sample; `dense` ones are the 2019 preprint's
// (its Table 2), about a thousand neighbors and as many on the surface, drawn anew for each sample
// at a given place.
#pragma once

#include <meniscus/data/clouds/clouds.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace meniscus {

/// The terms that a map may have, in the order of CurvatureMap::coefficients.
const std::vector<std::string>& curvature_terms();

/// A shape in several sizes. Its proportions, divided by h / R, are its lengths.
struct CalibrationShape {
    std::string kind;                ///< as the functions of shapes.hpp
    std::vector<double> proportions; ///< none, semi-axes, ring and tube, or a and b (times h / R)
    std::vector<double> sizes;       ///< h / R
    std::vector<Side> sides;
    std::vector<std::array<double, 3>> places; ///< `dense`: in units of R; the nearest point counts
};

struct CalibrationArrangement {
    Arrangement kind = Arrangement::relaxed;
    double jitter = 0; ///< in spacings
};

struct FilledClouds {
    std::vector<double> spacing_ratios; ///< h / spacing
    std::vector<CalibrationArrangement> arrangements;
    int particles = 0; ///< samples of a group: as many clouds are drawn, at most 10
};

struct DenseClouds {
    int neighbors = 0;  ///< inside the fluid, about; as many again on its surface
    int candidates = 0; ///< of those on the surface, about; their normals count
    int repeats = 0;    ///< clouds of a group, one sample each
};

struct Calibration {
    int dimension = 3;
    double radius_ratio = 0.8;
    double fade = 1.0 / 3;      ///< exposure_weight
    double tau = 0.5;           ///< of smooth_normals
    int normal_passes = 1;      ///< of smooth_normals
    bool averaged = true;       ///< CurvatureMap::averaged
    std::vector<bool> has_term; ///< one entry a term: false keeps its coefficient 0
    double bias_penalty = 0;    ///< of a group's squared mean error, against its variance
    double min_curvature = 0;   ///< |h kappa| below which errors count as they are; above,
                                ///< relative to it
    std::vector<int> samples;   ///< a particle; 0: exact coverage
    std::uint64_t seed = 0;
    bool is_dense = false;
    FilledClouds filled; ///< unless dense
    DenseClouds dense;
    std::vector<CalibrationShape> shapes;
};

/// The shape with h / R = size, on that side. Throws InputError where the kind is unknown, of the
/// other dimension, or does not have so many proportions.
Shape shape_of(const CalibrationShape& shape, double size, Side side, int dimension);

/// Reads a calibration. Throws InputError, naming file and key, where it is no JSON, where a key is
/// missing, unknown or not plausible.
Calibration read_calibration(const std::filesystem::path& file);

/// The same from text; `file` is for messages.
Calibration calibration_from_json(const std::string& text, const std::filesystem::path& file);

} // namespace meniscus
