#include "scene_model.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/text/errors.hpp>

namespace meniscus {

void use_model_file(Scene& scene) {
    TensionOptions& options = scene.surface_tension;
    if (options.model_file.empty())
        return;
    const Model model = read_model(options.model_file);
    const std::string name = "scene '" + scene.name + "'";
    check_dimension(model, scene.dimension, name);
    const std::string outside = outside_trained_range(model, {{name, spacing_ratio(scene), {}}});
    if (!outside.empty())
        throw InputError(outside + "; train one on such states");
    options.surface.spacing_ratio = spacing_ratio(scene);
    set_classifier(options.surface, model);
}

} // namespace meniscus
