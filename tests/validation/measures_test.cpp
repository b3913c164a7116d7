// What studies measure, on series and shapes with known answers.
#include "framework/measures.hpp"
#include "jet_growth/rayleigh_rate.hpp"
#include "liquid_crown/crown_shape.hpp"
#include "water_glass/glass_shape.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A lattice of so many particles a radius in the ball, or disk, of radius 1.
Positions ball(int dimension, int resolution) {
    Positions places;
    const int deep = dimension == 3 ? resolution : 0;
    for (int i = -resolution; i <= resolution; ++i)
        for (int j = -resolution; j <= resolution; ++j)
            for (int k = -deep; k <= deep; ++k)
                if (i * i + j * j + k * k <= resolution * resolution)
                    places.push_back({static_cast<double>(i) / resolution,
                                      static_cast<double>(j) / resolution,
                                      static_cast<double>(k) / resolution});
    return places;
}

TEST(Measures, MeanAndDeviationKeepTheirDigits) {
    const auto spread = mean_and_deviation({1e9 + 1, 1e9 + 3});
    EXPECT_EQ(spread.mean, 1e9 + 2);
    EXPECT_EQ(spread.deviation, 1);
}

TEST(Measures, InsideLeavesTheRimOut) {
    const Positions places = {{1, 0, 0}, {3, 0, 0}, {2, 0.5, 0}, {2, -0.5, 0}};
    EXPECT_EQ(inside(places, {100, 100, 5, 7}, 0.9).mean, 6);
}

TEST(Measures, TheOrderIsThatOfThePower) {
    std::vector<double> lengths = {0.1, 0.05, 0.02};
    std::vector<double> errors;
    for (const double length : lengths)
        errors.push_back(3 * std::pow(length, 1.7));
    EXPECT_NEAR(convergence_order(lengths, errors), 1.7, 1e-12);
}

/// The outermost place in direction x of a disk in a mode.
double reach(const Positions& places) {
    double most = 0;
    for (const Place& place : places)
        most = std::max(most, place[0]);
    return most;
}

TEST(Measures, AModeMovesTheSurfaceAndNoOther) {
    for (const int dimension : {2, 3})
        for (const int mode : {2, 3, 4}) {
            const Positions rest = ball(dimension, 12);
            const Positions places = in_mode(rest, mode, 0.05, 1, dimension);
            EXPECT_NEAR(reach(places), 1.05, 1e-12) << dimension << " " << mode;
            // The integral of (r^n P_n) over the shell that the mode adds, over the volume.
            const double exact = dimension == 3 ? 3 * 0.05 / (2 * mode + 1) : 0.05;
            for (const int other : {2, 3, 4}) {
                const double change =
                    mode_moment(places, other, dimension) - mode_moment(rest, other, dimension);
                EXPECT_NEAR(change, other == mode ? exact : 0, 0.15 * exact)
                    << dimension << " " << mode << " " << other;
            }
        }
}

TEST(Measures, ASwingHasItsPeriodAndDamping) {
    std::vector<double> times;
    std::vector<double> values;
    for (int n = 0; n <= 120; ++n) {
        times.push_back(n / 40.0 * 0.7);
        values.push_back(std::exp(-0.2 * times.back()) * std::cos(2 * pi * times.back() / 0.7));
    }
    const Swing swing = swing_of(times, values);
    EXPECT_EQ(swing.zeros, 6U);
    EXPECT_NEAR(swing.period, 0.7, 1e-3);
    EXPECT_NEAR(swing.left, std::exp(-0.2 * 0.7), 1e-2);
    EXPECT_EQ(swing_of({0, 1, 2}, {1, 2, 3}).period, 0);
}

TEST(Measures, MaximaAreThoseThatStandOut) {
    EXPECT_EQ(local_maxima({}, 0.1), 0);
    EXPECT_EQ(local_maxima({0, 1, 2, 3}, 0.1), 0); // still rising
    EXPECT_EQ(local_maxima({0, 5, 2, 4, 1}, 0.1), 2);
    EXPECT_EQ(local_maxima({0, 5, 4.9, 4.95, 1}, 0.1), 1); // noise is none
    std::vector<double> wave;
    for (int n = 0; n < 100; ++n)
        wave.push_back(1 - std::cos(2 * pi * n / 25));
    EXPECT_EQ(local_maxima(wave, 0.05), 4);
}

TEST(Measures, ALimitCountsOnceItIsKept) {
    EXPECT_EQ(stays_below({0, 1, 2, 3}, {9, 1, 9, 1}, 2), 3);
    EXPECT_EQ(stays_below({0, 1, 2, 3}, {1, 1, 1, 1}, 2), 0);
    EXPECT_FALSE(stays_below({0, 1}, {1, 3}, 2));
}

TEST(Measures, ClustersAreParticlesWithACloseNeighbor) {
    EXPECT_EQ(share_closer({{0, 0, 0}, {0.1, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0.5), 0.5);
}

TEST(Measures, ACrownIsAsSteepAsItsWall) {
    Positions cone; // opens upward by as much as it rises
    for (int level = -3; level < 5; ++level)
        for (int n = 0; n < 8; ++n)
            cone.push_back({(2.0 + level) * std::cos(n), static_cast<double>(level),
                            (2.0 + level) * std::sin(n)});
    EXPECT_NEAR(crown_slope(cone, 0.5), 45, 1e-9);
    for (auto& place : cone)
        place = {3, place[1], 0};
    EXPECT_NEAR(crown_slope(cone, 0.5), 90, 1e-9);
}

TEST(JetGrowth, TheFastestWaveIsNineRadiiLong) {
    double fastest = 0;
    for (double kr = 0.3; kr < 1; kr += 0.001)
        if (rayleigh_rate(kr) > rayleigh_rate(fastest))
            fastest = kr;
    EXPECT_NEAR(fastest, 0.697, 0.0011);
    EXPECT_NEAR(2 * 3.14159265358979 / fastest, 9.01, 0.02);
    EXPECT_EQ(rayleigh_rate(1), 0); // as long as the jet is round
}

const Glass some_glass{1, 1.2, 2, 3};

TEST(WaterGlass, AJetIsItsLargestBodyAndTheRestAreDroplets) {
    Positions positions = {{0, 1.9, 0}, {0, 3.1, 0}}; // in the glass, in the channel
    for (int k = 0; k < 8; ++k)
        positions.push_back({0, 2.1 + 0.1 * k, 0});
    positions.push_back({0.5, 2.5, 0});
    positions.push_back({0.55, 2.5, 0});
    positions.push_back({-0.5, 2.5, 0});
    const Jet jet = jet_of(positions, some_glass, 0.15);
    EXPECT_EQ(jet.particles, 11U);
    EXPECT_EQ(jet.largest, 8U);
    EXPECT_EQ(jet.droplets, 2U);
    EXPECT_EQ(jet_of({}, some_glass, 0.15).particles, 0U);
    EXPECT_EQ(in_glass(positions, some_glass), 1U);
}

/// A lattice that fills the glass up to a surface whose height is 1 within half the radius, and
/// `rise` higher at the wall.
Positions filled(double spacing, double rise) {
    Positions positions;
    const int reach = static_cast<int>(1.3 / spacing);
    for (int i = -reach; i <= reach; ++i)
        for (int k = -reach; k <= reach; ++k)
            for (int j = 0; spacing * j < 2; ++j) {
                const Place place = {spacing * i, spacing * (j + 0.5), spacing * k};
                const double r = std::hypot(place[0], place[2]);
                const double wall = some_glass.radius_at(place[1]);
                const double top = r > wall - 3 * spacing ? 1 + rise : 1.0;
                if (r < wall && place[1] + spacing / 2 < top + 1e-9)
                    positions.push_back(place);
            }
    return positions;
}

TEST(WaterGlass, LevelAndRiseAreThoseOfTheFill) {
    constexpr double spacing = 0.05;
    for (const double rise : {-0.1, 0.0, 0.1}) {
        Positions positions = filled(spacing, rise);
        positions.push_back({0, 1.8, 0}); // a droplet above is no level
        const auto level = level_in(positions, some_glass, spacing, 2.01 * spacing);
        ASSERT_TRUE(level);
        EXPECT_NEAR(level->height, 1, 1e-9);
        EXPECT_NEAR(level->rise_at_wall, rise, 1e-9);
    }
    EXPECT_FALSE(level_in({}, some_glass, spacing, 0.1));
    EXPECT_FALSE(level_in({{0, 1, 0}}, some_glass, spacing, 0.1)); // nothing at the wall
}

TEST(WaterGlass, AWallThatIsWetDrawsTheSurfaceUp) {
    EXPECT_NEAR(rise_at_plane(90, 3), 0, 1e-9);
    EXPECT_NEAR(rise_at_plane(30, 3), 3, 1e-9); // sqrt(2 (1 - 1/2))
    EXPECT_NEAR(rise_at_plane(150, 3), -3, 1e-9);
}

} // namespace
} // namespace meniscus
