#include "data/test_folder.hpp"
#include "labelled_snapshots.hpp"
#include "synthetic_states.hpp"

#include <meniscus/classifier/training_set/labelled_state.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>
#include <limits>

namespace meniscus {
namespace {

using test::chain;
using test::chain_between_walls;
using test::state_of;

std::string refusal_of(const Snapshot& snapshot) {
    return error_of<InputError>([&] { labelled_state(snapshot, "folder/chain.vtkhdf"); });
}

TEST(LabelledState, HoldsTheValidParticlesInOrder) {
    const LabelledState state = labelled_state(chain(), "folder/chain_07.vtkhdf");
    EXPECT_EQ(state.file, "chain_07.vtkhdf");
    EXPECT_EQ(state.scene, "chain");
    EXPECT_EQ(state.size(), 6U);
    EXPECT_EQ(state.neighbor_count, (std::vector<double>{1, 2, 2, 2, 1, 0}));
    EXPECT_EQ(state.uncovered_fraction[5], 1);
    EXPECT_EQ(state.support_radius, 1);
    EXPECT_EQ(state.radius_ratio, 0.8);
    EXPECT_EQ(state.spacing_ratio, 2);
    EXPECT_EQ(state.count_scale, 1);
    EXPECT_EQ(bulk_neighbor_count(state), 1);
}

TEST(LabelledState, NamesTheArrayThatIsMissing) {
    for (const char* name : {"uncovered_fraction", "valid", "mass_offset", "neighbor_count"}) {
        Snapshot snapshot = chain();
        for (PointArray& array : snapshot.point_data)
            if (array.name == name)
                array.name = "other";
        const std::string error = refusal_of(snapshot);
        EXPECT_EQ(error.find("folder/chain.vtkhdf is not a labelled snapshot"), 0U) << error;
        EXPECT_NE(error.find(name), std::string::npos) << error;
        EXPECT_NE(error.find("meniscus label"), std::string::npos) << error;
    }
    Snapshot snapshot = chain();
    snapshot.provenance.clear();
    EXPECT_NE(refusal_of(snapshot).find("radius_ratio"), std::string::npos);
    snapshot = chain();
    snapshot.particle_volume.reset();
    EXPECT_NE(refusal_of(snapshot).find("particle_volume"), std::string::npos);
    snapshot = chain();
    snapshot.support_radius.reset();
    EXPECT_NE(refusal_of(snapshot).find("support radius"), std::string::npos);
}

TEST(LabelledState, RefusesValuesOutOfRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const char* name : {"uncovered_fraction", "mass_offset", "neighbor_count"})
        for (const double wrong : {nan, -1.0, 8.0, std::numeric_limits<double>::infinity()}) {
            Snapshot snapshot = chain();
            set_array(snapshot, {name, 1, std::vector<double>{0, 0, 0, wrong, 0, 0, 0}});
            const std::string error = refusal_of(snapshot);
            EXPECT_NE(error.find(std::string("'") + name + "' of particle 3"), std::string::npos)
                << error;
        }
    Snapshot snapshot = chain();
    set_array(snapshot, {"neighbor_count", 1, std::vector<float>{1, 2, 2.5, 2, 1, 0, 0}});
    EXPECT_NE(refusal_of(snapshot).find("whole numbers"), std::string::npos);
    for (const char* ratio : {"", "0", "1.5", "nan", "0.8x"}) {
        snapshot = chain();
        snapshot.provenance["radius_ratio"] = ratio;
        EXPECT_NE(refusal_of(snapshot).find("radius_ratio"), std::string::npos) << ratio;
    }
    for (const double radius : {0.0, -1.0, nan}) {
        snapshot = chain();
        snapshot.support_radius = radius;
        EXPECT_NE(refusal_of(snapshot).find("support radius"), std::string::npos) << radius;
    }
}

TEST(LabelledState, ParticlesThatAreNotValidMayHoldAnything) {
    Snapshot snapshot = chain();
    set_array(snapshot, {"mass_offset", 1,
                         std::vector<double>{0.5, 0, 0, 0, 0.5, 0,
                                             std::numeric_limits<double>::quiet_NaN()}});
    EXPECT_EQ(labelled_state(snapshot, "chain.vtkhdf").size(), 6U);
}

TEST(LabelledState, SaysByWhatWeightBoundaryParticlesCount) {
    EXPECT_FALSE(labelled_state(chain(), "chain.vtkhdf").boundary_weight); // there is none
    EXPECT_EQ(labelled_state(chain_between_walls(), "chain.vtkhdf").boundary_weight,
              test::weight_of_one);
    for (const char* weight : {"", "yes", "-1", "11", "nan"}) {
        Snapshot snapshot = chain();
        snapshot.provenance["boundary_weight"] = weight;
        const std::string error = refusal_of(snapshot);
        EXPECT_NE(error.find("'boundary_weight'"), std::string::npos) << error;
        EXPECT_NE(error.find("label the snapshot again"), std::string::npos) << error;
    }
}

TEST(LabelledState, AWallMayAddAnyNumberOfNeighbors) {
    Snapshot snapshot = chain_between_walls();
    const auto with_count = [&](double count) {
        set_array(snapshot, {"neighbor_count", 1, std::vector<double>{2, 2, 2, count, 2, 0, 0}});
        return snapshot;
    };
    EXPECT_EQ(labelled_state(with_count(19.5), "chain.vtkhdf").neighbor_count[3], 19.5);
    EXPECT_NE(refusal_of(with_count(5e9)).find("particle 3 is 5"), std::string::npos);
    snapshot.provenance["boundary_weight"] = "0";
    EXPECT_NE(refusal_of(with_count(9)).find("particle 3 is 9"), std::string::npos);
    EXPECT_NE(refusal_of(with_count(1.5)).find("whole numbers"), std::string::npos);
}

TEST(LabelledState, BulkNeighborCountNeedsCoveredParticles) {
    EXPECT_FALSE(bulk_neighbor_count(state_of("a", {{0.1, 5, 1}})));
    EXPECT_EQ(bulk_neighbor_count(state_of("a", {{0, 30, 0}, {0, 40, 0}, {0, 41, 0}, {0, 9, 1}})),
              40);
}

TEST(LabelledState, ScenesAreGroupedInOrderOfAppearance) {
    const auto groups = group_by_scene({state_of("b", {}), state_of("a", {}), state_of("b", {})});
    EXPECT_EQ(groups.names, (std::vector<std::string>{"b", "a"}));
    EXPECT_EQ(groups.of_state, (std::vector<std::size_t>{0, 1, 0}));
}

using LabelledFile = TestFolder;

TEST_F(LabelledFile, IsReadWithItsHash) {
    write_vtkhdf(chain(), folder / "chain.vtkhdf");
    const LabelledState state = read_labelled_state(folder / "chain.vtkhdf", "");
    EXPECT_EQ(state.hash.size(), 64U);
    EXPECT_EQ(state.scene, "chain");
    EXPECT_EQ(state.first, (std::vector<double>{0.5, 0, 0, 0, 0.5, 0}));
    EXPECT_EQ(read_labelled_state(folder / "chain.vtkhdf", "mine").scene, "mine");
    EXPECT_THROW(read_labelled_state(folder / "missing.vtkhdf", ""), InputError);
}

} // namespace
} // namespace meniscus
