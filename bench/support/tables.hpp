// The tables that can be printed, a row each at the end of the file that makes them. A new table is
// a function and such a row; a new file of them is named in main.cpp.
#pragma once

#include "fluid_state.hpp"
#include "timing.hpp"

namespace meniscus {

/// What tables are made from.
struct TableInput {
    std::vector<std::filesystem::path> files;   ///< of the command line
    std::vector<std::filesystem::path> samples; ///< snapshots that come with the project
    std::filesystem::path models;               ///< folder of the model files
    std::filesystem::path scenes;               ///< folder of the scenes
    int threads = 1;
    TimingOptions timing = {};

    std::vector<FluidState<float>> states = {}; ///< of the files, for kinds that take states
};

using Tables = std::vector<Table>;

/// A row: what is printed under a name.
struct TableKind {
    const char* name;      ///< on the command line, and between which comments of docs/ it stands
    const char* files;     ///< what it is made from, as "SNAPSHOT..."; "" for no files
    std::size_t min_files; ///< that it must be given
    const char* help;      ///< half a sentence
    Tables (*make)(const TableInput& input);
    bool takes_states = false;
};

/// The kinds of one file, or of one concept, below a heading of the help.
struct TableGroup {
    const char* heading;
    std::vector<TableKind> kinds;
};

/// Those of `meniscus bench`: made from any snapshots that store their support radius, from the
/// samples where there are none.
const std::vector<TableKind>& compared_tables();

/// The program that prints tables. Its arguments are a table's name, files and options; returns its
/// exit status, as the `meniscus` command has them, and says on the standard error what is wrong.
int print_tables(int argument_count, char** arguments, const std::vector<TableGroup>& groups);

// What each file adds.
TableGroup accuracy_tables();
TableGroup training_time_tables();
TableGroup detector_threshold_tables();
TableGroup sampling_tables();
TableGroup label_speed_tables();
TableGroup label_scaling_tables();
TableGroup classification_tables();
TableGroup normal_circle_tables();
TableGroup normal_saddle_tables();
TableGroup normal_ratio_tables();
TableGroup curvature_cloud_tables();
TableGroup curvature_map_tables();
TableGroup force_tables();
TableGroup surface_speed_tables();
TableGroup scene_tables();
TableGroup solver_tables();
TableGroup contact_angle_tables();
TableGroup step_speed_tables();
TableGroup droplet_tables();

} // namespace meniscus
