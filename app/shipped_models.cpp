#include "shipped_models.hpp"

#include "shipped_files.hpp"

#include <meniscus/classifier/curvature/curvature_model.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/spelling.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/surface/shipped_classifier.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {
namespace {

/// As the runtime's headers are named, for growing ratios.
constexpr const char* ranges_of_ratio[] = {"", "_wide", "_widest"};

NamedModel read_named(const Path& file) {
    return {file.stem().string(), read_model(file), file_hash(file)};
}

std::vector<Path> model_files() {
    std::vector<Path> files;
    for (const auto& entry : std::filesystem::directory_iterator(shipped_models()))
        if (entry.path().extension() == ".json" && !is_curvature_model(entry.path()))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

std::vector<NamedModel> all_shipped_models() {
    std::vector<NamedModel> models;
    for (const Path& file : model_files())
        models.push_back(read_named(file));
    return models;
}

ModelChoice::ModelChoice() {
    const Path folder = shipped_models();
    for (const int dimension : {2, 3})
        for (const char* range : ranges_of_ratio)
            models.push_back(
                read_named(folder / fmt::format("surface_{}d{}.json", dimension, range)));
}

const NamedModel& ModelChoice::at(int dimension, double spacing_ratio) const {
    constexpr double tolerance = shipped_classifier::tolerance;
    const std::size_t first = dimension == 2 ? 0 : std::size(ranges_of_ratio);
    const std::size_t last = first + std::size(ranges_of_ratio) - 1;
    if (spacing_ratio > models[last].model.spacing_ratio->max * (1 + tolerance))
        throw InputError(fmt::format(
            "h is {:.3g} spacings of particles at rest, and the models that ship reach to {:.3g}; "
            "train one on such states, and give it by --model",
            spacing_ratio, models[last].model.spacing_ratio->max));
    std::size_t chosen = first;
    while (chosen < last &&
           spacing_ratio >= models[chosen + 1].model.spacing_ratio->min * (1 - tolerance))
        ++chosen;
    return models[chosen];
}

std::string ModelChoice::hash() const {
    std::string all;
    for (const NamedModel& one : models)
        all += one.hash;
    return all;
}

NamedModel model_that_fits(const LabelledState& state) {
    if (!state.spacing_ratio)
        throw InputError(fmt::format("{}: particles have support radii of their own; say by "
                                     "--model which one is meant",
                                     state.file));
    return ModelChoice().at(state.dimension, *state.spacing_ratio);
}

NamedModel named_model(const Path& file_or_name) {
    if (std::filesystem::exists(file_or_name))
        return read_named(file_or_name);
    std::vector<std::string> names;
    if (file_or_name == file_or_name.filename())
        for (const Path& file : model_files()) {
            names.push_back(file.stem().string());
            if (names.back() == file_or_name.stem().string())
                return read_named(file);
        }
    const std::string nearest = likely_spelling(file_or_name.stem().string(), names);
    if (nearest.empty())
        return read_named(file_or_name); // which says what is wrong
    throw InputError(fmt::format("{}: there is no such file, and no model of that name ships; did "
                                 "you mean '{}'?",
                                 file_or_name.string(), nearest));
}

std::string range_text(const Model& model) {
    return model.spacing_ratio
               ? fmt::format("h of {} to {} spacings in {}D",
                             rounded_text(model.spacing_ratio->min, 3),
                             rounded_text(model.spacing_ratio->max, 3), model.dimension)
               : fmt::format("{}D", model.dimension);
}

} // namespace meniscus
