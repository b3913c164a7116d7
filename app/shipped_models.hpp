// The lines that ship with the project, and which of them fits a state: the choice of the runtime
// (runtime/surface/shipped_classifier.hpp), for files.
#pragma once

#include "command_line.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <string>
#include <vector>

namespace meniscus {

/// A model with its name, which is that of its file without the ending, and its file's SHA-256.
struct NamedModel {
    std::string name;
    Model model;
    std::string hash;
};

/// All lines that ship, by name. Throws InputError where they are missing.
std::vector<NamedModel> all_shipped_models();

/// Those that one is chosen from by dimension and ratio. Read once; throws likewise.
class ModelChoice {
public:
    ModelChoice();

    /// The one for 2 or 3 dimensions and a support radius of so many spacings of particles at rest.
    /// Throws InputError beyond what they were trained for.
    [[nodiscard]] const NamedModel& at(int dimension, double spacing_ratio) const;

    /// One digest of all of them.
    [[nodiscard]] std::string hash() const;

private:
    std::vector<NamedModel> models;
};

/// The one for a labelled state. Throws InputError beyond what they were trained for, and where the
/// state's particles have support radii of their own.
NamedModel model_that_fits(const LabelledState& state);

/// The one that --model names: a file or, where there is none of that name, one that ships. Throws
/// InputError as read_model does, with the nearest name.
NamedModel named_model(const Path& file_or_name);

/// "h of 2 to 2.16 spacings in 3D", or without the range where the model knows none.
std::string range_text(const Model& model);

} // namespace meniscus
