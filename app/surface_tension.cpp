#include "surface_tension.hpp"

#include <meniscus/c_interface/surface_step.hpp>
#include <meniscus/data/errors.hpp>
#include <meniscus/data/particle_arrays.hpp>
#include <meniscus/runtime/sample_directions.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace meniscus {
namespace {

/// Samples that a time step is not to fall below, where the user does not say.
constexpr std::size_t fewest_for_time_step = 16;

constexpr double no_limit = std::numeric_limits<double>::max();

/// Refuses what is no number in the range; unlike CLI::Range also what is not a number at all.
CLI::Validator number_between(double least, double most, const std::string& range) {
    return {[=](const std::string& text) -> std::string {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most)
                    return {};
                return fmt::format("must be {}, found {}", range, text);
            },
            ""};
}

CLI::Validator share() {
    return number_between(0, 1, "between 0 and 1");
}

CLI::Validator positive_number() {
    return number_between(std::numeric_limits<double>::denorm_min(), no_limit,
                          "positive and finite");
}

CLI::Validator passes() {
    return CLI::Range(0, 1000);
}

std::size_t sample_count(const SurfaceChoices& choices, std::size_t usual) {
    if (choices.time_step)
        return samples_for_time_step(*choices.time_step, *choices.sampling_density,
                                     choices.samples.value_or(fewest_for_time_step));
    return choices.samples.value_or(usual);
}

meniscus_options step_options(const SurfaceChoices& choices, double radius_ratio,
                              double spacing_ratio, int threads) {
    meniscus_options options = choices.paper ? options_of_paper() : default_options();
    options.radius_ratio = radius_ratio;
    options.spacing_ratio = spacing_ratio;
    options.threads = threads;
    options.samples = sample_count(choices, options.samples);
    if (choices.exact)
        options.coverage = MENISCUS_EXACT;
    if (choices.drop_covered)
        options.verification = MENISCUS_DROP;
    options.fade = choices.no_fade ? 0 : choices.fade.value_or(options.fade);
    options.normal_passes = choices.normal_passes.value_or(options.normal_passes);
    options.tau = choices.tau.value_or(options.tau);
    options.covariance_share = choices.pca_share.value_or(options.covariance_share);
    if (!choices.curvature.empty())
        options.curvature =
            choices.curvature == "closed" ? MENISCUS_CLOSED_CURVATURE : MENISCUS_MAPPED_CURVATURE;
    options.curvature_passes = choices.curvature_passes.value_or(options.curvature_passes);
    if (!choices.force.empty())
        options.force = choices.force == "paper" ? MENISCUS_PAPER_FORCE : MENISCUS_CALIBRATED_FORCE;
    options.surface_tension = choices.surface_tension.value_or(options.surface_tension);
    return options;
}

void set_provenance(Snapshot& snapshot, const meniscus_options& options, bool balanced) {
    auto& provenance = snapshot.provenance;
    const std::string prefix = "runtime_";
    for (auto entry = provenance.begin(); entry != provenance.end();)
        entry = entry->first.rfind(prefix, 0) == 0 ? provenance.erase(entry) : std::next(entry);
    const auto set = [&](const char* name, const auto& value) {
        provenance[prefix + name] = fmt::format("{}", value);
    };
    const bool sampled = options.coverage == MENISCUS_SAMPLED;
    set("coverage", sampled ? "sampled" : "exact");
    if (sampled) {
        set("samples", options.samples);
        set("seed", options.seed);
        set("candidates_without_open_sample",
            options.verification == MENISCUS_DROP ? "covered" : "decided exactly");
    }
    set("fade", options.fade);
    set("normal_passes", options.normal_passes);
    set("tau", options.tau);
    set("pca_share", options.covariance_share);
    set("curvature", options.curvature == MENISCUS_CLOSED_CURVATURE ? "closed" : "mapped");
    set("curvature_passes", options.curvature_passes);
    set("force", options.force == MENISCUS_PAPER_FORCE ? "paper" : "calibrated");
    set("surface_tension", options.surface_tension);
    set("spacing_ratio", options.spacing_ratio);
    set("momentum", balanced ? "balanced" : "as it is");
}

/// The ids that key the samples; none where the snapshot has none.
std::vector<std::uint32_t> sampling_ids(const Snapshot& snapshot,
                                        const std::vector<std::uint8_t>& valid) {
    const auto ids = integer_values(snapshot, "id", valid);
    std::vector<std::uint32_t> short_ids(ids.size());
    std::transform(ids.begin(), ids.end(), short_ids.begin(),
                   [](std::int64_t id) { return static_cast<std::uint32_t>(id); });
    return short_ids;
}

/// The particles as the runtime takes them; pointers into the arguments.
meniscus_particles step_particles(const Snapshot& snapshot, const Classes& classes,
                                  const NeighborLists& boundary,
                                  const std::vector<std::uint32_t>& ids) {
    static_assert(sizeof(std::size_t) == sizeof(std::uint64_t));
    const Neighborhoods& neighborhoods = classes.neighborhoods;
    meniscus_particles particles{};
    particles.size = sizeof particles;
    particles.count = snapshot.size();
    particles.positions = snapshot.positions.data();
    particles.stride = 3;
    particles.support_radius = neighborhoods.radii.largest;
    if (neighborhoods.radii.vary())
        particles.support_radii = neighborhoods.radii.each.data();
    particles.ids = ids.empty() ? nullptr : ids.data();
    particles.offsets = neighborhoods.lists.offsets.data();
    particles.neighbors = neighborhoods.lists.neighbors.data();
    particles.offset_bits = 64;
    if (!snapshot.boundary.empty()) {
        particles.boundary_count = snapshot.boundary.size();
        particles.boundary_positions = snapshot.boundary.data();
        particles.boundary_offsets = boundary.offsets.data();
        particles.boundary_neighbors = boundary.neighbors.data();
    }
    particles.candidates = classes.surface.data();
    return particles;
}

/// `components` values a slot as three values a particle where they are vectors; zeros for others.
std::vector<double> spread(const meniscus_results& found, const void* values,
                           std::size_t components) {
    const std::size_t width = components == 1 ? 1 : 3;
    const auto* of_slots = static_cast<const double*>(values);
    std::vector<double> all(found.count * width);
    for (std::size_t slot = 0; slot < found.slots; ++slot)
        std::copy_n(of_slots + slot * components, components,
                    all.begin() + static_cast<std::ptrdiff_t>(found.particle[slot] * width));
    return all;
}

void set_results(Snapshot& snapshot, const meniscus_results& found) {
    const auto dimension = static_cast<std::size_t>(snapshot.dimension);
    std::vector<std::uint8_t> classes(found.count);
    for (std::size_t slot = 0; slot < found.slots; ++slot)
        classes[found.particle[slot]] = found.surface_class[slot];
    set_array(snapshot, {"surface_class", 1, std::move(classes)});
    set_array(snapshot,
              {"runtime_uncovered_fraction", 1, spread(found, found.uncovered_fraction, 1)});
    set_array(snapshot, {"runtime_normal", 3, spread(found, found.normal, dimension)});
    set_array(snapshot, {"runtime_curvature", 1, spread(found, found.curvature, 1)});
    set_array(snapshot, {"runtime_force", 3, spread(found, found.force, dimension)});
}

std::unique_ptr<SurfaceStep> make_step(const meniscus_options& options, int dimension) {
    try {
        return surface_step(options, dimension, MENISCUS_DOUBLE);
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

std::string words_for(const meniscus_results& found, const meniscus_options& options) {
    const auto surface =
        std::count(found.surface_class, found.surface_class + found.slots, MENISCUS_AT_SURFACE);
    const bool complete =
        options.coverage == MENISCUS_EXACT || options.verification == MENISCUS_VERIFY;
    return fmt::format("{} let through by the line, {} of them surface, {}", found.slots, surface,
                       complete ? "none lost" : "those without an open sample dropped");
}

/// How the uncovered part of a candidate is found.
void add_coverage_options(CLI::App& group, SurfaceChoices& choices) {
    auto* samples =
        group
            .add_option("--samples", choices.samples,
                        "Samples of a candidate's sphere (default: 128); with --time-step the "
                        "fewest (default: 16)")
            ->check(CLI::Range(fewest_samples, most_samples));
    auto* time_step =
        group
            .add_option("--time-step", choices.time_step,
                        "Time step in s: samples are its product with --sampling-density, at "
                        "most 16384")
            ->check(positive_number());
    auto* density = group
                        .add_option("--sampling-density", choices.sampling_density,
                                    "C_SD in 1/s, samples a particle in a second of simulated time")
                        ->check(positive_number());
    time_step->needs(density);
    density->needs(time_step);
    auto* drop = group.add_flag("--drop-covered", choices.drop_covered,
                                "Candidates without an uncovered sample count as covered, as in "
                                "the paper (default: the exact test decides)");
    group.add_flag("--exact", choices.exact, "Uncovered parts in closed form in place of samples")
        ->excludes(samples)
        ->excludes(time_step)
        ->excludes(density)
        ->excludes(drop);
}

void add_smoothing_options(CLI::App& group, SurfaceChoices& choices) {
    group
        .add_option("--normal-passes", choices.normal_passes,
                    "Smoothing passes of the normals (default: 1)")
        ->check(passes());
    group.add_option("--tau", choices.tau, "Share of the neighbors in a pass (default: 0.5)")
        ->check(share());
    group
        .add_option("--pca-share", choices.pca_share,
                    "Share of the minor axis of the surface particles around in normals "
                    "(default: 0)")
        ->check(share());
    group
        .add_option("--curvature", choices.curvature,
                    "Curvature from the uncovered fraction alone, or by the map over the turning "
                    "of the normals (default: mapped)")
        ->check(CLI::IsMember({"closed", "mapped"}));
    group
        .add_option("--curvature-passes", choices.curvature_passes,
                    "Smoothing passes of the curvature (default: 0, with --paper 1)")
        ->check(passes());
}

void add_force_options(CLI::App& group, SurfaceChoices& choices) {
    auto* fade =
        group
            .add_option(
                "--fade", choices.fade,
                "Exposure at which a surface particle has its full weight, over that on a flat "
                "surface (default: 1/3)")
            ->check(share());
    group.add_flag("--no-fade", choices.no_fade, "Every surface particle has its full weight")
        ->excludes(fade);
    group
        .add_option("--force", choices.force,
                    "The paper's force, or the one in which sigma is in N/m (default: calibrated)")
        ->check(CLI::IsMember({"paper", "calibrated"}));
    group.add_option("--surface-tension", choices.surface_tension, "Sigma in N/m (default: 0.072)")
        ->check(number_between(-no_limit, no_limit, "a finite number"));
    group.add_flag("--balance-momentum", choices.balance_momentum,
                   "Take net force and torque out of every body of fluid that touches no boundary");
}

} // namespace

void add_surface_options(CLI::App& verb, SurfaceChoices& choices) {
    auto* group = verb.add_option_group("Surface tension");
    group->add_flag("--paper", choices.paper,
                    "All choices as in the 2020 paper; options below change single ones");
    add_coverage_options(*group, choices);
    add_smoothing_options(*group, choices);
    add_force_options(*group, choices);
}

SurfaceReport add_surface(Snapshot& snapshot, const Classes& classes, const Model& model,
                          const SurfaceChoices& choices, int threads) {
    const SupportRadii& radii = classes.neighborhoods.radii;
    const bool knows_spacing = snapshot.particle_spacing && !radii.vary();
    const double spacing_ratio = knows_spacing ? radii.largest / *snapshot.particle_spacing : 2;
    const auto options = step_options(choices, model.radius_ratio, spacing_ratio, threads);
    const auto boundary = find_boundary_neighbors(snapshot, radii, classes.valid, threads);
    const auto ids = sampling_ids(snapshot, classes.valid);
    const auto particles = step_particles(snapshot, classes, boundary, ids);
    const auto step = make_step(options, snapshot.dimension);
    step->step(particles);
    if (choices.balance_momentum)
        step->balance_momentum(particles);
    SurfaceReport report = {words_for(step->results(), options), ""};
    set_results(snapshot, step->results());
    set_provenance(snapshot, options, choices.balance_momentum);
    if (!knows_spacing)
        report.note = radii.vary() ? "    particle spacing: half of each support radius\n"
                                   : fmt::format("    particle spacing {} m: half the support "
                                                 "radius; --particle-spacing gives another\n",
                                                 radii.largest / 2);
    return report;
}

} // namespace meniscus
