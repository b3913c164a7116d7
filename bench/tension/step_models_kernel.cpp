// The step's models on a fixed state, compiled for each instruction set.
#include "step_models.hpp"

#include <meniscus/sph/scene/methods.hpp>

#include <meniscus/runtime/simd/begin_kernel.hpp>

#include "step_fluid.hpp"

#include <meniscus/sph/step/fluid_step.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

class StepModelsKernel : public StepModels {
public:
    StepModelsKernel(const StepState& state, double spacing,
                     const std::vector<StepModelKind>& kinds)
        : step(*state.positions, *state.lists, state.support_radius, state.particle_volume) {
        for (const StepModelKind& kind : kinds)
            models.push_back(model_of(kind, spacing));
    }

    void run(std::size_t model, int threads) override {
        step.fluid.loop.loop.threads = threads;
        models[model]->add_accelerations(step.fluid);
    }

    std::vector<Place> accelerations(std::size_t model) override {
        auto& rows = step.fluid.acceleration;
        std::fill(rows.begin(), rows.end(), Row<float>{});
        run(model, 1);
        const double h = step.fluid.units.support_radius;
        std::vector<Place> found;
        for (const auto& row : rows)
            found.push_back({h * static_cast<double>(row.x), h * static_cast<double>(row.y),
                             h * static_cast<double>(row.z)});
        return found;
    }

private:
    using Model = SurfaceTensionModel<float, 3>;

    StepFluid<float, 3> step;
    std::vector<std::unique_ptr<Model>> models;

    [[nodiscard]] std::unique_ptr<Model> model_of(const StepModelKind& kind, double spacing) const {
        const StepUnits& units = step.fluid.units;
        if (!kind.is_exact)
            return make_tension_model<float, 3>(kind.options, units, spacing);
        auto settings = tension_settings(kind.options, units, spacing);
        settings.coverage = CoverageMethod::exact;
        return std::make_unique<MonteCarloTension<float, 3>>(kind.options, settings);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET

std::unique_ptr<StepModels> step_models(MENISCUS_KERNEL_SET, const StepState& state, double spacing,
                                        const std::vector<StepModelKind>& kinds) {
    return std::make_unique<StepModelsKernel>(state, spacing, kinds);
}

} // namespace meniscus

#include <meniscus/runtime/simd/end_kernel.hpp>
