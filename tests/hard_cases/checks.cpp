#include "checks.hpp"

#include "host_state.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/labeler/sampling/directions.hpp>
#include <meniscus/meniscus.h>
#include <meniscus/runtime/surface/shipped_classifier.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <memory>

namespace meniscus::test {
namespace {

constexpr double radius_ratio = 0.8;

/// Steps of the coordinates in support radii, the largest of all particles.
template <class Real>
double resolution_of(const HardCase& hard_case) {
    double max = 0;
    for (const auto& position : hard_case.positions)
        max = std::max(max, position_step(position, 3, hard_case.support_radius,
                                          std::numeric_limits<Real>::digits));
    return max;
}

/// The case as a file with coordinates in Real would have it.
template <class Real>
Snapshot snapshot_in(const HardCase& hard_case) {
    Snapshot snapshot = snapshot_of(hard_case);
    snapshot.position_precision =
        std::is_same_v<Real, float> ? Precision::float32 : Precision::float64;
    snapshot.positions = rounded_to<Real>(snapshot.positions);
    snapshot.boundary = rounded_to<Real>(snapshot.boundary);
    return snapshot;
}

std::vector<double> labels_of(const HardCase& hard_case) {
    LabelOptions options;
    options.threads = 1;
    return label_particles(snapshot_of(hard_case), hard_case.support_radius, options)
        .uncovered_fraction;
}

/// What is known of a case before any method runs on it.
template <class Real, int Dimension>
struct Subject {
    const HardCase& hard_case;
    HostState<Real, Dimension> state;
    std::vector<double> truth; ///< lambda, by the formula or of the fluid turned, in double
    double resolution;

    explicit Subject(const HardCase& hard)
        : hard_case(hard), state(hard), truth(labels_of(turned_about_first(hard, 17))),
          resolution(resolution_of<Real>(hard)) {
        if (hard.uncovered_fraction >= 0)
            truth.assign(hard.size(), hard.uncovered_fraction);
    }

    /// What rounding of positions may change lambda by: that much moves a cap's edge.
    [[nodiscard]] double lambda_tolerance() const { return 1e-9 + 8 * resolution; }

    /// False where rounding may move a neighbor over the limit at h, which changes lambda by a
    /// jump.
    [[nodiscard]] bool keeps_neighbors() const { return resolution < neighbor_band / 4; }

    [[nodiscard]] Check check(const std::string& method) const {
        return {hard_case.name, method, hard_case.why, "", 0, true};
    }
};

/// Counts particles that are not what they must be.
struct Mistakes {
    std::size_t missed = 0; ///< surface, and not found
    std::size_t wrong = 0;  ///< interior, and taken for surface

    template <class IsSurface>
    Mistakes(const HardCase& hard_case, const IsSurface& is_surface) {
        for (std::size_t i = 0; i < hard_case.size(); ++i) {
            const Expected expected = hard_case.expected[i];
            missed += expected == Expected::surface && !is_surface(i) ? 1 : 0;
            wrong += expected == Expected::interior && is_surface(i) ? 1 : 0;
        }
    }

    [[nodiscard]] std::string text() const {
        return missed + wrong == 0 ? "as expected"
                                   : std::to_string(missed) + " missed, " + std::to_string(wrong) +
                                         " wrongly surface";
    }
};

/// A line that lets everything through.
template <class Real>
constexpr SurfaceLine<Real> no_line{Real(0), Real(1e9)};

/// Support radius over spacing, as far as lines ship for.
double spacing_ratio_of(const HardCase& hard_case) {
    return std::min(hard_case.support_radius / spacing_of(hard_case), 4.5);
}

template <class Real, int Dimension>
SurfaceLine<Real> shipped_line(const HardCase& hard_case) {
    const auto line = shipped_first_line(Dimension, spacing_ratio_of(hard_case));
    return {static_cast<Real>(line.k), static_cast<Real>(line.d)};
}

template <class Real, int Dimension>
Check check_features_and_line(const Subject<Real, Dimension>& subject) {
    const auto& state = subject.state;
    Check check = subject.check("features and line");
    const auto radius = static_cast<double>(state.radius);
    const auto range = neighbor_range<Real>(radius, radius_ratio);
    const auto exact_range = neighbor_range<double>(radius, radius_ratio);
    const auto line = shipped_line<Real, Dimension>(subject.hard_case);
    std::vector<std::uint8_t> surface(state.size());
    for (std::size_t i = 0; i < state.size(); ++i) {
        const auto sum = sum_features<Real, Dimension>(state.view(), i, range);
        surface[i] = is_surface(sum, line, state.radius) ? 1 : 0;
        FeatureSum<double, Dimension> plain;
        state.view()(i, [&](std::size_t, const auto& step, Real mass) {
            const auto exact = [&](int axis) { return static_cast<double>(step[axis]); };
            std::array<double, Dimension> displacement;
            for (int axis = 0; axis < Dimension; ++axis)
                displacement[axis] = exact(axis);
            plain.add(displacement, squared_length<double, Dimension>(displacement),
                      static_cast<double>(mass), exact_range);
        });
        const auto offset = static_cast<double>(mass_offset(sum, state.radius));
        if (is_finite(offset))
            check.max_error =
                std::max(check.max_error, std::abs(offset - mass_offset(plain, radius)));
        // What overflows must be let through: that costs time alone.
        const bool same = sum.count == plain.count && (is_finite(offset) || surface[i] != 0);
        check.passed = check.passed && same;
    }
    const Mistakes mistakes(subject.hard_case, [&](std::size_t i) { return surface[i] != 0; });
    const double tolerance = std::is_same_v<Real, float> ? 1e-5 : 1e-13;
    check.passed = check.passed && check.max_error <= tolerance &&
                   (mistakes.missed == 0 || !subject.hard_case.line_misses.empty());
    if (!check.passed)
        check.result = "features differ from those in double, or surface is missed";
    else if (mistakes.missed > 0)
        check.result = "the line misses " + std::to_string(mistakes.missed) + ": " +
                       subject.hard_case.line_misses;
    return check;
}

/// One pass of find_candidates and find_exposure.
template <class Real, int Dimension>
SurfaceParticles<Real, Dimension>
exposed(const Subject<Real, Dimension>& subject, const SurfaceLine<Real>& line,
        const SampleDirections& directions, const SurfaceTensionOptions& options) {
    static const HeldCells cells;
    const auto& state = subject.state;
    SurfaceParticles<Real, Dimension> list;
    std::vector<ExposureMemory> memory(1);
    find_candidates<Real, Dimension>(state.view(), state.size(), state.radii(), line, radius_ratio,
                                     SerialLoop{}, list);
    state.with_boundary([&](const auto& boundary) {
        find_exposure<Real, Dimension>(state.view(), boundary, state.radii(), nullptr, directions,
                                       cells, options, SerialLoop{}, memory.data(), list);
    });
    return list;
}

template <class Real, int Dimension>
bool is_surface(const SurfaceParticles<Real, Dimension>& list, std::size_t i) {
    return list.slot_of[i] >= 0 && list.surface_class[list.slot_of[i]] == SurfaceClass::surface;
}

/// The openings that so many samples are sure to find; 0: all that there are.
double surely_found(std::size_t samples) {
    return samples == 0 ? 0 : 20 / static_cast<double>(samples);
}

/// Judges classes and fractions; `tolerance(lambda)` bounds the error of each. Particles that the
/// line missed are counted there, and openings up to `may_miss` may be missed.
template <class Real, int Dimension, class Tolerance>
void judge(const Subject<Real, Dimension>& subject, const SurfaceParticles<Real, Dimension>& list,
           double may_miss, const Tolerance& tolerance, Check& check) {
    const Mistakes mistakes(subject.hard_case, [&](std::size_t i) {
        const bool is_excused = list.slot_of[i] < 0 || subject.truth[i] <= may_miss;
        return is_surface(list, i) ||
               (is_excused && subject.hard_case.expected[i] == Expected::surface);
    });
    check.result = mistakes.text();
    check.passed = mistakes.missed + mistakes.wrong == 0;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        if (list.contact[slot].is_there())
            continue; // its fraction is that with the fluid continued into the wall
        const double truth = subject.truth[list.particle[slot]];
        const double error = std::abs(static_cast<double>(list.uncovered_fraction[slot]) - truth);
        check.max_error = std::max(check.max_error, error);
        if (subject.keeps_neighbors())
            check.passed = check.passed && error <= tolerance(truth);
    }
}

template <class Real, int Dimension>
Check check_exact(const Subject<Real, Dimension>& subject, bool with_line) {
    Check check = subject.check(with_line ? "candidates, exact verification" : "exact coverage");
    SurfaceTensionOptions options;
    options.coverage = CoverageMethod::exact;
    const auto line = with_line ? shipped_line<Real, Dimension>(subject.hard_case) : no_line<Real>;
    const auto list = exposed(subject, line, SampleDirections{}, options);
    judge(
        subject, list, 0, [&](double) { return subject.lambda_tolerance(); }, check);
    return check;
}

/// Six standard errors of a share of independent samples, and as many samples at least.
double sampling_tolerance(double lambda, std::size_t samples) {
    const double count = static_cast<double>(samples);
    return 6 * std::sqrt(std::max(lambda * (1 - lambda), 1 / count) / count);
}

constexpr std::size_t runtime_samples = 128;

/// The runtime's own directions, or some of one of the labeler's schemes.
template <int Dimension>
SampleDirections directions_of(const std::string& name) {
    constexpr std::size_t samples = runtime_samples;
    SampleDirections directions;
    if (name == "outward") {
        fill_outward_directions<Dimension>(samples, 0, directions);
        return directions;
    }
    const SamplingScheme scheme = sampling_scheme(name);
    std::vector<Direction> one_for_all(samples);
    scheme.fill(Dimension, 0, 0, one_for_all);
    fill_directions(
        samples, false, [&](std::size_t, std::size_t k) { return one_for_all[k]; },
        [](std::size_t) { return 1.0 / samples; }, directions);
    return directions;
}

template <class Real, int Dimension>
Check check_sampled(const Subject<Real, Dimension>& subject, const std::string& scheme,
                    Verification verification) {
    static std::map<std::string, SampleDirections> of_scheme; // made once, for all cases
    if (of_scheme.count(scheme) == 0)
        of_scheme[scheme] = directions_of<Dimension>(scheme);
    const bool verifies = verification == Verification::exact;
    Check check =
        subject.check("sampled coverage, " + scheme + (verifies ? ", verified" : ", dropped"));
    SurfaceTensionOptions options;
    options.verification = verification;
    const auto list = exposed(subject, no_line<Real>, of_scheme[scheme], options);
    judge(
        subject, list, verifies ? 0 : surely_found(runtime_samples),
        [&](double lambda) { return sampling_tolerance(lambda, runtime_samples); }, check);
    return check;
}

template <class Real, int Dimension>
Check check_labels(const Subject<Real, Dimension>& subject, LabelMethod method,
                   const std::string& scheme) {
    const HardCase& hard_case = subject.hard_case;
    const bool exact = method == LabelMethod::exact;
    Check check = subject.check(exact ? "exact labels" : "Monte Carlo labels, " + scheme);
    LabelOptions options;
    options.method = method;
    options.scheme = scheme;
    options.samples = 1000;
    options.threads = 1;
    const Labels labels = label_particles(snapshot_in<Real>(hard_case),
                                          static_cast<double>(subject.state.radius), options);
    const double may_miss = exact ? 0 : surely_found(options.samples);
    const Mistakes mistakes(hard_case, [&](std::size_t i) {
        return labels.surface[i] != 0 ||
               (hard_case.expected[i] == Expected::surface && subject.truth[i] <= may_miss);
    });
    check.result = mistakes.text();
    check.passed = mistakes.missed + mistakes.wrong == 0;
    for (std::size_t i = 0; i < hard_case.size(); ++i) {
        const double error = std::abs(labels.uncovered_fraction[i] - subject.truth[i]);
        check.max_error = std::max(check.max_error, error);
        const double tolerance = exact ? subject.lambda_tolerance()
                                       : sampling_tolerance(subject.truth[i], options.samples) +
                                             subject.lambda_tolerance();
        check.passed = check.passed && (error <= tolerance || !subject.keeps_neighbors());
    }
    check.passed =
        check.passed && labels.warnings.empty() == (subject.resolution <= doubtful_position_step);
    if (!labels.warnings.empty())
        check.result += ", with a warning";
    return check;
}

template <class Real, int Dimension>
double length_of(const std::array<Real, Dimension>& vector) {
    double sum = 0;
    for (const Real coordinate : vector)
        sum += static_cast<double>(coordinate) * static_cast<double>(coordinate);
    return std::sqrt(sum);
}

/// Normals, curvature and force of a whole step.
template <class Real, int Dimension>
Check check_step(const Subject<Real, Dimension>& subject, const std::string& name,
                 SurfaceTension<Real, Dimension>& tension) {
    const auto& state = subject.state;
    Check check = subject.check(name);
    state.with_boundary([&](const auto& boundary) {
        tension.step(state.view(), boundary, state.size(), state.radii(), nullptr, SerialLoop{});
    });
    const auto& list = tension.surface();
    const double max_curvature = 2 / std::sqrt(1 - radius_ratio * radius_ratio) + 1e-4;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const double normal = length_of<Real, Dimension>(list.normal[slot]);
        const double force = length_of<Real, Dimension>(list.force[slot]);
        const double curvature =
            static_cast<double>(list.curvature[slot]) * static_cast<double>(state.radius);
        const bool covered = list.surface_class[slot] != SurfaceClass::surface;
        if (normal > 0)
            check.max_error = std::max(check.max_error, std::abs(normal - 1));
        check.passed = check.passed && is_finite(force) && std::abs(curvature) <= max_curvature &&
                       (!covered || (force == 0 && normal == 0));
    }
    const Mistakes mistakes(subject.hard_case, [&](std::size_t i) {
        return is_surface(list, i) || subject.hard_case.expected[i] == Expected::surface;
    });
    check.passed = check.passed && check.max_error <= 1e-5 && mistakes.wrong == 0;
    check.result = check.passed ? "finite, unit normals, no force inside" : "see largest error";
    return check;
}

/// Net force and torque after balance_momentum, over the sum of their parts.
template <class Real, int Dimension>
Check check_momentum(const Subject<Real, Dimension>& subject,
                     SurfaceTension<Real, Dimension>& tension) {
    const auto& state = subject.state;
    Check check = subject.check("momentum balance");
    check.result = "no net force and torque";
    if (!state.boundary.empty()) { // a body at a wall keeps its net force
        check.result = "touches a wall";
        return check;
    }
    tension.template balance_momentum<Dimension>(state.view(), NoBoundary{}, state.radii(),
                                                 state.positions.data(), SerialLoop{});
    const auto& list = tension.surface();
    Vector3 net{}, torque{};
    double forces = 0, torques = 0;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        Vector3 force{}, arm{};
        for (int axis = 0; axis < Dimension; ++axis) {
            force[axis] = static_cast<double>(list.force[slot][axis]);
            arm[axis] =
                static_cast<double>(state.positions[list.particle[slot] * Dimension + axis]) -
                static_cast<double>(state.positions[axis]);
        }
        net = sum(net, force);
        torque = sum(torque, cross(arm, force));
        forces += std::sqrt(dot(force, force));
        torques += std::sqrt(dot(arm, arm) * dot(force, force));
    }
    if (forces > 0)
        check.max_error = std::sqrt(dot(net, net)) / forces;
    if (torques > 0)
        check.max_error = std::max(check.max_error, std::sqrt(dot(torque, torque)) / torques);
    check.passed = check.max_error <= (std::is_same_v<Real, float> ? 1e-5 : 1e-12);
    return check;
}

template <class Real>
struct CSurface {
    meniscus_surface* handle = nullptr;
    CSurface(int dimension, double spacing_ratio) {
        meniscus_options options;
        meniscus_options_init(&options, sizeof options);
        options.spacing_ratio = spacing_ratio;
        options.threads = 1;
        meniscus_create(&handle, &options, dimension,
                        std::is_same_v<Real, double> ? MENISCUS_DOUBLE : MENISCUS_FLOAT);
    }
    CSurface(const CSurface&) = delete;
    CSurface& operator=(const CSurface&) = delete;
    ~CSurface() { meniscus_destroy(handle); }
};

template <class Real, int Dimension>
meniscus_particles c_particles(const HostState<Real, Dimension>& state) {
    meniscus_particles particles{};
    particles.size = sizeof particles;
    particles.count = state.size();
    particles.positions = state.positions.data();
    particles.masses = state.masses.empty() ? nullptr : state.masses.data();
    particles.support_radius = static_cast<double>(state.radius);
    particles.offsets = state.lists.offsets.data();
    particles.neighbors = state.lists.neighbors.data();
    particles.offset_bits = 64;
    if (state.boundary.empty())
        return particles;
    particles.boundary_count = state.boundary.size() / Dimension;
    particles.boundary_positions = state.boundary.data();
    particles.boundary_offsets = state.boundary_lists.offsets.data();
    particles.boundary_neighbors = state.boundary_lists.neighbors.data();
    return particles;
}

/// The C interface gives what the headers give.
template <class Real, int Dimension>
Check check_c_interface(const Subject<Real, Dimension>& subject) {
    Check check = subject.check("C interface");
    const double spacing_ratio = spacing_ratio_of(subject.hard_case);
    const CSurface<Real> surface(Dimension, spacing_ratio);
    const auto particles = c_particles(subject.state);
    meniscus_results results{};
    results.size = sizeof results;
    // Some have more neighbors than any ratio that lines ship for: meniscus_check says so.
    const bool is_known = meniscus_check(surface.handle, &particles) == MENISCUS_OK ||
                          (subject.hard_case.support_radius / spacing_of(subject.hard_case) > 4.5 &&
                           std::strstr(meniscus_last_error(), "spacing_ratio") != nullptr);
    check.passed = is_known && meniscus_step(surface.handle, &particles) == MENISCUS_OK &&
                   meniscus_get_results(surface.handle, &results) == MENISCUS_OK;
    if (!check.passed) {
        check.result = meniscus_last_error();
        return check;
    }
    SurfaceTensionOptions options;
    options.spacing_ratio = spacing_ratio;
    SurfaceTension<Real, Dimension> tension(options);
    check_step(subject, "", tension);
    const auto& list = tension.surface();
    check.passed = results.slots == list.size();
    const auto* forces = static_cast<const Real*>(results.force);
    for (std::size_t slot = 0; check.passed && slot < list.size(); ++slot) {
        check.passed =
            results.surface_class[slot] == static_cast<std::uint8_t>(list.surface_class[slot]);
        for (int axis = 0; axis < Dimension; ++axis)
            check.passed =
                check.passed && forces[slot * Dimension + axis] == list.force[slot][axis];
    }
    check.result = check.passed ? "same bits as the headers" : "differs from the headers";
    return check;
}

/// What must be refused: by the labeler, by the search for neighbors or the C interface's check.
template <class Real, int Dimension>
std::vector<Check> check_refusals(const HardCase& hard_case) {
    std::vector<Check> checks;
    const auto add = [&](const std::string& method, const std::string& message) {
        checks.push_back({hard_case.name, method, hard_case.why,
                          message.empty() ? "taken without a word" : "refused: " + message, 0,
                          !message.empty()});
    };
    for (const LabelMethod method : {LabelMethod::exact, LabelMethod::monte_carlo}) {
        LabelOptions options;
        options.method = method;
        options.samples = 100;
        std::string message;
        try {
            label_particles(snapshot_in<Real>(hard_case), hard_case.support_radius, options);
        } catch (const InputError& error) {
            message = error.what();
        }
        add(method == LabelMethod::exact ? "exact labels" : "Monte Carlo labels", message);
    }
    HardCase alone = hard_case; // lists are the host's; what it reads is not
    alone.positions.clear();
    alone.support_radius = 1;
    alone.boundary.clear();
    HostState<Real, Dimension> state(alone);
    state.positions = state.rounded(hard_case.positions);
    state.radius = static_cast<Real>(hard_case.support_radius);
    state.lists.offsets.assign(hard_case.size() + 1, 0);
    const CSurface<Real> surface(Dimension, 2);
    const auto particles = c_particles(state);
    const bool refuses = meniscus_check(surface.handle, &particles) == MENISCUS_BAD_ARGUMENT;
    add("C interface", refuses ? meniscus_last_error() : "");
    return checks;
}

template <class Real, int Dimension>
std::vector<Check> check_all(const HardCase& hard_case) {
    if (hard_case.is_refused<Real>())
        return check_refusals<Real, Dimension>(hard_case);
    const Subject<Real, Dimension> subject(hard_case);
    std::vector<Check> checks{check_features_and_line(subject), check_exact(subject, true),
                              check_exact(subject, false),
                              check_labels(subject, LabelMethod::exact, "")};
    for (const char* scheme : {"halton", "random", "table", "blue-noise"}) {
        checks.push_back(check_labels(subject, LabelMethod::monte_carlo, scheme));
        checks.push_back(check_sampled(subject, scheme, Verification::exact));
    }
    checks.push_back(check_sampled(subject, "outward", Verification::exact));
    checks.push_back(check_sampled(subject, "outward", Verification::drop));
    for (const bool paper : {false, true}) {
        SurfaceTension<Real, Dimension> tension(paper ? paper_options() : SurfaceTensionOptions{});
        checks.push_back(
            check_step(subject, paper ? "step, paper options" : "step, shipped options", tension));
        checks.push_back(check_momentum(subject, tension));
    }
    checks.push_back(check_c_interface(subject));
    return checks;
}

} // namespace

template <class Real>
std::vector<Check> check_case(const HardCase& hard_case) {
    return hard_case.dimension == 2 ? check_all<Real, 2>(hard_case) : check_all<Real, 3>(hard_case);
}

template std::vector<Check> check_case<float>(const HardCase&);
template std::vector<Check> check_case<double>(const HardCase&);

} // namespace meniscus::test
