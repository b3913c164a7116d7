// Droplets without gravity under surface tension, in Markdown.
//   formation        a cube becomes a ball: ours in several settings
//   formation_paper  the same with the 27,000 particles of Huber et al. 2015
//   line             the same with the line of the plain fit, before the shift
//   rest             what keeps that ball moving
//   rivals           the same cube with the other models and Huber's coefficients
//   coalescence      two cubes become one ball, ours and the rivals
//   oscillation      period of a stretched droplet beside Lamb's, in 3D and 2D
// Usage: droplets TABLE SCENES    SCENES: the folder configs/scenes
// And the line of a plain fit, before the shift, as a model file: droplets plain_line OUT
// LABELLED...
#include "droplet_runs.hpp"

#include <meniscus/classifier/torch_plugin.hpp>
#include <meniscus/classifier/trainer.hpp>
#include <meniscus/data/text.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

namespace meniscus {
namespace {

using Folder = std::filesystem::path;
using Changes = std::vector<std::string>;

struct Row {
    std::string name;
    Changes changes; ///< of the scene (read_scene)
};

void print_head(const char* first) {
    fmt::print("| {} | radius, m | deviation, % | rms speed, m/s | of the capillary speed, % | at "
               "rest after, s | aspect ratio | net momentum |\n"
               "|---|---|---|---|---|---|---|---|\n",
               first);
}

void print_run(const std::string& name, const Scene& scene) {
    const DropletRun run = run_droplet(scene);
    if (!run.summary.failure.empty()) {
        const double end = run.summary.time_step * static_cast<double>(run.summary.steps);
        fmt::print("| {} | diverged after {:.2f} s | | | | | | |\n", name, end);
        return;
    }
    fmt::print(
        "| {} | {:.4f} | {:.2f} | {:.4f} | {} | {} | {:.3f} | {:.0e} |\n", name, run.radius,
        100 * run.deviation, run.speed,
        run.capillary_speed > 0 ? fmt::format("{:.2f}", 100 * run.speed / run.capillary_speed) : "",
        run.equilibrium ? fmt::format("{:.2f}", *run.equilibrium) : "not reached", run.aspect_ratio,
        run.summary.largest_momentum);
    std::fflush(stdout);
}

void print_rows(const Folder& file, const std::string& variant, const std::vector<Row>& rows) {
    for (const Row& row : rows)
        print_run(row.name, read_scene(file, variant, row.changes));
}

/// The changes that put a model file's line in place of the one that ships.
Changes line_of(const Folder& file) {
    const Line line = read_model(file).line;
    return {"surface_tension.k=" + number_text(line.k), "surface_tension.d=" + number_text(line.d)};
}

Changes joined(Changes changes, const Changes& more) {
    changes.insert(changes.end(), more.begin(), more.end());
    return changes;
}

const Changes few_samples = {"surface_tension.samples=10", "surface_tension.verify=false"};

void print_formation(const Folder& scenes) {
    print_head("setting");
    print_rows(
        scenes / "drop_formation.json", "",
        {{"128 samples, verified", {}},
         {"10 samples, verified", {"surface_tension.samples=10"}},
         {"128 samples, not verified", {"surface_tension.verify=false"}},
         {"10 samples, not verified", few_samples},
         {"all of the paper's choices", {"surface_tension.paper=true"}},
         {"the same, 10 samples", {"surface_tension.paper=true", "surface_tension.samples=10"}}});
}

/// At the two spacings a support radius that lines are trained at.
void print_plain_line(const Folder& scenes) {
    const Changes ratio = {"support_radius=0.1"};
    const Changes plain = joined(ratio, line_of(scenes / "../models/plain_logistic_3d.json"));
    const Changes unverified = {"surface_tension.verify=false"};
    const Changes paper = {"surface_tension.paper=true"};
    print_head("line and setting");
    print_rows(scenes / "drop_formation.json", "",
               {{"shifted, 128 samples, verified", ratio},
                {"plain fit, 128 samples, verified", plain},
                {"shifted, 128 samples, not verified", joined(ratio, unverified)},
                {"plain fit, 128 samples, not verified", joined(plain, unverified)},
                {"shifted, 10 samples, not verified", joined(ratio, few_samples)},
                {"plain fit, 10 samples, not verified", joined(plain, few_samples)},
                {"shifted, all of the paper's choices", joined(ratio, paper)},
                {"plain fit, all of the paper's choices", joined(plain, paper)}});
}

void print_formation_paper(const Folder& scenes) {
    print_head("setting");
    print_rows(scenes / "drop_formation.json", "paper", {{"128 samples, verified", {}}});
}

void print_rest(const Folder& scenes) {
    print_head("setting");
    std::vector<Row> rows = {
        {"as it ships", {}},
        {"512 samples", {"surface_tension.samples=512"}},
        {"2048 samples", {"surface_tension.samples=2048"}},
        {"every particle a candidate", {"surface_tension.k=0", "surface_tension.d=1000"}},
        {"ten iterations at least", {"pressure.least_iterations=10"}},
        {"density error 0.001 %", {"pressure.density_error=0.00001"}},
        {"step of 0.5 ms", {"time_step.fixed=0.0005"}},
        {"viscosity 0.05 m^2/s", {"viscosity.kinematic=0.05"}},
        {"XSPH 0.05", {"viscosity.xsph=0.05"}}};
    for (Row& row : rows) {
        row.name += ", h = 2 spacings";
        row.changes.push_back("support_radius=0.1");
    }
    print_rows(scenes / "drop_formation.json", "", {{"as it ships, h = 2.5 spacings", {}}});
    print_rows(scenes / "drop_formation.json", "", rows);
}

/// A rival as Huber et al. run it.
Row rival(const std::string& name, const std::string& model, const std::string& coefficient) {
    return {name + ", " + coefficient,
            {R"(surface_tension={"model": ")" + model + R"(", "coefficient": )" + coefficient + "}",
             "kernel=mueller", "viscosity.density_correction=true"}};
}

void print_rivals(const Folder& scenes) {
    print_head("model and coefficient");
    const Folder file = scenes / "drop_formation.json";
    print_rows(file, "", {{"ours, sigma 600", {}}});
    for (const char* phi : {"0.02", "0.05", "0.08"})
        print_rows(file, "", {rival("Becker 2007", "becker_2007", phi)});
    for (const char* phi : {"0.02", "0.05", "0.08"})
        print_rows(file, "", {rival("Huber 2015", "huber_2015", phi)});
    for (const char* gamma : {"0.2", "0.6", "1.0"})
        print_rows(file, "", {rival("Akinci 2013", "akinci_2013", gamma)});
    for (const char* kappa : {"0.2", "1.0", "1.8"})
        print_rows(file, "", {rival("He 2014", "he_2014", kappa)});
    print_rows(file, "", {rival("color field, sigma", "color_field", "600")});
}

void print_coalescence(const Folder& scenes) {
    print_head("model and coefficient");
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
    for (Row& row : rows) {
        row.changes.push_back("viscosity.kinematic=0.1");
        row.changes.push_back("duration=6");
    }
    print_rows(scenes / "double_droplet.json", "", rows);
}

struct NamedSolver {
    const char* name;
    PressureSolverKind kind;
};

std::string period_text(const Oscillation& found) {
    if (!found.failure.empty())
        return "diverged |";
    if (found.period == 0)
        return "none |";
    return fmt::format("{:.3f} | {:+.1f}", found.period, 100 * (found.period / found.theory - 1));
}

struct NamedForce {
    const char* name;
    bool paper;
    double sigma; ///< over that for a period of 1 s
};

void print_oscillation(int dimension, int resolution, const NamedForce& force) {
    constexpr std::array<NamedSolver, 4> solvers = {{{"WCSPH", PressureSolverKind::wcsph},
                                                     {"PCISPH", PressureSolverKind::pcisph},
                                                     {"IISPH", PressureSolverKind::iisph},
                                                     {"DFSPH", PressureSolverKind::dfsph}}};
    for (const NamedSolver& solver : solvers) {
        Scene scene = stretched_droplet(dimension, resolution);
        scene.pressure.solver = solver.kind;
        scene.surface_tension.paper = force.paper;
        scene.surface_tension.coefficient *= force.sigma;
        scene.duration /= std::sqrt(force.sigma);
        const Oscillation found = watch_oscillation(scene);
        fmt::print("| {} | R / {} | {} | {} | {} | {:.1f} | {:.3f} | {} |\n", dimension, resolution,
                   found.particles, force.name, solver.name, scene.surface_tension.coefficient,
                   found.theory, period_text(found));
        std::fflush(stdout);
    }
}

void print_oscillations() {
    constexpr NamedForce calibrated = {"calibrated", false, 1};
    constexpr NamedForce paper = {"the paper's", true, 1};
    constexpr NamedForce weak_paper = {"the paper's", true, 0.1};
    fmt::print("| dimension | spacing | particles | force | solver | sigma | Lamb's period, s | "
               "measured | off, % |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const int dimension : {3, 2}) {
        for (const NamedForce& force : {calibrated, paper, weak_paper})
            print_oscillation(dimension, 10, force);
        print_oscillation(dimension, dimension == 3 ? 15 : 20, calibrated);
    }
}

/// Writes the line of the logistic fit as it is: a model without the shift.
void write_plain_line(const Folder& out, const std::vector<std::string>& labelled) {
    std::vector<LabelledState> states;
    for (const std::string& file : labelled)
        states.push_back(read_labelled_state(file, ""));
    TrainingOptions options;
    options.objective = "logistic";
    Model model = train(states, options);
    model.line = fit_with_torch(options.objective, states, options.label_threshold, options.seed);
    model.objective = "logistic, not shifted";
    model.d_margin = 0;
    model.false_negatives = 0;
    model.false_positives = 0;
    for (const SceneErrors& scene : count_errors(states, model.line, options.label_threshold)) {
        model.false_negatives += scene.false_negatives;
        model.false_positives += scene.false_positives;
    }
    std::ofstream(out) << model_to_json(model);
}

void print_table(const std::string& table, const Folder& scenes) {
    if (table == "formation")
        print_formation(scenes);
    else if (table == "line")
        print_plain_line(scenes);
    else if (table == "formation_paper")
        print_formation_paper(scenes);
    else if (table == "rest")
        print_rest(scenes);
    else if (table == "rivals")
        print_rivals(scenes);
    else if (table == "coalescence")
        print_coalescence(scenes);
    else if (table == "oscillation")
        print_oscillations();
    else
        throw std::runtime_error("no table " + table);
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        const std::vector<std::string> words(arguments + 1, arguments + argument_count);
        if (words.size() > 2 && words[0] == "plain_line")
            meniscus::write_plain_line(words[1], {words.begin() + 2, words.end()});
        else if (words.size() == 2)
            meniscus::print_table(words[0], words[1]);
        else
            throw std::runtime_error("usage: droplets TABLE SCENES\n"
                                     "       droplets plain_line OUT LABELLED...");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "droplets: %s\n", error.what());
        return 2;
    }
    return 0;
}
