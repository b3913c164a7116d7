#include <meniscus/sph/step_headers.hpp>

#include "comparison/tension_steps.hpp"

#include "becker_force.hpp"
#include "comparison/known_state.hpp"
#include "comparison/loops.hpp"
#include "comparison/per_particle.hpp"
#include "comparison/step_fluid.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/sph/fluid_step.hpp>

#include <cmath>
#include <functional>
#include <numeric>

namespace meniscus {
namespace {

using Model = SurfaceTensionModel<float, 3>;

/// A model as it is listed.
struct Contender {
    std::string name;
    std::string group;
    std::function<std::unique_ptr<Model>(const StepUnits&)> make;
};

Contender rival(const std::string& name, TensionModel model) {
    return {name, "rivals", [model](const StepUnits& units) {
                TensionOptions options;
                options.model = model;
                options.coefficient = 1;
                return make_tension_model<float, 3>(options, units, 1 / known_spacing_ratio);
            }};
}

using Change = std::function<void(TensionOptions&, SurfaceTensionOptions&)>;

/// The project's model, as scenes have it but for a change.
Contender ours(const std::string& name, const Change& change) {
    return {name, "this project", [change](const StepUnits& units) {
                TensionOptions options;
                options.coefficient = 1;
                auto settings = tension_settings<3>(options, units, 1 / known_spacing_ratio);
                change(options, settings);
                return std::make_unique<MonteCarloTension<float, 3>>(options, settings);
            }};
}

Contender ours_with_samples(std::size_t samples) {
    return ours("this project, " + std::to_string(samples) + " samples",
                [samples](TensionOptions&, SurfaceTensionOptions& settings) {
                    settings.samples = samples;
                });
}

/// As published, sampled by a table of this project, with its line: what the article says of both.
Contender paper() {
    return {"2020 paper's options", "this project", [](const StepUnits& units) {
                TensionOptions options;
                options.coefficient = 1;
                options.paper = true;
                options.balance_momentum = false;
                return std::make_unique<MonteCarloTension<float, 3>>(options, units,
                                                                     1 / known_spacing_ratio);
            }};
}

std::vector<Contender> contenders() {
    return {
        ours_with_samples(10),
        ours_with_samples(32),
        ours_with_samples(128),
        ours("this project, exact",
             [](TensionOptions&, SurfaceTensionOptions& settings) {
                 settings.exposure.method = CoverageMethod::exact;
             }),
        ours("this project, 128 samples, momentum not balanced",
             [](TensionOptions& options, SurfaceTensionOptions&) {
                 options.balance_momentum = false;
             }),
        paper(),
        rival("Becker and Teschner 2007", TensionModel::becker_2007),
        rival("Huber et al. 2015", TensionModel::huber_2015),
        rival("Akinci et al. 2013", TensionModel::akinci_2013),
        rival("He et al. 2014", TensionModel::he_2014),
        rival("color field, Mueller et al. 2003", TensionModel::color_field),
    };
}

using Forces = std::vector<Vector3>;

/// A model on a state, one thread count after another.
struct Run {
    StepFluid<float, 3>& step;
    std::shared_ptr<Model> model;

    /// Adds to the accelerations over and over: they grow, which nothing depends on.
    void operator()(int threads) const {
        step.fluid.loop.loop.threads = threads;
        model->add_accelerations(step.fluid);
    }

    /// Of one call; particles all have the same mass.
    [[nodiscard]] Forces forces() const {
        auto& rows = step.fluid.acceleration;
        std::fill(rows.begin(), rows.end(), Row<float>{});
        (*this)(1);
        Forces forces;
        for (const auto& row : rows)
            forces.push_back({static_cast<double>(row.x), static_cast<double>(row.y),
                              static_cast<double>(row.z)});
        return forces;
    }
};

double length(const Vector3& vector) {
    return std::sqrt(dot(vector, vector));
}

double sum_of_lengths(const Forces& forces) {
    return std::accumulate(forces.begin(), forces.end(), 0.0,
                           [](double sum, const Vector3& force) { return sum + length(force); });
}

double net_part(const Forces& forces) {
    Vector3 net = {0, 0, 0};
    for (const Vector3& force : forces)
        net = sum(net, force);
    return length(net) / sum_of_lengths(forces);
}

double part_inside(const Cloud& cloud, const Forces& forces) {
    double inside = 0;
    for (std::size_t i = 0; i < forces.size(); ++i)
        inside += cloud.depth[i] > cloud.support_radius ? length(forces[i]) : 0;
    return inside / sum_of_lengths(forces);
}

std::vector<std::size_t> outermost_layer(const Cloud& cloud) {
    std::vector<std::size_t> layer;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (is_outermost(cloud, i))
            layer.push_back(i);
    return layer;
}

/// Mean angle to the inward normal in degrees; forces that are zero have none.
double mean_angle(const Cloud& cloud, const std::vector<std::size_t>& layer, const Forces& forces) {
    double angles = 0;
    std::size_t count = 0;
    for (const std::size_t i : layer) {
        const double size = length(forces[i]);
        if (size == 0)
            continue;
        const double cosine = -dot(forces[i], cloud.normal[i]) / size;
        angles += std::acos(std::min(std::max(cosine, -1.0), 1.0)) * 180 / pi;
        ++count;
    }
    return angles / static_cast<double>(count);
}

/// Root mean square of values less what is wanted, after scaling them to its mean, over that mean.
double scatter_of(const std::vector<double>& values, const std::vector<double>& wanted) {
    const double scale = std::accumulate(wanted.begin(), wanted.end(), 0.0) /
                         std::accumulate(values.begin(), values.end(), 0.0);
    double squares = 0;
    double mean = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double difference = scale * values[k] - wanted[k];
        squares += difference * difference;
        mean += wanted[k];
    }
    const auto count = static_cast<double>(values.size());
    return std::sqrt(squares / count) / std::fabs(mean / count);
}

/// For each particle of the layer the mean of values, one for each of the layer, over those of the
/// layer that are its neighbors and itself.
std::vector<double> local_means(const NeighborLists& lists, const std::vector<std::size_t>& layer,
                                const std::vector<double>& values) {
    constexpr auto nowhere = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> place(lists.offsets.size() - 1, nowhere);
    for (std::size_t k = 0; k < layer.size(); ++k)
        place[layer[k]] = k;
    std::vector<double> means;
    for (std::size_t k = 0; k < layer.size(); ++k) {
        double sum = values[k];
        double count = 1;
        for (std::size_t n = lists.offsets[layer[k]]; n < lists.offsets[layer[k] + 1]; ++n)
            if (const std::size_t other = place[lists.neighbors[n]]; other != nowhere) {
                sum += values[other];
                ++count;
            }
        means.push_back(sum / count);
    }
    return means;
}

/// Angle, scatter, local scatter and part inside.
std::vector<Cell> errors_of(const KnownState<float>& known, const Forces& forces) {
    const Cloud& cloud = known.cloud;
    const auto layer = outermost_layer(cloud);
    std::vector<double> inward;
    std::vector<double> curvature;
    for (const std::size_t i : layer) {
        inward.push_back(-dot(forces[i], cloud.normal[i]));
        curvature.push_back(cloud.mean_curvature[i]);
    }
    const NeighborLists& lists = known.state.lists;
    return {mean_angle(cloud, layer, forces), scatter_of(inward, curvature),
            scatter_of(local_means(lists, layer, inward), local_means(lists, layer, curvature)),
            part_inside(cloud, forces)};
}

/// The force of Becker and Teschner over the lists of runtime/, a plain loop for each particle: how
/// much of the step's times is the step's.
std::function<void(int threads)> plain_becker(const FluidState<float>& state, int threads) {
    struct Memory {
        std::vector<BeckerRow> rows;
        std::vector<std::array<float, 3>> force;
    };
    const auto memory = std::make_shared<Memory>();
    memory->rows.resize(static_cast<std::size_t>(threads));
    return [&state, memory](int run_threads) {
        with_loop(run_threads, [&](const auto& loop) {
            find_becker_force(state.view<3>(), state.size(), state.support_radius, 1, loop,
                              memory->rows.data(), memory->force);
        });
    };
}

/// What is shown of a state: rows without times, and what to time for each.
struct StateRows {
    std::vector<std::vector<Cell>> rows;
    std::vector<std::function<void(int threads)>> runs;
};

StateRows rows_of(const FluidState<float>& state, const KnownState<float>* known,
                  StepFluid<float, 3>& step, int threads) {
    StateRows made;
    const auto add = [&](const std::string& name, const std::string& group,
                         const std::vector<Cell>& errors) {
        std::vector<Cell> row = {state.name, static_cast<double>(state.size()), name, group, {},
                                 {}};
        row.insert(row.end(), errors.begin(), errors.end());
        made.rows.push_back(row);
    };
    for (const Contender& contender : contenders()) {
        const Run run{step, contender.make(step.fluid.units)};
        const Forces forces = run.forces();
        std::vector<Cell> errors(4);
        if (known != nullptr)
            errors = errors_of(*known, forces);
        errors.emplace_back(net_part(forces));
        add(contender.name, contender.group, errors);
        made.runs.emplace_back(run);
    }
    add("Becker and Teschner 2007, over the runtime's lists", "rivals", std::vector<Cell>(5));
    made.runs.push_back(plain_becker(state, threads));
    return made;
}

void add_state(const FluidState<float>& state, const KnownState<float>* known,
               const TensionStepOptions& options, Table& table) {
    if (state.dimension != 3)
        throw InputError(state.name + ": is in 2D; surface-tension steps are compared in 3D");
    StepFluid<float, 3> step(state);
    StateRows made = rows_of(state, known, step, options.threads);
    std::vector<Timed> timed;
    for (const auto& run : made.runs)
        for (const int threads : {1, options.threads})
            timed.push_back({[&run, threads] { run(threads); }});
    const auto times = measure(timed, options.timing);
    const std::size_t time = table.column("time");
    for (std::size_t k = 0; k < made.rows.size(); ++k) {
        made.rows[k][time] = per_particle(times[2 * k], 1e-9, state.size());
        made.rows[k][time + 1] = per_particle(times[2 * k + 1], 1e-9, state.size());
        table.rows.push_back(made.rows[k]);
    }
}

} // namespace

Table tension_steps(const TensionStepOptions& options) {
    Table table{
        "tension_steps",
        "Surface-tension steps",
        {{"state", "state"},
         {"particles", "particles", 6},
         {"model", "model"},
         {"group", "group"},
         {"time", "ns a particle, 1 thread"},
         {"time_parallel", "ns a particle, " + std::to_string(options.threads) + " threads"},
         {"angle", "angle to the normal, degrees"},
         {"scatter", "scatter of the force"},
         {"local_scatter", "scatter of its mean within h"},
         {"inside", "part deeper than h", 2},
         {"net", "net force", 2}},
        {}};
    const auto ball = known_state<float>("ball", sphere(options.ball_radius));
    add_state(ball.state, &ball, options, table);
    const auto stretched = known_state<float>("ellipsoid", ellipsoid(options.half_axes));
    add_state(stretched.state, &stretched, options, table);
    for (const auto& file : options.snapshots)
        add_state(read_fluid_state<float>(file), nullptr, options, table);
    return table;
}

} // namespace meniscus
