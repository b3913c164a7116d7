// The surface detectors that are compared: each takes a state and says which particles are surface.
// A new one is one file and one line in the list in detectors.cpp.
#pragma once

#include "support/fluid_state.hpp"

#include <filesystem>
#include <functional>

namespace meniscus {

/// Sets the entry of each particle to 1 for surface and to 0 for interior. Called over and over,
/// and timed; keeps its memory between calls.
using Detection = std::function<void(std::vector<std::uint8_t>& surface)>;

template <class Real>
struct Detector {
    std::string name;
    std::string group;  ///< what it is a variant of, as the plots color it
    std::string source; ///< paper or program that it comes from
    /// Makes ready all that a host has before its step: tables, but nothing that depends on the
    /// positions. The state must outlive what is returned. `threads` is 1 or more.
    std::function<Detection(const FluidState<Real>& state, int threads)> prepare;
    bool is_parallel = true; ///< false where more threads than one change nothing
    bool is_slow = false;    ///< takes more than some microseconds a particle: measured fewer times
};

/// All detectors for a dimension of 2 or 3, in the order of the tables. `models` is the folder of
/// the model files that ship; throws as read_model does where one is missing.
template <class Real>
std::vector<Detector<Real>> detectors(int dimension, const std::filesystem::path& models);

// The detectors themselves, a file each.
template <class Real>
void add_line_detectors(int dimension, const std::filesystem::path& models,
                        std::vector<Detector<Real>>& all);
template <class Real>
void add_coverage_detectors(int dimension, std::vector<Detector<Real>>& all);
template <class Real>
void add_eigenvalue_detectors(int dimension, std::vector<Detector<Real>>& all);
template <class Real>
void add_divergence_detectors(int dimension, std::vector<Detector<Real>>& all);
template <class Real>
void add_visibility_detectors(int dimension, std::vector<Detector<Real>>& all);

} // namespace meniscus
