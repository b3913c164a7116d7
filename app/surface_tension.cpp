#include "surface_tension.hpp"

#include <meniscus/bindings/step/surface_step.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/runtime/coverage/sample_directions.hpp>
#include <meniscus/runtime/surface/option_table.hpp>
#include <meniscus/runtime/surface/surface_particles.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace meniscus {
namespace {

/// Samples that a time step is not to fall below, where the user does not say.
constexpr std::size_t min_for_time_step = 16;

/// What model and input give, so that the command line does not.
bool comes_with_input(const char* name) {
    const std::vector<std::string> names = {"k", "d", "boundary_weight", "radius_ratio",
                                            "spacing_ratio"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string flag_of(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    return "--" + name;
}

/// As provenance, help and the command line have it.
template <class Value>
std::string text_of(const SurfaceOption<Value>& option, const SurfaceTensionOptions& options) {
    if constexpr (std::is_enum_v<Value>)
        return option.range.words[static_cast<std::size_t>(options.*option.member)];
    else
        return fmt::format("{}", options.*option.member);
}

/// Sets the option; returns what is wrong with the text, or nothing.
template <class Value>
std::string set_from_text(const SurfaceOption<Value>& option, const std::string& text,
                          SurfaceTensionOptions& options) {
    if constexpr (std::is_enum_v<Value>) {
        for (const int word : {0, 1})
            if (text == option.range.words[word]) {
                options.*option.member = static_cast<Value>(word);
                return {};
            }
    } else {
        double number = 0; // first, since the parser takes -1 for a large whole number
        Value value{};
        if (CLI::detail::lexical_cast(text, number) && is_in_range(option.range, number) &&
            CLI::detail::lexical_cast(text, value)) {
            options.*option.member = value;
            return {};
        }
    }
    return fmt::format("must be {}, found {}", option.range.text, text);
}

template <class Value>
std::string help_of(const SurfaceOption<Value>& option) {
    const std::string usual = text_of(option, {});
    const std::string of_paper = text_of(option, paper_options());
    const std::string unit = option.unit;
    return fmt::format("{}{}; {} (default: {}{})", option.meaning,
                       unit.empty() ? "" : " in " + unit, option.range.text, usual,
                       usual == of_paper ? "" : ", with --paper " + of_paper);
}

CLI::Validator positive_number() {
    return {[](const std::string& text) -> std::string {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) &&
                    is_in_range(option_ranges::positive, value))
                    return {};
                return fmt::format("must be {}, found {}", option_ranges::positive.text, text);
            },
            ""};
}

void set_provenance(Snapshot& snapshot, const SurfaceTensionOptions& options, bool balanced) {
    auto& provenance = snapshot.provenance;
    const std::string prefix = "runtime_";
    for (auto entry = provenance.begin(); entry != provenance.end();)
        entry = entry->first.rfind(prefix, 0) == 0 ? provenance.erase(entry) : std::next(entry);
    for (const auto& [name, value] : surface_option_texts(options))
        provenance[prefix + name] = value;
    provenance[prefix + "balance_momentum"] = balanced ? "true" : "false";
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
StepParticles step_particles(const Snapshot& snapshot, const Classes& classes,
                             const NeighborLists& boundary, const std::vector<std::uint32_t>& ids) {
    static_assert(sizeof(std::size_t) == sizeof(std::uint64_t));
    const Neighborhoods& neighborhoods = classes.neighborhoods;
    StepParticles particles;
    particles.count = snapshot.size();
    particles.positions = snapshot.positions.data();
    particles.stride = 3;
    particles.support_radius = neighborhoods.radii.max;
    if (neighborhoods.radii.vary())
        particles.support_radii = neighborhoods.radii.each.data();
    particles.ids = ids.empty() ? nullptr : ids.data();
    particles.offsets = neighborhoods.lists.offsets.data();
    particles.neighbors = neighborhoods.lists.neighbors.data();
    if (!snapshot.boundary.empty()) {
        particles.boundary_positions = snapshot.boundary.data();
        particles.boundary_offsets = boundary.offsets.data();
        particles.boundary_neighbors = boundary.neighbors.data();
    }
    particles.candidates = classes.surface.data();
    return particles;
}

/// `components` values a slot as three values a particle where they are vectors; zeros for others.
std::vector<double> spread(const SurfaceStepResults& found, const void* values,
                           std::size_t components) {
    const std::size_t width = components == 1 ? 1 : 3;
    const auto* of_slots = static_cast<const double*>(values);
    std::vector<double> all(found.count * width);
    for (std::size_t slot = 0; slot < found.slots; ++slot)
        std::copy_n(of_slots + slot * components, components,
                    all.begin() + static_cast<std::ptrdiff_t>(found.particle[slot] * width));
    return all;
}

void set_results(Snapshot& snapshot, const SurfaceStepResults& found) {
    const auto dimension = static_cast<std::size_t>(snapshot.dimension);
    std::vector<std::uint8_t> classes(found.count);
    for (std::size_t slot = 0; slot < found.slots; ++slot)
        classes[found.particle[slot]] = found.surface_class[slot];
    set_array(snapshot, {"surface_class", 1, stored_classes(classes)});
    set_array(snapshot,
              {"runtime_uncovered_fraction", 1, spread(found, found.uncovered_fraction, 1)});
    set_array(snapshot, {"runtime_normal", 3, spread(found, found.normal, dimension)});
    set_array(snapshot, {"runtime_curvature", 1, spread(found, found.curvature, 1)});
    set_array(snapshot, {"runtime_force", 3, spread(found, found.force, dimension)});
}

std::string words_for(const SurfaceCounts& found, const SurfaceTensionOptions& options) {
    const bool complete =
        options.coverage == CoverageMethod::exact || options.verification == Verification::exact;
    return fmt::format("{} candidates of the line, {} of them surface, {}", found.candidates,
                       found.surface,
                       complete ? "by an exact check that drops no surface particle"
                                : "those without an open sample dropped");
}

SurfaceCounts counts_of(const SurfaceStepResults& found) {
    return {found.slots, static_cast<std::uint64_t>(
                             std::count(found.surface_class, found.surface_class + found.slots,
                                        static_cast<std::uint8_t>(SurfaceClass::surface)))};
}

std::unique_ptr<SurfaceStep> make_step(const SurfaceTensionOptions& options, int dimension,
                                       int threads) {
    try {
        return surface_step(options, {dimension, true, threads});
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

/// What model and state decide.
void set_by_model(SurfaceTensionOptions& options, const Model& model, double spacing_ratio) {
    options.radius_ratio = model.radius_ratio;
    options.boundary_weight = model.boundary_weight;
    // Both lines have been applied: the step is not to add the second one of those that ship.
    options.k = model.line.k;
    options.d = model.line.d;
    options.second_line = {};
    options.spacing_ratio = spacing_ratio;
}

} // namespace

void add_surface_options(CLI::App& verb, SurfaceChoices& choices) {
    auto* group = verb.add_option_group("Surface tension");
    group->add_flag("--paper", choices.paper,
                    "All choices as in the 2020 paper; options below change single ones");
    for_each_surface_option([&](const auto& option) {
        if (comes_with_input(option.name))
            return;
        const auto problem = [option](const std::string& text) {
            SurfaceTensionOptions made;
            return set_from_text(option, text, made);
        };
        group->add_option(flag_of(option.name), choices.options[option.name], help_of(option))
            ->check(CLI::Validator(problem, ""))
            ->type_name(option.range.words[0] != nullptr ? "NAME" : "NUMBER");
    });
    auto* time_step =
        group
            ->add_option("--time-step", choices.time_step,
                         "Time step in s: samples are its product with --sampling-density, at "
                         "most 16384 and at least --samples (here 16 by default)")
            ->check(positive_number());
    auto* density = group
                        ->add_option("--sampling-density", choices.sampling_density,
                                     "C_SD in 1/s, samples a particle in a second of simulated "
                                     "time")
                        ->check(positive_number());
    time_step->needs(density);
    density->needs(time_step);
    group->add_flag(
        "--balance-momentum", choices.balance_momentum,
        "Take net force and torque out of every body of fluid that touches no boundary");
}

std::map<std::string, std::string> surface_option_texts(const SurfaceTensionOptions& options) {
    std::map<std::string, std::string> texts;
    const bool sampled = options.coverage == CoverageMethod::sampled;
    for_each_surface_option([&](const auto& option) {
        if (!is_of_line(option) && (sampled || !option.only_sampled))
            texts[option.name] = text_of(option, options);
    });
    return texts;
}

SurfaceTensionOptions surface_options(const SurfaceChoices& choices) {
    SurfaceTensionOptions options = choices.paper ? paper_options() : SurfaceTensionOptions{};
    const auto given = [&](const char* name) {
        const auto found = choices.options.find(name);
        return found != choices.options.end() ? found->second : std::string();
    };
    std::string only_sampled = choices.time_step ? "--time-step" : "";
    for_each_surface_option([&](const auto& option) {
        const std::string text = given(option.name);
        if (text.empty())
            return;
        set_from_text(option, text, options);
        if (option.only_sampled)
            only_sampled = flag_of(option.name);
    });
    if (options.coverage == CoverageMethod::exact && !only_sampled.empty())
        throw InputError(only_sampled + " has no meaning with --coverage exact; leave one out");
    if (choices.time_step)
        options.samples =
            samples_for_time_step(*choices.time_step, *choices.sampling_density,
                                  given("samples").empty() ? min_for_time_step : options.samples);
    return options;
}

SurfaceReport note_surface(Snapshot& snapshot, const SurfaceCounts& found, const Model& model,
                           SurfaceTensionOptions options, double spacing_ratio, bool balanced) {
    set_by_model(options, model, spacing_ratio);
    set_provenance(snapshot, options, balanced);
    return {words_for(found, options),
            fmt::format("    h is {:.2f} spacings of particles at rest{}\n", options.spacing_ratio,
                        snapshot.particle_volume && snapshot.support_radius
                            ? ""
                            : ", as measured; --particle-volume gives another")};
}

SurfaceCounts find_surface(Snapshot& snapshot, const Classes& classes, const Model& model,
                           SurfaceTensionOptions options, bool balanced, int threads) {
    set_by_model(options, model, classes.neighborhoods.spacing_ratio);
    const auto boundary =
        find_boundary_neighbors(snapshot, classes.neighborhoods.radii, classes.valid, threads);
    const auto ids = sampling_ids(snapshot, classes.valid);
    const auto particles = step_particles(snapshot, classes, boundary, ids);
    const auto step = make_step(options, snapshot.dimension, threads);
    step->step(particles);
    if (balanced)
        step->balance_momentum(particles);
    set_results(snapshot, step->results());
    return counts_of(step->results());
}

SurfaceReport add_surface(Snapshot& snapshot, const Classes& classes, const Model& model,
                          const SurfaceTensionOptions& options, bool balanced, int threads) {
    const SurfaceCounts found = find_surface(snapshot, classes, model, options, balanced, threads);
    return note_surface(snapshot, found, model, options, classes.neighborhoods.spacing_ratio,
                        balanced);
}

} // namespace meniscus
