// The tables of docs/normals.md, printed in Markdown.
#pragma once

#include <filesystem>

namespace meniscus {

/// The 2019 preprint's Table 1, with its figures beside ours.
void print_circle_tables();

/// Errors on the saddle by scheme, number of samples and smoothing.
void print_scheme_tables();

/// Errors on the saddle by the share of the neighbors in smoothing, and by that of normals from
/// positions.
void print_smoothing_tables();

/// Time of the schemes; writes it with the errors to a JSON file for scripts/plot_normals.py.
void print_time_table(const std::filesystem::path& json);

/// What the ratio of radii r2 / r1 does, on the saddle, a ball and the state of a droplet.
void print_ratio_table(const std::filesystem::path& droplet);

} // namespace meniscus
