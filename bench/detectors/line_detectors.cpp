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
    {"line, neyman-pearson", "surface_3d", "line", ours},
    {"line, neyman-pearson, strict", "surface_3d_strict", "line", ours},
    {"line, neyman-pearson, relative", "surface_3d_relative", "line", ours},
    {"line, logistic", "surface_3d_logistic", "line", ours},
    {"line, network", "surface_3d_network", "line", ours},
    {"line, logistic, not shifted", "plain_logistic_3d", "line", ours},
    {"published line, d = 12", "splishsplash_d12", "published line", published},
    {"published line, d = 13", "splishsplash_d13", "published line", published},
    {"published line, d = 28", "splishsplash_d28", "published line", published},
    {"published line, d = 35", "splishsplash_d35", "published line", published},
};
constexpr NamedModel models_2d[] = {{"line, neyman-pearson", "surface_2d", "line", ours}};

/// The line for a state: a relative one follows its median, as a host has it from its last step.
template <class Real, int Dimension>
SurfaceLine<Real> line_for(const Model& model, const FluidState<Real>& state) {
    if (model.reference_neighbor_count == 0)
        return {static_cast<Real>(model.line.k), static_cast<Real>(model.line.d)};
    const auto view = state.template view<Dimension>();
    const auto range = neighbor_range<Real>(state.support_radius, model.radius_ratio);
    std::vector<int> counts(state.size());
    for (std::size_t i = 0; i < state.size(); ++i)
        counts[i] = sum_features<Real, Dimension>(view, i, range).count;
    return scaled_line<Real>(model.line.k, model.line.d,
                             median_neighbor_count(counts.data(), counts.size()),
                             model.reference_neighbor_count);
}

template <class Real, int Dimension>
Detection line_detection(const Model& model, const FluidState<Real>& state, int threads) {
    const auto line = line_for<Real, Dimension>(model, state);
    const auto range = neighbor_range<Real>(state.support_radius, model.radius_ratio);
    return [&state, line, range, threads](std::vector<std::uint8_t>& surface) {
        surface.resize(state.size());
        over_particles(state.size(), threads, [&](std::size_t begin, std::size_t end, int) {
            classify<Real, Dimension>(state.template view<Dimension>(), begin, end,
                                      state.support_radius, line, range, surface.data());
        });
    };
}

/// What the second stage of the runtime works with.
template <class Real, int Dimension>
struct Verified {
    SurfaceParticles<Real, Dimension> list;
    SampleDirections directions;
    HeldCells cells;
    std::vector<ExposureMemory> memory;
};

template <class Real, int Dimension>
Detection verified_detection(const FluidState<Real>& state, int threads,
                             const SurfaceTensionOptions& options, std::size_t samples) {
    auto shared = std::make_shared<Verified<Real, Dimension>>();
    fill_outward_directions<Dimension>(samples, 0, shared->directions);
    shared->memory.resize(static_cast<std::size_t>(threads));
    const auto shipped = shipped_surface_line(Dimension);
    const SurfaceLine<Real> line{static_cast<Real>(shipped.k), static_cast<Real>(shipped.d)};
    return [&state, shared, line, options, threads](std::vector<std::uint8_t>& surface) {
        const auto view = state.template view<Dimension>();
        const UniformRadius<Real> radii{state.support_radius};
        auto& list = shared->list;
        with_loop(threads, [&](const auto& loop) {
            find_candidates<Real, Dimension>(view, state.size(), radii, line, options.radius_ratio,
                                             loop, list);
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
        check_features_of_paper(model, "a detector");
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
