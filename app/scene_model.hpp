// The classifier that a scene names by a model file.
#pragma once

#include <meniscus/sph/scene/scene.hpp>

namespace meniscus {

/// Sets the scene's classifier from its `surface_tension.model_file`, where it names one. Throws
/// InputError, naming scene and model, where the file cannot be read, where the model is of another
/// dimension, or where the scene's support radius lies outside what it was trained on.
void use_model_file(Scene& scene);

} // namespace meniscus
