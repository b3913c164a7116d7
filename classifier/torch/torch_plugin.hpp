// Loads the libtorch module when a fit asks for it and never before. It is looked for in the
// library folder that belongs to the running program, in the build tree as when installed, then
// wherever the system's loader looks.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace meniscus {

/// True where the program was built with the libtorch trainer (MENISCUS_TRAINER).
bool has_torch_trainer();

/// The line that "logistic" or "network" fits to the states, not yet shifted; scenes weigh the
/// same. The same input and seed give the same bits. Throws FailureError where the program was
/// built without the trainer, where its module cannot be loaded, or where the fit finds no line.
Line fit_with_torch(const std::string& objective, const std::vector<LabelledState>& states,
                    double label_threshold, std::uint64_t seed);

/// Throws FailureError, naming what needs it, where the program was built without the trainer.
void check_has_torch_trainer(const std::string& what);

/// What a curvature map is fitted to; one entry a sample, `features` one a sample and term.
struct CurvatureFitSet {
    std::vector<double> features;
    std::vector<double> truth;
    std::vector<double> weight;
    std::vector<std::int64_t> group; ///< ascending from 0, none left out
    double bias_penalty = 0;
};

/// The coefficients of least squares, one a term. Throws as fit_with_torch does.
std::vector<double> fit_curvature_with_torch(const CurvatureFitSet& set, std::size_t terms);

} // namespace meniscus
