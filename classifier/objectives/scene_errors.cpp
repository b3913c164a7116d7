#include "scene_errors.hpp"

namespace meniscus {

namespace {

std::vector<SceneErrors> empty_scenes(const SceneGroups& groups) {
    std::vector<SceneErrors> scenes(groups.names.size());
    for (std::size_t s = 0; s < scenes.size(); ++s)
        scenes[s].scene = groups.names[s];
    return scenes;
}

void add_state(const LabelledState& state, const Line& line, double label_threshold,
               SceneErrors& scene) {
    for (std::size_t i = 0; i < state.size(); ++i)
        scene.add(state.uncovered_fraction[i], label_threshold,
                  state.is_candidate(i) &&
                      (state.is_alone(i) || predicts_surface(line, state.x(i), state.y(i))));
}

} // namespace

std::vector<SceneErrors> count_errors(const std::vector<LabelledState>& states, const Line& line,
                                      double label_threshold) {
    const SceneGroups groups = group_by_scene(states);
    auto scenes = empty_scenes(groups);
    for (std::size_t s = 0; s < states.size(); ++s)
        add_state(states[s], line, label_threshold, scenes[groups.of_state[s]]);
    return scenes;
}

std::vector<SceneErrors> count_errors(const Campaign& campaign, const Line& line,
                                      double label_threshold) {
    const SceneGroups groups = group_by_scene(campaign.states());
    auto scenes = empty_scenes(groups);
    campaign.visit([&](std::size_t place, const LabelledState& state) {
        add_state(state, line, label_threshold, scenes[groups.of_state[place]]);
    });
    std::vector<std::uint64_t> counts;
    const auto with_counts = [&](auto use) {
        for (SceneErrors& scene : scenes)
            for (std::size_t* count :
                 {&scene.particles, &scene.surface_particles, &scene.false_negatives,
                  &scene.false_positives, &scene.uncovered_false_positives})
                use(*count);
    };
    with_counts([&](std::size_t& count) { counts.push_back(count); });
    campaign.ranks->sum(counts);
    auto next = counts.begin();
    with_counts([&](std::size_t& count) { count = *next++; });
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
