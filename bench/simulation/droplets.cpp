// Droplets without gravity under surface tension: a cube that becomes a ball, ours in several
// settings and with the other models and Huber's coefficients, two cubes that become one ball, and
// the period of a stretched droplet beside Lamb's.
#include "droplet_runs.hpp"
#include "solvers.hpp"
#include "support/tables.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/surface/option_table.hpp>

#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

using Path = std::filesystem::path;
using Changes = std::vector<std::string>;

struct Row {
    std::string name;
    Changes changes; ///< of the scene (read_scene)
};

std::vector<Cell> row_of(const std::string& name, const Scene& scene) {
    const DropletRun run = run_droplet(scene);
    if (!run.summary.failure.empty()) {
        const double end = run.summary.time_step * static_cast<double>(run.summary.steps);
        return {name, fmt::format("diverged after {:.2f} s", end), "", "", "", "", "", ""};
    }
    return {name,
            run.radius,
            100 * run.deviation,
            run.speed,
            run.capillary_speed > 0 ? Cell(100 * run.speed / run.capillary_speed) : Cell(""),
            run.equilibrium ? Cell(*run.equilibrium) : Cell("not reached"),
            run.aspect_ratio,
            run.summary.max_momentum};
}

Tables table_of_runs(const char* name, const char* first, const Path& file,
                     const std::vector<Row>& rows, const char* variant = "") {
    Table table = table_of(name, std::string(first) +
                                     " | radius, m {:.4f} | deviation, % {:.2f} | rms speed, m/s "
                                     "{:.4f} | of the capillary speed, % {:.2f} | at rest after, s "
                                     "{:.2f} | aspect ratio {:.3f} | net momentum {:.0e}");
    for (const Row& row : rows)
        table.add(row_of(row.name, read_scene(file, variant, row.changes)));
    return {table};
}

Path cube(const TableInput& input) {
    return input.scenes / "drop_formation.json";
}

/// The changes that put a model file's line in place of the one that ships.
Changes line_of(const Path& file) {
    const Model model = read_model(file);
    check_features_of_paper(model, "a scene");
    const Line line = model.line;
    return {"surface_tension.k=" + number_text(line.k), "surface_tension.d=" + number_text(line.d)};
}

Changes joined(Changes changes, const Changes& more) {
    changes.insert(changes.end(), more.begin(), more.end());
    return changes;
}

const Changes few_samples = {"surface_tension.samples=10", "surface_tension.verification=drop"};

Tables formation(const TableInput& input) {
    return table_of_runs(
        "formation", "setting", cube(input),
        {{"128 samples, verified", {}},
         {"10 samples, verified", {"surface_tension.samples=10"}},
         {"128 samples, not verified", {"surface_tension.verification=drop"}},
         {"10 samples, not verified", few_samples},
         {"all of the paper's choices", {"surface_tension.paper=true"}},
         {"the same, 10 samples", {"surface_tension.paper=true", "surface_tension.samples=10"}}});
}

Tables formation_paper(const TableInput& input) {
    return table_of_runs("formation-paper", "setting", cube(input), {{"128 samples, verified", {}}},
                         "paper");
}

/// At the two spacings a support radius that lines are trained at.
Tables plain_line(const TableInput& input) {
    const Changes ratio = {"support_radius=0.1"};
    const Changes plain = joined(ratio, line_of(input.models / "plain_logistic_3d.json"));
    const Changes unverified = {"surface_tension.verification=drop"};
    const Changes paper = {"surface_tension.paper=true"};
    return table_of_runs("formation-line", "line and setting", cube(input),
                         {{"shifted, 128 samples, verified", ratio},
                          {"plain fit, 128 samples, verified", plain},
                          {"shifted, 128 samples, not verified", joined(ratio, unverified)},
                          {"plain fit, 128 samples, not verified", joined(plain, unverified)},
                          {"shifted, 10 samples, not verified", joined(ratio, few_samples)},
                          {"plain fit, 10 samples, not verified", joined(plain, few_samples)},
                          {"shifted, all of the paper's choices", joined(ratio, paper)},
                          {"plain fit, all of the paper's choices", joined(plain, paper)}});
}

/// What keeps the ball moving.
Tables rest(const TableInput& input) {
    std::vector<Row> rows = {
        {"as it ships", {}},
        {"512 samples", {"surface_tension.samples=512"}},
        {"2048 samples", {"surface_tension.samples=2048"}},
        {"every particle a candidate", {"surface_tension.k=0", "surface_tension.d=1000"}},
        {"ten iterations at least", {"pressure.min_iterations=10"}},
        {"density error 0.001 %", {"pressure.density_error=0.00001"}},
        {"step of 0.5 ms", {"time_step.fixed=0.0005"}},
        {"viscosity 0.05 m^2/s", {"viscosity.kinematic=0.05"}},
        {"XSPH 0.05", {"viscosity.xsph=0.05"}}};
    for (Row& row : rows) {
        row.name += ", h = 2 spacings";
        row.changes.push_back("support_radius=0.1");
    }
    rows.insert(rows.begin(), {"as it ships, h = 2.5 spacings", {}});
    return table_of_runs("rest", "setting", cube(input), rows);
}

/// A rival as Huber et al. run it.
Row rival(const std::string& name, const std::string& model, const std::string& coefficient) {
    return {name + ", " + coefficient,
            {R"(surface_tension={"model": ")" + model + R"(", "coefficient": )" + coefficient + "}",
             "kernel=mueller", "viscosity.density_correction=true"}};
}

Tables rivals(const TableInput& input) {
    std::vector<Row> rows = {{"ours, sigma 600", {}}};
    for (const char* phi : {"0.02", "0.05", "0.08"})
        rows.push_back(rival("Becker 2007", "becker_2007", phi));
    for (const char* phi : {"0.02", "0.05", "0.08"})
        rows.push_back(rival("Huber 2015", "huber_2015", phi));
    for (const char* gamma : {"0.2", "0.6", "1.0"})
        rows.push_back(rival("Akinci 2013", "akinci_2013", gamma));
    for (const char* kappa : {"0.2", "1.0", "1.8"})
        rows.push_back(rival("He 2014", "he_2014", kappa));
    rows.push_back(rival("color field, sigma", "color_field", "600"));
    return table_of_runs("rivals", "model and coefficient", cube(input), rows);
}

Tables coalescence(const TableInput& input) {
    std::vector<Row> rows = {
        {"ours, sigma 1500", {}},
        {"ours, sigma 1500, 10 samples, not verified", few_samples},
        {"all of the paper's choices, sigma 1500", {"surface_tension.paper=true"}},
        rival("Becker 2007", "becker_2007", "0.05"),
        rival("Huber 2015", "huber_2015", "0.05"),
        rival("Akinci 2013", "akinci_2013", "0.6"),
        rival("He 2014", "he_2014", "1.0"),
        rival("color field, sigma", "color_field", "150")};
    // With the scene's 0.01 m^2/s the ball goes on swinging for half a minute, as it should.
    for (Row& row : rows)
        row.changes.insert(row.changes.end(), {"viscosity.kinematic=0.1", "duration=6"});
    return table_of_runs("coalescence", "model and coefficient",
                         input.scenes / "double_droplet.json", rows);
}

struct NamedForce {
    const char* name;
    bool paper;
    double sigma; ///< over that for a period of 1 s
};

void add_oscillations(int dimension, int resolution, const NamedForce& force, Table& table) {
    for (const NamedSolver& solver : all_solvers) {
        Scene scene = stretched_droplet(dimension, resolution);
        scene.pressure.solver = solver.kind;
        if (force.paper)
            scene.surface_tension.surface = paper_options();
        scene.surface_tension.coefficient *= force.sigma;
        scene.duration /= std::sqrt(force.sigma);
        const Oscillation found = watch_oscillation(scene);
        std::vector<Cell> row = {
            dimension,   fmt::format("R / {}", resolution), found.particles, force.name,
            solver.name, scene.surface_tension.coefficient, found.theory,    "none",
            ""};
        if (!found.failure.empty())
            row[7] = "diverged";
        else if (found.period > 0) {
            row[7] = found.period;
            row[8] = 100 * (found.period / found.theory - 1);
        }
        table.add(row);
    }
}

Tables oscillation(const TableInput&) {
    constexpr NamedForce calibrated = {"calibrated", false, 1};
    constexpr NamedForce paper = {"the paper's", true, 1};
    constexpr NamedForce weak_paper = {"the paper's", true, 0.1};
    Table table =
        table_of("oscillation", "dimension | spacing | particles | force | solver | sigma {:.1f} | "
                                "Lamb's period, s {:.3f} | measured {:.3f} | off, % {:+.1f}");
    for (const int dimension : {3, 2}) {
        for (const NamedForce& force : {calibrated, paper, weak_paper})
            add_oscillations(dimension, 10, force, table);
        add_oscillations(dimension, dimension == 3 ? 15 : 20, calibrated, table);
    }
    return {table};
}

} // namespace

TableGroup droplet_tables() {
    return {"Droplets",
            {{"formation", "", 0, "a cube becomes a ball: ours in several settings", formation},
             {"formation-paper", "", 0, "the same with the 27,000 particles of Huber et al. 2015",
              formation_paper},
             {"formation-line", "", 0, "the same with the line of the plain fit, before the shift",
              plain_line},
             {"rest", "", 0, "what keeps that ball moving", rest},
             {"rivals", "", 0, "the same cube with the other models", rivals},
             {"coalescence", "", 0, "two cubes become one ball, ours and the rivals", coalescence},
             {"oscillation", "", 0, "period of a stretched droplet beside Lamb's", oscillation}}};
}

} // namespace meniscus
