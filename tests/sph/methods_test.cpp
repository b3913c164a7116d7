// The rows of pressure solvers and surface-tension models: what a scene may say of each.
#include <meniscus/sph/scene/methods.hpp>

#include "data/test_folder.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

class Methods : public TestFolder {
protected:
    /// A scene with those sections, read and written as canonical JSON.
    Json text_of(const Json& pressure, const Json& tension) const {
        return Json::parse(scene_text(read_scene(file_with(pressure, tension), "")));
    }

    std::string error_with(const Json& pressure, const Json& tension) const {
        const auto file = file_with(pressure, tension);
        return error_of<InputError>([&] { read_scene(file, ""); });
    }

private:
    std::filesystem::path file_with(const Json& pressure, const Json& tension) const {
        const Json body = {{"box", {{"low", {0, 0, 0}}, {"high", {1, 1, 1}}}}};
        const Json scene = {{"name", "some"},
                            {"particle_spacing", 0.1},
                            {"duration", 1},
                            {"frame_interval", 1},
                            {"fluid", Json::array({body})},
                            {"pressure", pressure},
                            {"surface_tension", tension}};
        return write("some.json", scene.dump());
    }
};

/// A value that the key may have and that is not its default.
Json some_value(const PressureKey& key) {
    if (const auto* truth = std::get_if<bool PressureOptions::*>(&key.option))
        return !(PressureOptions().*(*truth));
    if (std::holds_alternative<int PressureOptions::*>(key.option))
        return 7;
    return 0.25;
}

/// The section that names the solver, with the keys that have no default.
Json smallest_pressure(const PressureSolverRow& solver) {
    Json section = {{"solver", solver.name}};
    for (const PressureKey& key : pressure_keys)
        if (reads_key(solver, key.name) && !has_default(key))
            section[key.name] = some_value(key);
    return section;
}

const Json becker = {{"model", "becker_2007"}, {"coefficient", 1}};

TEST_F(Methods, EachKeyOfASolverIsTakenAndEachOtherRefused) {
    for (const PressureSolverRow& solver : pressure_solvers())
        for (const PressureKey& key : pressure_keys) {
            Json section = smallest_pressure(solver);
            section[key.name] = some_value(key);
            if (reads_key(solver, key.name))
                EXPECT_EQ(text_of(section, becker)["pressure"][key.name], some_value(key))
                    << solver.name << ", " << key.name;
            else
                expect_mentions(error_with(section, becker),
                                {key.name, "it has no meaning for solver", solver.name});
        }
}

TEST_F(Methods, SolversReadKeysThatThereAre) {
    for (const PressureSolverRow& solver : pressure_solvers())
        for (const std::string& key : solver.keys)
            EXPECT_EQ(std::count_if(std::begin(pressure_keys), std::end(pressure_keys),
                                    [&](const PressureKey& other) { return other.name == key; }),
                      1)
                << solver.name << ", " << key;
}

TEST_F(Methods, ASolverNeedsTheKeyThatHasNoDefault) {
    expect_mentions(error_with({{"solver", "wcsph"}}, becker), {"sound_speed", "missing"});
    EXPECT_EQ(pressure_solvers()[pressure_solver_place("wcsph")].longest_stable_step([] {
        Scene scene;
        scene.support_radius = 0.2;
        scene.pressure.sound_speed = 40;
        return scene;
    }()),
              0.4 * 0.2 / 40);
}

TEST_F(Methods, ForcesOfAModelThatFindsNoSurfaceCanBeRestrictedToIt) {
    for (const TensionModelRow& model : tension_models()) {
        const Json section = {
            {"model", model.name}, {"coefficient", 1}, {"restrict_to_surface", true}};
        const Json pressure = {{"solver", "dfsph"}};
        if (model.finds_surface)
            expect_mentions(error_with(pressure, section), {"restrict_to_surface", "always does"});
        else
            EXPECT_EQ(text_of(pressure, section)["surface_tension"]["restrict_to_surface"], true);
        TensionOptions options;
        options.model = model.name;
        EXPECT_EQ(knows_surface(options), model.finds_surface);
        EXPECT_EQ(has_sigma(options), model.has_sigma);
        options.restrict_to_surface = true;
        EXPECT_TRUE(knows_surface(options));
    }
}

TEST_F(Methods, NoneIsAModelOfNoTension) {
    EXPECT_EQ(tension_model_place("none"), tension_models().size());
    EXPECT_FALSE(has_sigma({}));
    TensionOptions none;
    none.restrict_to_surface = true; // which is of no forces
    EXPECT_FALSE(knows_surface(none));
}

TEST_F(Methods, UnknownNamesAreRefusedWithTheKnownOnes) {
    expect_mentions(error_of<InputError>([] { pressure_solver_place("sph"); }),
                    {"pressure solver 'sph'", "wcsph, pcisph, iisph, dfsph"});
    expect_mentions(error_of<InputError>([] { tension_model_place("akinci"); }),
                    {"model of surface tension 'akinci'", "akinci_2013"});
}

} // namespace
} // namespace meniscus
