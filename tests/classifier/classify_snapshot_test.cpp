#include "data/expected_errors.hpp"
#include "labelled_snapshots.hpp"

#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

using test::chain;
using test::chain_between_walls;
using test::chain_model;

TEST(ClassifySnapshot, MatchesTheExampleWorkedOutByHand) {
    const Classes classes = classify_snapshot(chain(), chain_model(), {true, 1});
    EXPECT_EQ(classes.surface, (std::vector<std::uint8_t>{1, 0, 0, 0, 1, 1, 0}));
    EXPECT_EQ(classes.valid, (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 1, 0}));
    EXPECT_EQ(classes.neighbor_count, (std::vector<double>{1, 2, 2, 2, 1, 0, 0}));
    EXPECT_TRUE(classes.warnings.empty());
}

TEST(ClassifySnapshot, RefusesOrDoubtsPlacesFarOutInFloat) {
    const auto moved = [](double distance) {
        Snapshot snapshot = chain();
        snapshot.position_precision = Precision::float32;
        for (auto& position : snapshot.positions)
            position[1] += distance * *snapshot.support_radius;
        return snapshot;
    };
    const Model model = chain_model();
    EXPECT_TRUE(classify_snapshot(moved(100), model, {true, 1}).warnings.empty());
    const auto doubted = classify_snapshot(moved(1e4), model, {true, 1}).warnings;
    ASSERT_EQ(doubted.size(), 1U);
    expect_mentions(doubted[0], {"particle 0", "single precision", "doubtful"});
    EXPECT_EQ(classify_snapshot(moved(1e6), model, {true, 1}).valid,
              std::vector<std::uint8_t>(moved(0).size(), 0));
    Snapshot all_finite = moved(1e6);
    all_finite.positions.back() = all_finite.positions.front();
    expect_mentions(error_of<InputError>([&] {
                        classify_snapshot(all_finite, model, {false, 1});
                    }),
                    {"lie so far from the origin that single precision", "--skip-invalid"});
}

TEST(ClassifySnapshot, WorksInTwoDimensions) {
    Snapshot snapshot = chain();
    snapshot.dimension = 2;
    Model model = chain_model();
    EXPECT_THROW(classify_snapshot(snapshot, model, {true, 1}), InputError);
    model.dimension = 2;
    EXPECT_EQ(classify_snapshot(snapshot, model, {true, 1}).surface,
              (std::vector<std::uint8_t>{1, 0, 0, 0, 1, 1, 0}));
}

TEST(ClassifySnapshot, CountsTheBoundaryWhereTheModelDoes) {
    Model model = chain_model();
    const Snapshot snapshot = chain_between_walls();
    EXPECT_EQ(classify_snapshot(snapshot, model, {true, 1}).surface,
              (std::vector<std::uint8_t>{1, 0, 0, 0, 1, 1, 0}));
    model.boundary_weight = test::weight_of_one;
    for (const int dimension : {2, 3}) {
        Snapshot walled = snapshot;
        walled.dimension = dimension;
        walled.particle_volume = dimension == 2 ? 7.0 / 40 : 0.125; // for weights of 1
        model.dimension = dimension;
        const Classes classes = classify_snapshot(walled, model, {true, 1});
        EXPECT_EQ(classes.surface, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 0}));
        for (std::size_t i = 0; i < walled.size(); ++i)
            EXPECT_NEAR(classes.neighbor_count[i], i < 5 ? 2 : 0, 1e-12);
        EXPECT_TRUE(classes.warnings.empty());
    }
    const Classes bare = classify_snapshot(chain(), model, {true, 1});
    EXPECT_EQ(bare.surface, (std::vector<std::uint8_t>{1, 0, 0, 0, 1, 1, 0}));
}

TEST(ClassifySnapshot, RefusesABoundaryThatItCannotCount) {
    Snapshot snapshot = chain_between_walls();
    snapshot.boundary[1][2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NO_THROW(classify_snapshot(snapshot, chain_model(), {true, 1}));
    Model model = chain_model();
    model.boundary_weight = test::weight_of_one;
    expect_mentions(error_of<InputError>([&] {
                        classify_snapshot(snapshot, model, {true, 1});
                    }),
                    {"boundary particle 1", "not finite"});
}

TEST(ClassifySnapshot, CountsPositionsThatAreNotFinite) {
    expect_mentions(error_of<InputError>([] { classify_snapshot(chain(), chain_model(), {}); }),
                    {"1 of 7 particles", "particle 6"});
}

TEST(ClassifySnapshot, RefusesWhatItCannotUse) {
    Snapshot snapshot = chain();
    snapshot.support_radius.reset();
    EXPECT_THROW(classify_snapshot(snapshot, chain_model(), {true, 1}), InputError);
    snapshot = chain();
    set_array(snapshot, {"mass", 1, std::vector<double>{1, 1, 0, 1, 1, 1, 1}});
    EXPECT_THROW(classify_snapshot(snapshot, chain_model(), {true, 1}), InputError);
}

TEST(ClassifySnapshot, WarnsOutsideTheTrainedRange) {
    Model model = chain_model();
    model.bulk_neighbor_count = Range{26, 43};
    const Classes classes = classify_snapshot(chain(), model, {true, 1});
    ASSERT_EQ(classes.warnings.size(), 1U);
    EXPECT_NE(classes.warnings[0].find("is 2 and was 26 to 43"), std::string::npos)
        << classes.warnings[0];
}

TEST(Predict, FloatAndDoubleFollowTheirOwnRounding) {
    Model model = chain_model();
    model.line = {0, 2 - 1e-9}; // in float that is 2
    const Snapshot snapshot = chain();
    const auto neighborhoods = find_neighborhoods(snapshot, 1, {1, 1, 1, 1, 1, 1, 0}, false, 1);
    EXPECT_EQ(predict(model, snapshot, neighborhoods, Precision::float64).surface[2], 0);
    EXPECT_EQ(predict(model, snapshot, neighborhoods, Precision::float32).surface[2], 1);
}

} // namespace
} // namespace meniscus
