// Surface-tension steps on small balls, and the fluid that they run on.
#include "tension/tension_steps.hpp"

#include "data/test_folder.hpp"
#include "support/known_state.hpp"
#include "table_rows.hpp"
#include "tension/becker_force.hpp"
#include "tension/step_fluid.hpp"
#include "tension/step_models.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/sph/tension/becker_2007.hpp>

namespace meniscus {
namespace {

TEST(StepFluid, IsAboutOfTheRestDensityInside) {
    const auto ball = known_state<float>("ball", sphere(2.5));
    const StepFluid<float, 3> step(ball.state.positions, ball.state.lists, 1,
                                   ball.state.particle_volume);
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < ball.cloud.size(); ++i)
        if (ball.cloud.depth[i] > 1) {
            sum += static_cast<double>(step.fluid.density[i]);
            ++count;
        }
    EXPECT_NEAR(sum / count, 1, 0.1);
}

TEST(StepFluid, IsPulledTogetherAsAnotherLoopHasIt) {
    const auto ball = known_state<float>("ball", sphere(2), known_cloud(0.2));
    StepFluid<float, 3> step(ball.state.positions, ball.state.lists, 1, ball.state.particle_volume);
    TensionOptions options;
    options.coefficient = 1;
    BeckerTension<float, 3>(options, step.fluid.units, 0.5).add_accelerations(step.fluid);
    std::vector<BeckerRow> rows(1);
    std::vector<std::array<float, 3>> force;
    const float factor = CubicSpline<float, 3>::sigma;
    find_becker_force(ball.state.view<3>(), ball.state.size(), 1, factor, SerialLoop{}, rows.data(),
                      force);
    for (std::size_t i = 0; i < force.size(); ++i) {
        EXPECT_NEAR(step.fluid.acceleration[i].x, force[i][0], 2e-4);
        EXPECT_NEAR(step.fluid.acceleration[i].y, force[i][1], 2e-4);
        EXPECT_NEAR(step.fluid.acceleration[i].z, force[i][2], 2e-4);
    }
}

TEST(StepModels, PullAlikeWithEveryInstructionSet) {
    const auto ball = known_state<float>("ball", sphere(2), known_cloud(0.2));
    const StepState state{&ball.state.positions, &ball.state.lists, 1, ball.state.particle_volume};
    std::vector<StepModelKind> kinds;
    for (const std::string_view model : {"meniscus", "becker_2007", "akinci_2013", "color_field"}) {
        kinds.emplace_back();
        kinds.back().options.model = model;
        kinds.back().options.coefficient = 1;
    }
    kinds.push_back({kinds[0].options, true});
    const auto baseline = step_models(state, 0.5, kinds, InstructionSet::baseline);
    for (const InstructionSet set : instruction_sets) {
        const auto wide = step_models(state, 0.5, kinds, set);
        for (std::size_t model = 0; model < kinds.size(); ++model)
            EXPECT_EQ(wide->accelerations(model), baseline->accelerations(model))
                << name_of(set) << ", model " << model;
    }
    EXPECT_NE(baseline->accelerations(0), baseline->accelerations(kinds.size() - 1));
}

TensionStepOptions small_options() {
    TensionStepOptions options;
    options.ball_radius = 3;
    options.half_axes = {5, 2.5, 2.5};
    options.timing = {1, no_time};
    return options;
}

const Table& small_table() {
    static const Table table = [] {
        TensionStepOptions options = small_options();
        options.snapshots = {MENISCUS_SAMPLES "/droplet_iisph_06.vtkhdf"};
        return tension_steps(options);
    }();
    return table;
}

double figure_of(const std::string& state, const std::string& model, const std::string& key) {
    const auto rows = rows_with(small_table(), {{"state", state}, {"model", model}});
    return figure_in(small_table(), rows.at(0), key);
}

const char* const shapes[] = {"ball", "ellipsoid"};
const char* const exact = "this project, exact";
const char* const sampled[] = {"this project, 10 samples", "this project, 32 samples",
                               "this project, 128 samples"};
const char* const rivals[] = {"Becker and Teschner 2007", "Huber et al. 2015", "Akinci et al. 2013",
                              "He et al. 2014", "color field, Mueller et al. 2003"};

TEST(TensionSteps, FillTheWholeTable) {
    expect_whole(small_table());
    for (const char* const state : {"ball", "ellipsoid", "droplet_iisph_06"})
        EXPECT_EQ(rows_with(small_table(), {{"state", state}}).size(), 12U);
}

TEST(TensionSteps, PullNothingInsideWhereOurs) {
    for (const char* const shape : shapes) {
        for (const char* const model : sampled)
            EXPECT_EQ(figure_of(shape, model, "inside"), 0);
        EXPECT_EQ(figure_of(shape, exact, "inside"), 0);
        for (const char* const model : rivals)
            EXPECT_GT(figure_of(shape, model, "inside"), 0) << model;
    }
}

TEST(TensionSteps, PointInwardTheMoreSamplesTheBetter) {
    for (const char* const shape : shapes) {
        EXPECT_GT(figure_of(shape, sampled[0], "angle"), figure_of(shape, sampled[1], "angle"));
        EXPECT_GT(figure_of(shape, sampled[1], "angle"), figure_of(shape, exact, "angle"));
        for (const char* const model : rivals)
            EXPECT_GT(figure_of(shape, model, "angle"), figure_of(shape, sampled[2], "angle"));
    }
}

TEST(TensionSteps, FollowTheCurvatureWhereOurs) {
    for (const char* const model : rivals)
        EXPECT_GT(figure_of("ellipsoid", model, "local_scatter"),
                  figure_of("ellipsoid", sampled[2], "local_scatter"))
            << model;
    EXPECT_LT(figure_of("ellipsoid", exact, "local_scatter"), 0.15);
}

TEST(TensionSteps, SumUpToZeroWhereBalancedOrInPairs) {
    for (const char* const shape : shapes) {
        for (const char* const model : sampled)
            EXPECT_LT(figure_of(shape, model, "net"), 1e-6);
        for (const char* const model :
             {"Becker and Teschner 2007", "Akinci et al. 2013", "He et al. 2014"})
            EXPECT_LT(figure_of(shape, model, "net"), 1e-6) << model;
        EXPECT_GT(figure_of(shape, "this project, 128 samples, momentum not balanced", "net"),
                  1e-6);
    }
}

class FlatStates : public TestFolder {};

TEST_F(FlatStates, AreRefused) {
    Snapshot flat;
    flat.dimension = 2;
    flat.positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
    flat.support_radius = 0.2;
    write_vtkhdf(flat, folder / "flat.vtkhdf");
    TensionStepOptions options = small_options();
    options.snapshots = {folder / "flat.vtkhdf"};
    EXPECT_THROW(tension_steps(options), InputError);
}

} // namespace
} // namespace meniscus
