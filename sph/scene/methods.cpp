#include "methods.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/surface/host_quantities.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

/// Of the row with that name; as many as there are rows where there is none.
template <class Row>
std::size_t place_of(const std::string& name, const std::vector<Row>& rows) {
    std::size_t place = 0;
    while (place < rows.size() && rows[place].name != name)
        ++place;
    return place;
}

template <class Row>
[[noreturn]] void refuse_name(const std::string& name, const std::vector<Row>& rows,
                              const char* kind) {
    std::string known;
    for (const Row& row : rows)
        known += (known.empty() ? "" : ", ") + std::string(row.name);
    throw InputError("there is no " + std::string(kind) + " " + quoted_text(name) + "; there are " +
                     known);
}

const TensionModelRow* row_of(const TensionOptions& options) {
    const std::size_t place = tension_model_place(options.model);
    return place < tension_models().size() ? &tension_models()[place] : nullptr;
}

} // namespace

bool has_default(const PressureKey& key) {
    const auto* number = std::get_if<double PressureOptions::*>(&key.option);
    return number == nullptr || PressureOptions().*(*number) >= key.min;
}

bool reads_key(const PressureSolverRow& solver, const std::string& key) {
    return std::find(solver.keys.begin(), solver.keys.end(), key) != solver.keys.end();
}

std::size_t pressure_solver_place(const std::string& name) {
    const std::size_t place = place_of(name, pressure_solvers());
    if (place == pressure_solvers().size())
        refuse_name(name, pressure_solvers(), "pressure solver");
    return place;
}

std::size_t tension_model_place(const std::string& name) {
    const std::size_t place = place_of(name, tension_models());
    if (place == tension_models().size() && name != "none")
        refuse_name(name, tension_models(), "model of surface tension");
    return place;
}

bool has_sigma(const TensionOptions& options) {
    const TensionModelRow* row = row_of(options);
    return row != nullptr && row->has_sigma;
}

double longest_stable_step(const Scene& scene) {
    const double step = longest_inviscid_step(scene);
    if (!(scene.viscosity.kinematic > 0))
        return step;
    const double reach = scene.support_radius / 2;
    // Half of Morris', since the sum's factor is larger.
    return std::min(step, 0.0625 * reach * reach / scene.viscosity.kinematic);
}

double longest_inviscid_step(const Scene& scene) {
    const double spacing = scene.particle_spacing;
    double step =
        pressure_solvers()[pressure_solver_place(scene.pressure.solver)].longest_stable_step(scene);
    const double sigma = scene.surface_tension.coefficient;
    if (has_sigma(scene.surface_tension) && sigma > 0)
        step = std::min(step, capillary_time_step(sigma, scene.rest_density, spacing));
    // A step that falls farther than this share of a spacing asks more of the pressure than it
    // can give back without throwing particles up.
    constexpr double falling_share = 0.075 * 0.075;
    const double gravity = std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
    if (gravity > 0)
        step = std::min(step, std::sqrt(falling_share * spacing / gravity));
    return step;
}

bool knows_surface(const TensionOptions& options) {
    const TensionModelRow* row = row_of(options);
    return row != nullptr && (row->finds_surface || options.restrict_to_surface);
}

} // namespace meniscus
