// The studies: a new one is a folder with its source, declared here, and its place in the list.
#pragma once

#include "framework/study.hpp"

namespace meniscus {

Study pressure_jump_study();
Study parasitic_currents_study();
Study oscillation_study();
Study thin_shells_study();
Study drop_formation_study();
Study step_times_study();
Study step_lengths_study();
Study liquid_crown_study();
Study drop_collision_study();
Study jet_growth_study();
Study water_glass_study();

inline std::vector<Study> all_studies() {
    return {pressure_jump_study(), parasitic_currents_study(), oscillation_study(),
            thin_shells_study(),   drop_formation_study(),     step_times_study(),
            step_lengths_study(),  liquid_crown_study(),       drop_collision_study(),
            jet_growth_study(),    water_glass_study()};
}

} // namespace meniscus
