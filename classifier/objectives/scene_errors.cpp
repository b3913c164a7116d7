#include "scene_errors.hpp"

namespace meniscus {

std::vector<SceneErrors> count_errors(const std::vector<LabelledState>& states, const Line& line,
                                      double label_threshold) {
    const SceneGroups groups = group_by_scene(states);
    std::vector<SceneErrors> scenes(groups.names.size());
    for (std::size_t s = 0; s < states.size(); ++s) {
        const LabelledState& state = states[s];
        SceneErrors& scene = scenes[groups.of_state[s]];
        scene.scene = state.scene;
        for (std::size_t i = 0; i < state.size(); ++i)
            scene.add(state.uncovered_fraction[i], label_threshold,
                      state.is_candidate(i) &&
                          (state.is_alone(i) || predicts_surface(line, state.x(i), state.y(i))));
    }
    return scenes;
}

double mean_false_positive_rate(const std::vector<SceneErrors>& scenes) {
    double sum = 0;
    std::size_t counted = 0;
    for (const SceneErrors& scene : scenes) {
        sum += false_positive_rate(scene);
        counted += scene.particles == 0 ? 0 : 1;
    }
    return counted == 0 ? 0 : sum / static_cast<double>(counted);
}

} // namespace meniscus
