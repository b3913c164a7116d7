// A scene that runs step by step, with its state as arrays.
#include "module.hpp"
#include "snapshots.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <meniscus/app/scene_model.hpp>
#include <meniscus/sph/step/simulation.hpp>

#include <mutex>

namespace meniscus {
namespace {

using namespace py::literals;

/// Serves one thread at a time; others wait, without the interpreter's lock.
class SharedSimulation {
public:
    SharedSimulation(const std::filesystem::path& file, const std::string& variant,
                     const std::vector<std::string>& changes, int threads) {
        const std::lock_guard<std::mutex> alone(file_access());
        scene = read_scene(file, variant, changes);
        use_model_file(scene);
        simulation = simulate(scene, fill_scene(scene), threads);
    }

    /// What `use` returns of the simulation, without the interpreter's lock.
    template <class Use>
    auto with(const Use& use) {
        const py::gil_scoped_release released;
        const std::lock_guard<std::mutex> alone(access);
        return use(*simulation);
    }

    Scene scene;

private:
    std::unique_ptr<Simulation> simulation;
    std::mutex access;
};

py::dict step(SharedSimulation& self, double longest) {
    const StepReport report =
        self.with([&](Simulation& simulation) { return simulation.step(longest); });
    return py::dict("time"_a = report.time, "time_step"_a = report.time_step,
                    "pressure_iterations"_a = report.pressure_iterations,
                    "divergence_iterations"_a = report.divergence_iterations,
                    "density_error"_a = report.density_error,
                    "divergence_error"_a = report.divergence_error,
                    "converged"_a = report.converged, "max_speed"_a = report.max_speed,
                    "surface_particles"_a = report.surface_particles);
}

/// Places or velocities in the order of ids.
py::array_t<double> places(SharedSimulation& self, Positions SimulationState::*member) {
    Positions sorted = self.with([&](const Simulation& simulation) {
        const SimulationState state = simulation.state();
        Positions by_id(state.ids.size());
        for (std::size_t i = 0; i < by_id.size(); ++i)
            by_id[state.ids[i]] = (state.*member)[i];
        return by_id;
    });
    return array_of(std::move(sorted));
}

py::dict snapshot(SharedSimulation& self) {
    return snapshot_to_python(
        self.with([](const Simulation& simulation) { return simulation.snapshot(); }));
}

} // namespace

void add_simulation(py::module_& module) {
    py::class_<SharedSimulation>(module, "Simulation")
        .def(py::init<const std::filesystem::path&, const std::string&,
                      const std::vector<std::string>&, int>(),
             py::call_guard<py::gil_scoped_release>())
        .def("step", step)
        .def("snapshot", snapshot)
        .def_property_readonly(
            "time",
            [](SharedSimulation& self) {
                return self.with([](const Simulation& simulation) { return simulation.time(); });
            })
        .def_property_readonly(
            "size",
            [](SharedSimulation& self) {
                return self.with([](const Simulation& simulation) { return simulation.size(); });
            })
        .def_property_readonly(
            "positions",
            [](SharedSimulation& self) { return places(self, &SimulationState::positions); })
        .def_property_readonly(
            "velocities",
            [](SharedSimulation& self) { return places(self, &SimulationState::velocities); })
        .def_property_readonly("name", [](const SharedSimulation& self) { return self.scene.name; })
        .def_property_readonly("duration",
                               [](const SharedSimulation& self) { return self.scene.duration; })
        .def_property_readonly("dimension",
                               [](const SharedSimulation& self) { return self.scene.dimension; });
}

} // namespace meniscus
