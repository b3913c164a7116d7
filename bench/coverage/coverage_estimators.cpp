#include "coverage_estimators.hpp"

#include "color_field_estimator.hpp"
#include "coverage_cases.hpp"
#include "normals/normal_schemes.hpp"
#include "support/known_state.hpp"
#include "support/loops.hpp"
#include "support/statistics.hpp"

#include <meniscus/runtime/surface/surface_tension.hpp>

#include <functional>
#include <optional>

namespace meniscus {
namespace {

/// What is known of a surface particle.
struct Truth {
    double lambda = 0;
    double weight = 0; ///< in forces (exposure_weight), by exact coverage; 0 where not measured
    bool is_outermost = false; ///< and more than a pinhole: its normal is measured
    Vector3 normal = {0, 0, 0};
    double curvature = 0; ///< h kappa
};

/// What an estimator says of one.
struct Estimate {
    bool is_found = false;
    std::optional<double> lambda;
    Vector3 raw_normal = {0, 0, 0};
    Vector3 normal = {0, 0, 0};
    double curvature = 0;
};

/// Particles around which coverage is to be found, in support radii.
template <int Dimension>
struct Case {
    std::string name;
    std::vector<double> positions;
    NeighborLists lists;
    std::vector<std::uint8_t> candidate; ///< the surface particles
    std::vector<std::uint32_t> neighbor_count;
    std::vector<std::size_t> surface; ///< they again, as indices
    std::vector<Truth> truth;         ///< one each
    bool has_normals = false;         ///< that are known

    [[nodiscard]] CsrNeighborhood<double, Dimension> view() const {
        return {positions.data(), nullptr, lists.offsets.data(), lists.neighbors.data()};
    }
    /// After the lists.
    void add_surface(std::size_t particle, const Truth& known) {
        candidate[particle] = 1;
        neighbor_count[particle] =
            static_cast<std::uint32_t>(lists.offsets[particle + 1] - lists.offsets[particle]);
        surface.push_back(particle);
        truth.push_back(known);
    }
};

/// The particles of all cases first, one in the place of another, then their neighbors.
Case<3> snapshot_case(const std::vector<std::filesystem::path>& files, std::size_t per_file) {
    const auto cases = cases_of_files(files, per_file);
    Case<3> made;
    made.name = "snapshots";
    made.positions.resize(3 * cases.size());
    for (const CoverageCase& one : cases) {
        made.lists.offsets.push_back(made.lists.neighbors.size());
        for (const Direction& displacement : one.displacements) {
            made.lists.neighbors.push_back(static_cast<std::uint32_t>(made.positions.size() / 3));
            made.positions.insert(made.positions.end(), displacement.begin(), displacement.end());
        }
    }
    made.lists.offsets.resize(made.positions.size() / 3 + 1, made.lists.neighbors.size());
    made.candidate.resize(made.positions.size() / 3);
    made.neighbor_count.resize(made.positions.size() / 3);
    for (std::size_t c = 0; c < cases.size(); ++c) {
        Truth known;
        known.lambda = cases[c].uncovered_fraction;
        made.add_surface(c, known);
    }
    return made;
}

// --- coverage ---

/// Whatever finds uncovered parts: directions, or none where coverage is exact.
struct Estimator {
    std::string name;
    std::size_t samples = 0; ///< 0: exact
    SurfaceTensionOptions options = {};
    bool is_drawn = false; ///< directions are drawn for each particle
    /// One that serves all workers, or one each where they are drawn.
    std::vector<SampleDirections> directions = std::vector<SampleDirections>(1);
};

/// What estimators work with from call to call.
template <int Dimension>
struct Work {
    SurfaceParticles<double, Dimension> list;
    std::vector<ExposureMemory> memory;
    std::vector<std::array<double, Dimension>> normals_before;
    std::vector<double> mapped;
};

template <int Dimension, class Loop>
void find_coverage(const Case<Dimension>& some, Estimator& estimator, const Loop& loop,
                   Work<Dimension>& work) {
    static const HeldCells cells;
    work.memory.resize(std::max(work.memory.size(), static_cast<std::size_t>(loop.workers())));
    take_candidates(some.candidate.data(), some.neighbor_count.data(), some.candidate.size(),
                    work.list);
    const auto find = [&](const SampleDirections& directions, const auto& over, int worker) {
        find_exposure<double, Dimension>(some.view(), NoBoundary{}, UniformRadius<double>{1},
                                         nullptr, directions, cells, estimator.options, over,
                                         &work.memory[static_cast<std::size_t>(worker)], work.list);
    };
    if (!estimator.is_drawn) {
        find(estimator.directions[0], loop, 0);
        return;
    }
    loop(work.list.size(), [&](std::size_t begin, std::size_t end, int worker) {
        auto& own = estimator.directions[static_cast<std::size_t>(worker)];
        find(own, RandomEachTime<Dimension>{1, own, begin, end}, worker);
    });
}

/// Normals and curvature, as a step finds them.
template <int Dimension, class Loop>
void finish(const Loop& loop, Work<Dimension>& work) {
    static const SurfaceTensionOptions shipped = completed({}, Dimension);
    smooth_normals<double, Dimension>(shipped.tau, loop, work.list, work.normals_before);
    find_mapped_curvature<double, Dimension>(shipped.curvature_map, shipped.radius_ratio,
                                             UniformRadius<double>{1}, loop, work.list,
                                             work.mapped);
}

template <int Dimension>
Vector3 in_space(const std::array<double, Dimension>& vector) {
    return {vector[0], vector[1], Dimension == 3 ? vector[Dimension - 1] : 0};
}

template <int Dimension>
std::vector<Estimate> estimates_of(const Case<Dimension>& some, Estimator& estimator, int threads) {
    const OpenMpLoop loop{threads, estimator_chunk};
    Work<Dimension> work;
    find_coverage(some, estimator, loop, work);
    std::vector<Estimate> estimates;
    const auto& list = work.list;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        Estimate one;
        one.is_found = list.surface_class[slot] == SurfaceClass::surface;
        one.lambda = list.uncovered_fraction[slot];
        one.raw_normal = in_space<Dimension>(list.normal[slot]);
        estimates.push_back(one);
    }
    finish(loop, work);
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        estimates[slot].normal = in_space<Dimension>(list.normal[slot]);
        estimates[slot].curvature = list.curvature[slot];
    }
    return estimates;
}

Estimator exact_estimator() {
    Estimator exact{"exact coverage"};
    exact.options.coverage = CoverageMethod::exact;
    return exact;
}

/// A published scheme, by its name in the labeler.
Estimator published(const std::string& name, const std::string& scheme, int dimension,
                    std::size_t samples) {
    Estimator made{name, samples};
    made.options.verification = Verification::drop;
    fill_from_scheme(scheme, dimension, samples, 0, made.directions[0]);
    return made;
}

template <int Dimension>
std::vector<Estimator> estimators(std::size_t samples, int threads) {
    std::vector<Estimator> all;
    all.push_back(published("random, drawn each time", "random", Dimension, samples));
    all.back().is_drawn = true;
    all.back().directions[0].sets = 1;
    all.back().directions.resize(static_cast<std::size_t>(threads), all.back().directions[0]);
    all.push_back(published("random table", "table", Dimension, samples));
    all.push_back(published("blue noise", "blue-noise", Dimension, samples));
    all.push_back(published("Halton 2-3", "halton", Dimension, samples));
    for (const bool verified : {false, true}) {
        Estimator outward{verified ? "outward, verified" : "outward", samples};
        outward.options.verification = verified ? Verification::exact : Verification::drop;
        fill_outward_directions<Dimension>(samples, 0, outward.directions[0]);
        all.push_back(outward);
    }
    return all;
}

// --- errors ---

double degrees_between(const Vector3& a, const Vector3& b) {
    const Vector3 across = cross(a, b);
    return std::atan2(std::sqrt(dot(across, across)), dot(a, b)) * 180 / pi;
}

/// Lost in percent, lambda, raw normals, normals, curvature.
std::vector<Cell> errors_of(const std::vector<Truth>& truth, bool has_normals,
                            const std::vector<Estimate>& estimates) {
    double lost = 0;
    Spread lambda, raw_normal, normal, curvature;
    for (std::size_t k = 0; k < truth.size(); ++k) {
        const Estimate& one = estimates[k];
        if (one.lambda) {
            const double error = *one.lambda - truth[k].lambda;
            lambda.add(std::fabs(error) > zero_uncovered_fraction ? error : 0);
        }
        lost += one.is_found ? 0 : 1;
        if (!has_normals || !one.is_found)
            continue;
        if (truth[k].is_outermost) {
            raw_normal.add(degrees_between(one.raw_normal, truth[k].normal));
            normal.add(degrees_between(one.normal, truth[k].normal));
        }
        curvature.add(one.curvature - truth[k].curvature, truth[k].weight);
    }
    std::vector<Cell> cells = {100 * lost / static_cast<double>(truth.size())};
    for (const Spread* of : {&lambda, &raw_normal, &normal, &curvature}) {
        cells.emplace_back();
        if (of->weights > 0)
            cells.back() = of->root_mean_square();
    }
    return cells;
}

/// The surface of a cloud, with what is known of it.
template <int Dimension>
Case<Dimension> cloud_case(const KnownState<double>& known) {
    const FluidState<double>& state = known.state;
    const Cloud& cloud = known.cloud;
    Case<Dimension> made;
    made.name = state.name;
    made.positions = state.positions;
    made.lists = state.lists;
    made.candidate.resize(state.size());
    made.neighbor_count.resize(state.size());
    made.has_normals = true;
    for (std::size_t i = 0; i < state.size(); ++i)
        if (state.surface[i] != 0 && cloud.depth[i] < cloud.support_radius) // deeper are cuts
            made.add_surface(i, {state.uncovered_fraction[i], 0, false, cloud.normal[i],
                                 cloud.mean_curvature[i]});
    Estimator exact = exact_estimator();
    Work<Dimension> work;
    find_coverage(made, exact, SerialLoop{}, work);
    for (std::size_t k = 0; k < made.surface.size(); ++k) {
        const std::size_t i = made.surface[k];
        made.truth[k].weight = cloud.trusted[i] != 0 ? work.list.weight[k] : 0;
        made.truth[k].is_outermost =
            is_outermost(cloud, i) && made.truth[k].lambda > min_measured_fraction;
    }
    return made;
}

// --- table ---

/// Rows without times, and what to time for each.
struct Rows {
    const EstimatorOptions& options;
    Table& table;
    std::vector<std::size_t> particles; ///< that are timed, of each row
    std::vector<Timed> timed;           ///< two a row: one thread, all
};

template <int Dimension>
void add_row(const Case<Dimension>& some, const std::string& name, std::size_t samples,
             const std::vector<Estimate>& estimates, Rows& rows) {
    std::vector<Cell> row = {some.name, name, samples > 0 ? Cell(samples) : Cell()};
    for (const Cell& error : errors_of(some.truth, some.has_normals, estimates))
        row.push_back(error);
    rows.table.add(row);
}

void time_row(std::size_t particles, const std::function<void(int threads)>& run, Rows& rows) {
    rows.particles.push_back(particles);
    for (const int threads : {1, rows.options.threads})
        rows.timed.push_back({[run, threads] { run(threads); }});
}

/// The case with so few particles that a pass takes some hundredths of a second: what they cost
/// does not depend on how many they are.
template <int Dimension>
Case<Dimension> part_to_time(const Case<Dimension>& some, std::size_t samples) {
    constexpr std::size_t samples_of_all = 4000000;
    Case<Dimension> part = some;
    const std::size_t kept = samples_of_all / std::max(samples, std::size_t{1});
    while (part.surface.size() > std::max(kept, std::size_t{1})) {
        part.candidate[part.surface.back()] = 0;
        part.surface.pop_back();
    }
    return part;
}

template <int Dimension>
void add_estimator(const Case<Dimension>& some, Estimator& estimator,
                   const std::shared_ptr<Work<Dimension>>& work, Rows& rows) {
    add_row(some, estimator.name, estimator.samples,
            estimates_of(some, estimator, rows.options.threads), rows);
    const auto part = std::make_shared<Case<Dimension>>(part_to_time(some, estimator.samples));
    const auto run = [part, &estimator, work](int threads) {
        const auto find = [&](const auto& loop) {
            find_coverage(*part, estimator, loop, *work);
            finish(loop, *work);
        };
        with_loop(threads, find, estimator_chunk);
    };
    time_row(part->surface.size(), run, rows);
}

template <int Dimension>
std::vector<Estimate> estimates_of(const ColorFieldEstimator<Dimension>& field) {
    std::vector<Estimate> estimates;
    for (std::size_t k = 0; k < field.size(); ++k) {
        Estimate one;
        one.is_found = field.has_normal(k);
        one.raw_normal = one.normal = field.normal(k);
        one.curvature = field.curvature(k);
        estimates.push_back(one);
    }
    return estimates;
}

template <int Dimension>
void add_color_field(const Case<Dimension>& some, const FluidState<double>& state, Rows& rows) {
    const auto field = std::make_shared<ColorFieldEstimator<Dimension>>(state, some.surface);
    const auto add = [&](const char* name, const std::function<void(int threads)>& find) {
        find(1);
        add_row(some, name, 0, estimates_of(*field), rows);
        time_row(some.surface.size(), find, rows);
    };
    add("color field, Laplacian", [field](int threads) { field->find_by_laplacian(threads); });
    add("color field, divergence", [field](int threads) { field->find_by_divergence(threads); });
}

void measure_rows(Rows& rows) {
    const auto times = measure(rows.timed, rows.options.timing);
    for (std::size_t k = 0; k < rows.particles.size(); ++k) {
        auto& row = rows.table.rows[rows.table.rows.size() - rows.particles.size() + k];
        for (const std::size_t parallel : {0, 1})
            row.emplace_back(per_particle(times[2 * k + parallel], 1e-6, rows.particles[k]));
    }
}

/// All estimators on all cases of a dimension, and the color field on those that are clouds.
template <int Dimension>
void add_cases(const std::vector<Case<Dimension>>& cases,
               const std::vector<KnownState<double>>& clouds, const EstimatorOptions& options,
               Table& table) {
    std::vector<Estimator> all;
    for (const std::size_t samples : options.samples)
        for (Estimator& one : estimators<Dimension>(samples, options.threads))
            all.push_back(std::move(one));
    all.push_back(exact_estimator());
    const auto work = std::make_shared<Work<Dimension>>();
    Rows rows{options, table, {}, {}};
    for (const auto& some : cases) {
        for (Estimator& estimator : all)
            add_estimator(some, estimator, work, rows);
        for (const auto& known : clouds)
            if (known.state.name == some.name)
                add_color_field(some, known.state, rows);
    }
    measure_rows(rows);
}

} // namespace

Table coverage_estimators(const EstimatorOptions& options) {
    Table table{"coverage_estimators",
                "Estimates of coverage, normals and curvature",
                {{"case", "case"},
                 {"estimator", "estimator"},
                 {"samples", "samples", 6},
                 {"lost", "lost, %", 2},
                 {"lambda", "error of lambda"},
                 {"raw_normal", "normal, degrees"},
                 {"normal", "smoothed, degrees"},
                 {"curvature", "h kappa"},
                 {"time", "us a surface particle, 1 thread"},
                 {"time_parallel", std::to_string(options.threads) + " threads"}},
                {}};
    std::vector<KnownState<double>> solids;
    solids.push_back(known_state<double>("ball", sphere(options.ball_radius)));
    solids.push_back(known_state<double>("saddle", paraboloid(0.125, 0.125, options.saddle_width)));
    std::vector<Case<3>> cases;
    if (!options.snapshots.empty())
        cases.push_back(snapshot_case(options.snapshots, options.particles_per_snapshot));
    for (const auto& known : solids)
        cases.push_back(cloud_case<3>(known));
    add_cases(cases, solids, options, table);
    std::vector<KnownState<double>> discs;
    discs.push_back(known_state<double>("disc", circle(options.disc_radius)));
    add_cases<2>({cloud_case<2>(discs[0])}, discs, options, table);
    return table;
}

} // namespace meniscus
