// The keys of the project's own model of surface tension, and Akinci's adhesion.
#include "detail/read_values.hpp"
#include "detail/scene_names.hpp"
#include "methods.hpp"

#include <meniscus/runtime/surface/option_table.hpp>

namespace meniscus {
namespace {

template <class Value>
Value read_surface_option(const JsonReader& reader, const SurfaceOption<Value>& option) {
    if constexpr (std::is_enum_v<Value>)
        return static_cast<Value>(
            reader.choice(option.name, {option.range.words[0], option.range.words[1]}));
    const Json& value = reader.value(option.name);
    if (!value.is_number() || !is_in_range(option.range, value.get<double>()))
        reader.refuse(option.name, option.range.text);
    if (std::is_integral_v<Value> && value.is_number_float() && value != value.get<std::int64_t>())
        reader.refuse(option.name, option.range.text);
    return value.get<Value>();
}

/// Samples by the time step in place of a fixed number.
void read_sampling_density(const JsonReader& reader, TensionOptions& options) {
    take(reader, "sampling_density", 0, 1e9, options.sampling_density);
    const OptionRange& range = option_ranges::samples;
    take(reader, "min_samples", static_cast<int>(range.min), static_cast<int>(range.max),
         options.min_samples);
    if (options.sampling_density > 0)
        refuse_with(reader, "samples", "sampling_density says how many there are");
    else
        refuse_with(reader, "min_samples", "it goes with a sampling_density above 0");
}

} // namespace

std::vector<std::string> meniscus_option_keys() {
    std::vector<std::string> keys = {
        "balance_momentum", "contact_friction", "ripple_damping", "paper",
        "model_file",       "sampling_density", "min_samples"};
    for_each_surface_option([&](const auto& option) {
        if (!comes_with_scene(option.name))
            keys.emplace_back(option.name);
    });
    return keys;
}

void read_meniscus_options(const JsonReader& reader, TensionOptions& options) {
    take(reader, "balance_momentum", options.balance_momentum);
    take(reader, "contact_friction", 0, 2, options.contact_friction);
    take(reader, "ripple_damping", 0, 0.5, options.ripple_damping);
    read_sampling_density(reader, options);
    if (reader.has("paper") && reader.truth("paper"))
        options.surface = paper_options();
    for_each_surface_option([&](const auto& option) {
        if (!comes_with_scene(option.name) && reader.has(option.name))
            options.surface.*option.member = read_surface_option(reader, option);
    });
    if (reader.has("model_file")) {
        options.model_file = reader.text("model_file");
        for (const char* key : {"k", "d", "boundary_weight", "radius_ratio"})
            if (reader.has(key))
                reader.refuse(key, "absent: model_file says it");
    }
    if (reader.has("k") != reader.has("d"))
        reader.refuse(reader.has("k") ? "d" : "k", "there too: a line has both k and d");
    for_each_surface_option([&](const auto& option) {
        if (option.only_sampled && options.surface.coverage == CoverageMethod::exact)
            refuse_with(reader, option.name, "it has no meaning for coverage exact");
    });
    if (options.surface.coverage == CoverageMethod::exact)
        refuse_with(reader, "sampling_density", "it has no meaning for coverage exact");
}

void read_adhesion(const JsonReader& reader, TensionOptions& options) {
    take(reader, "adhesion", 0, 1e9, options.adhesion);
}

} // namespace meniscus
