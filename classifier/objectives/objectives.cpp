#include "objectives.hpp"

#include "neyman_pearson.hpp"
#include "shift.hpp"

#include <meniscus/classifier/torch/torch_plugin.hpp>
#include <meniscus/data/text/errors.hpp>

namespace meniscus {
namespace {

Line fit_exactly(const std::vector<LabelledState>& states, double label_threshold,
                 std::uint64_t /*seed*/) {
    return min_false_positives(states, label_threshold);
}

Line fit_logistic(const std::vector<LabelledState>& states, double label_threshold,
                  std::uint64_t seed) {
    return shift_line(states, label_threshold,
                      fit_with_torch("logistic", states, label_threshold, seed).k);
}

Line fit_network(const std::vector<LabelledState>& states, double label_threshold,
                 std::uint64_t seed) {
    return shift_line(states, label_threshold,
                      fit_with_torch("network", states, label_threshold, seed).k);
}

} // namespace

const std::vector<Objective>& objectives() {
    static const std::vector<Objective> all = {
        {"neyman-pearson", "fewest false positives without a false negative, exact", true,
         fit_exactly, best_line},
        {"logistic", "the paper's linear separator, shifted", false, fit_logistic, nullptr},
        {"network", "the line along a small network's boundary, shifted", false, fit_network,
         nullptr},
    };
    return all;
}

const Objective& objective_named(const std::string& name) {
    std::string names;
    for (const Objective& objective : objectives()) {
        if (objective.name == name)
            return objective;
        names += (names.empty() ? "" : ", ") + std::string(objective.name);
    }
    throw InputError("'" + name + "' is no objective; expected one of " + names);
}

} // namespace meniscus
