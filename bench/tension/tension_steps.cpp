#include "tension_steps.hpp"

#include "step_models.hpp"
#include "support/known_state.hpp"

#include <meniscus/runtime/math/angles.hpp>
#include <meniscus/runtime/math/vector3.hpp>
#include <meniscus/runtime/surface/option_table.hpp>

#include <cmath>
#include <limits>
#include <numeric>

namespace meniscus {
namespace {

/// A model as it is listed.
struct Contender {
    std::string name;
    std::string group;
    StepModelKind kind;
};

/// The project's model, as scenes have it.
Contender ours(const std::string& how) {
    Contender made{"this project, " + how, "this project", {}};
    made.kind.options.model = "meniscus";
    made.kind.options.coefficient = 1;
    return made;
}

Contender ours_with_samples(int samples) {
    Contender made = ours(std::to_string(samples) + " samples");
    made.kind.options.surface.samples = static_cast<std::size_t>(samples);
    return made;
}

Contender ours_exact() {
    Contender made = ours("exact");
    made.kind.is_exact = true;
    return made;
}

/// Candidates that no sample finds uncovered are dropped.
Contender ours_unverified() {
    Contender made = ours("128 samples, not verified");
    made.kind.options.surface.verification = Verification::drop;
    return made;
}

Contender ours_unbalanced() {
    Contender made = ours("128 samples, momentum not balanced");
    made.kind.options.balance_momentum = false;
    return made;
}

/// The article's method, with this project's line and outward directions.
Contender paper() {
    Contender made = ours_unbalanced();
    made.name = "2020 paper's options, 128 samples";
    made.kind.options.surface = paper_options();
    return made;
}

Contender rival(const std::string& name, std::string_view model) {
    Contender made{name, "rivals", {}};
    made.kind.options.model = model;
    made.kind.options.coefficient = 1;
    return made;
}

const std::vector<Contender>& contenders() {
    static const std::vector<Contender> all = {
        ours_with_samples(10),
        ours_with_samples(32),
        ours_with_samples(128),
        ours_exact(),
        ours_unverified(),
        ours_unbalanced(),
        paper(),
        rival("Becker and Teschner 2007", "becker_2007"),
        rival("Huber et al. 2015", "huber_2015"),
        rival("Akinci et al. 2013", "akinci_2013"),
        rival("He et al. 2014", "he_2014"),
        rival("color field, Mueller et al. 2003", "color_field"),
    };
    return all;
}

/// Accelerations stand for them: particles all have the same mass.
using Forces = std::vector<Vector3>;

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

/// Of a state of which nothing is known.
const std::vector<Cell> no_errors(4);

void add_state(const FluidState<float>& state, const KnownState<float>* known,
               const TensionStepOptions& options, Table& table) {
    std::vector<StepModelKind> kinds;
    for (const Contender& contender : contenders())
        kinds.push_back(contender.kind);
    const auto models =
        step_models({&state.positions, &state.lists, state.support_radius, state.particle_volume},
                    1 / known_spacing_ratio, kinds);
    std::vector<Timed> timed;
    for (std::size_t model = 0; model < kinds.size(); ++model)
        for (const int threads : {1, options.threads})
            timed.push_back({[&models, model, threads] { models->run(model, threads); }});
    const auto times = measure(timed, options.timing);
    for (std::size_t model = 0; model < kinds.size(); ++model) {
        const Forces forces = models->accelerations(model);
        std::vector<Cell> row = {state.name, static_cast<double>(state.size()),
                                 contenders()[model].name, contenders()[model].group};
        for (const std::size_t parallel : {0, 1})
            row.emplace_back(per_particle(times[2 * model + parallel], 1e-9, state.size()));
        for (const Cell& error : known != nullptr ? errors_of(*known, forces) : no_errors)
            row.push_back(error);
        row.emplace_back(net_part(forces));
        table.rows.push_back(row);
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
        add_state(read_fluid_state_in_3d<float>(file), nullptr, options, table);
    return table;
}

} // namespace meniscus
