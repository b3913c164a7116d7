#include "detector.hpp"

namespace meniscus {

template <class Real>
std::vector<Detector<Real>> detectors(int dimension, const std::filesystem::path& models) {
    std::vector<Detector<Real>> all;
    add_line_detectors(dimension, models, all);
    add_coverage_detectors(dimension, all);
    add_eigenvalue_detectors(dimension, all);
    add_divergence_detectors(dimension, all);
    add_visibility_detectors(dimension, all);
    return all;
}

template std::vector<Detector<float>> detectors(int, const std::filesystem::path&);
template std::vector<Detector<double>> detectors(int, const std::filesystem::path&);

} // namespace meniscus
