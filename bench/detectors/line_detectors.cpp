// The line of this project: as its objectives fit it, as published, and followed by the test that
// drops its false positives.
#include "detector.hpp"
#include "support/loops.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

namespace meniscus {
namespace {

struct NamedModel {
    const char* name;
    const char* file;
    const char* group;
    const char* source;
};

constexpr const char* ours = "this project";
constexpr const char* published = "Zorilla et al. 2020, SPlisHSPlasH 2.16";

constexpr NamedModel models_3d[] = {
    {"two lines", "surface_3d", "line", ours},
    {"two lines, strict", "surface_3d_strict", "line", ours},
    {"line, logistic", "surface_3d_logistic", "line", ours},
    {"line, network", "surface_3d_network", "line", ours},
    {"line, logistic, not shifted", "plain_logistic_3d", "line", ours},
    {"published line, d = 12", "splishsplash_d12", "published line", published},
    {"published line, d = 13", "splishsplash_d13", "published line", published},
    {"published line, d = 28", "splishsplash_d28", "published line", published},
    {"published line, d = 35", "splishsplash_d35", "published line", published},
};
constexpr NamedModel models_2d[] = {{"two lines", "surface_2d", "line", ours}};

/// What the stages of the runtime work with.
template <class Real, int Dimension>
struct Stages {
    SurfaceParticles<Real, Dimension> list;
    SampleDirections directions;
    HeldCells cells;
    std::vector<ExposureMemory> memory;
};

template <class Real, int Dimension>
Detection line_detection(const Model& model, const FluidState<Real>& state, int threads) {
    auto shared = std::make_shared<Stages<Real, Dimension>>();
    shared->memory.resize(static_cast<std::size_t>(threads));
    SurfaceTensionOptions options;
    options.spacing_ratio = static_cast<double>(state.support_radius) / state.spacing;
    set_classifier(options, model);
    return [&state, shared, options, threads](std::vector<std::uint8_t>& surface) {
        auto& list = shared->list;
        with_loop(threads, [&](const auto& loop) {
            find_candidates<Real, Dimension>(state.template view<Dimension>(), NoBoundary{},
                                             state.size(),
                                             UniformRadius<Real>{state.support_radius}, options,
                                             loop, shared->memory.data(), list);
        });
        surface.assign(state.size(), 0);
        for (const std::uint32_t i : list.particle)
            surface[i] = 1;
    };
}

template <class Real, int Dimension>
Detection verified_detection(const FluidState<Real>& state, int threads,
                             SurfaceTensionOptions options, std::size_t samples) {
    auto shared = std::make_shared<Stages<Real, Dimension>>();
    fill_outward_directions<Dimension>(samples, 0, shared->directions);
    shared->memory.resize(static_cast<std::size_t>(threads));
    options.spacing_ratio = static_cast<double>(state.support_radius) / state.spacing;
    set_shipped_classifier(options, Dimension);
    return [&state, shared, options, threads](std::vector<std::uint8_t>& surface) {
        const auto view = state.template view<Dimension>();
        const UniformRadius<Real> radii{state.support_radius};
        auto& list = shared->list;
        with_loop(threads, [&](const auto& loop) {
            find_candidates<Real, Dimension>(view, NoBoundary{}, state.size(), radii, options, loop,
                                             shared->memory.data(), list);
            find_exposure<Real, Dimension>(view, NoBoundary{}, radii, nullptr, shared->directions,
                                           shared->cells, options, loop, shared->memory.data(),
                                           list);
        });
        surface.assign(state.size(), 0);
        for (std::size_t slot = 0; slot < list.size(); ++slot)
            if (list.surface_class[slot] == SurfaceClass::surface)
                surface[list.particle[slot]] = 1;
    };
}

template <class Real, int Dimension>
void add_lines(const std::vector<NamedModel>& named, const std::filesystem::path& folder,
               std::vector<Detector<Real>>& all) {
    for (const NamedModel& one : named) {
        const Model model = read_model(folder / (std::string(one.file) + ".json"));
        all.push_back(
            {one.name, one.group, one.source, [model](const FluidState<Real>& state, int threads) {
                 return line_detection<Real, Dimension>(model, state, threads);
             }});
    }
}

template <class Real, int Dimension>
void add_verified(std::vector<Detector<Real>>& all) {
    const auto add = [&](const std::string& name, const SurfaceTensionOptions& options,
                         std::size_t samples) {
        all.push_back({name, "line and test", ours,
                       [options, samples](const FluidState<Real>& state, int threads) {
                           return verified_detection<Real, Dimension>(state, threads, options,
                                                                      samples);
                       }});
    };
    SurfaceTensionOptions drop;
    drop.verification = Verification::drop;
    SurfaceTensionOptions exact;
    exact.coverage = CoverageMethod::exact;
    for (const std::size_t samples : {16, 128, 1024})
        add("line and " + std::to_string(samples) + " samples", drop, samples);
    for (const std::size_t samples : {16, 128})
        add("line and " + std::to_string(samples) + " samples, verified", {}, samples);
    add("line and exact coverage", exact, min_samples);
}

} // namespace

template <class Real>
void add_line_detectors(int dimension, const std::filesystem::path& models,
                        std::vector<Detector<Real>>& all) {
    if (dimension == 2) {
        add_lines<Real, 2>({std::begin(models_2d), std::end(models_2d)}, models, all);
        add_verified<Real, 2>(all);
    } else {
        add_lines<Real, 3>({std::begin(models_3d), std::end(models_3d)}, models, all);
        add_verified<Real, 3>(all);
    }
}

template void add_line_detectors(int, const std::filesystem::path&, std::vector<Detector<float>>&);
template void add_line_detectors(int, const std::filesystem::path&, std::vector<Detector<double>>&);

} // namespace meniscus
