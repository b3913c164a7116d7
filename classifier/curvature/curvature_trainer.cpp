#include "curvature_model.hpp"
#include "curvature_samples.hpp"
#include <meniscus/classifier/torch/torch_plugin.hpp>

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace meniscus {
namespace {

constexpr int coefficient_digits = 6; ///< results of libtorch may differ beyond

double rounded(double value) {
    return *number_from_text(rounded_text(value, coefficient_digits));
}

std::array<double, CurvatureMap::terms> features(const CurvatureSample& sample) {
    return {1, sample.turning, sample.square, sample.closed_form};
}

/// Mean over a group, by weight.
template <class Value>
double mean(const CurvatureGroup& group, const Value& value) {
    double sum = 0;
    double weights = 0;
    for (const CurvatureSample& sample : group.samples) {
        sum += sample.weight * value(sample);
        weights += sample.weight;
    }
    return sum / weights;
}

double mean_curvature(const CurvatureGroup& group) {
    return mean(group, [](const CurvatureSample& sample) { return sample.curvature; });
}

/// Rows of the fit: the terms that the map has, group by group. Errors of a group count relative
/// to its curvature.
CurvatureFitSet fit_set(const std::vector<CurvatureGroup>& groups, const Calibration& calibration) {
    CurvatureFitSet set;
    set.bias_penalty = calibration.bias_penalty;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const double scale =
            std::max(std::fabs(mean_curvature(groups[g])), calibration.min_curvature);
        for (const CurvatureSample& sample : groups[g].samples) {
            const auto values = features(sample);
            for (std::size_t term = 0; term < values.size(); ++term)
                if (calibration.has_term[term])
                    set.features.push_back(values[term] / scale);
            set.truth.push_back(sample.curvature / scale);
            set.weight.push_back(sample.weight);
            set.group.push_back(static_cast<std::int64_t>(g));
        }
    }
    return set;
}

void fit(const std::vector<CurvatureGroup>& groups, const Calibration& calibration,
         CurvatureMap& map) {
    const auto terms = static_cast<std::size_t>(
        std::count(calibration.has_term.begin(), calibration.has_term.end(), true));
    const std::vector<double> found = fit_curvature_with_torch(fit_set(groups, calibration), terms);
    std::size_t next = 0;
    for (std::size_t term = 0; term < calibration.has_term.size(); ++term)
        if (calibration.has_term[term])
            map.coefficients[term] = rounded(found[next++]);
    map.min = map.max = 0;
    for (const CurvatureGroup& group : groups) {
        const double turning =
            rounded(mean(group, [](const CurvatureSample& sample) { return sample.turning; }));
        map.min = std::min(map.min, turning);
        map.max = std::max(map.max, turning);
    }
}

/// Estimate minus truth.
double error_of(const CurvatureMap& map, const CurvatureSample& sample) {
    const auto values = features(sample);
    double estimate = 0;
    for (std::size_t term = 0; term < values.size(); ++term)
        estimate += map.coefficients[term] * values[term];
    return estimate - sample.curvature;
}

std::string shape_text(const CurvatureGroup& group) {
    return (group.side == Side::outside ? "outside of " : "") + group.shape;
}

/// One row for the groups that differ in spacing and sampling alone.
std::vector<CurvatureResidual> residuals(const std::vector<CurvatureGroup>& groups,
                                         const CurvatureMap& map) {
    std::vector<CurvatureResidual> rows;
    std::vector<double> members;
    for (const CurvatureGroup& group : groups) {
        auto row = std::find_if(rows.begin(), rows.end(), [&](const CurvatureResidual& other) {
            return std::tie(other.shape, other.arrangement, other.size) ==
                   std::make_tuple(shape_text(group), group.arrangement, group.size);
        });
        if (row == rows.end()) {
            row = rows.insert(rows.end(), CurvatureResidual{});
            row->shape = shape_text(group);
            row->arrangement = group.arrangement;
            row->size = group.size;
            members.push_back(0);
        }
        const double bias =
            mean(group, [&](const CurvatureSample& sample) { return error_of(map, sample); });
        row->particles += group.samples.size();
        row->curvature += mean_curvature(group);
        row->bias += bias;
        row->max_bias = std::max(row->max_bias, std::fabs(bias));
        row->deviation += mean(group, [&](const CurvatureSample& sample) {
            return (error_of(map, sample) - bias) * (error_of(map, sample) - bias);
        });
        ++members[static_cast<std::size_t>(row - rows.begin())];
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].curvature = rounded(rows[i].curvature / members[i]);
        rows[i].bias = rounded(rows[i].bias / members[i]);
        rows[i].max_bias = rounded(rows[i].max_bias);
        rows[i].deviation = rounded(std::sqrt(rows[i].deviation / members[i]));
    }
    return rows;
}

} // namespace

CurvatureModel fit_curvature_model(const std::vector<CurvatureGroup>& groups,
                                   const Calibration& calibration) {
    if (groups.empty())
        throw InputError("no cloud has a surface particle that is far enough from where it is cut "
                         "off; take larger shapes (smaller sizes h / R)");
    CurvatureModel model;
    model.map.dimension = calibration.dimension;
    model.map.averaged = calibration.averaged;
    model.clouds = calibration.is_dense ? "dense" : "filled";
    model.radius_ratio = calibration.radius_ratio;
    model.fade = calibration.fade;
    model.tau = calibration.tau;
    model.normal_passes = calibration.normal_passes;
    model.bias_penalty = calibration.bias_penalty;
    model.min_curvature = calibration.min_curvature;
    model.seed = calibration.seed;
    fit(groups, calibration, model.map);
    const double first_ratio = rounded(groups[0].spacing_ratio);
    model.spacing_ratio = {first_ratio, first_ratio};
    for (const CurvatureGroup& group : groups) {
        model.cloud_count += static_cast<std::size_t>(group.clouds);
        model.particles += group.samples.size();
        model.spacing_ratio.min = std::min(model.spacing_ratio.min, rounded(group.spacing_ratio));
        model.spacing_ratio.max = std::max(model.spacing_ratio.max, rounded(group.spacing_ratio));
    }
    model.residuals = residuals(groups, model.map);
    return model;
}

CurvatureModel calibrate(const Calibration& calibration,
                         const std::function<void(std::size_t, std::size_t)>& progress) {
    check_has_torch_trainer("calibrate");
    return fit_curvature_model(curvature_groups(calibration, progress), calibration);
}

} // namespace meniscus
