#include <meniscus/sph/fluid/neighbor_lists.hpp>

#include "sample_fluids.hpp"

namespace meniscus {
namespace {

template <class SettingType>
class PairSums : public testing::Test {
public:
    using Real = typename SettingType::Real;
    static constexpr int dimension = SettingType::dimension;
    using Sample = SampleFluid<Real, dimension>;

    /// A jittered ball with wall particles of various volumes through its lower part.
    static PlainFluid ball_on_wall(KernelKind kernel, double h) {
        PlainFluid plain = lattice_ball(dimension, kernel, h, 0.3);
        RandomNumbers random(3);
        for (int n = 0; n < 60; ++n) {
            Place wall = product_of(1.5 * h, random.vector(dimension));
            wall[1] = -0.9 * h;
            plain.walls.push_back(wall);
            plain.wall_volumes.push_back((0.6 + 0.3 * random()) *
                                         std::pow(plain.spacing, dimension));
        }
        return plain;
    }

    /// Calls body(plain, sample) for fluids with and without walls.
    template <class Body>
    static void for_each_fluid(const Body& body) {
        for (const KernelKind kind : all_kernels)
            for (const double h : {0.125, 40.0})
                for (const bool walls : {false, true}) {
                    PlainFluid plain =
                        walls ? ball_on_wall(kind, h) : lattice_ball(dimension, kind, h, 0.3);
                    Sample sample(plain);
                    body(plain, sample);
                }
    }

    static constexpr double tolerance = SettingType::tolerance;
};
TYPED_TEST_SUITE(PairSums, Settings);

/// Sum over the walls of rho_0 V_b grad W_ib.
Place plain_wall_gradient(const PlainFluid& plain, std::size_t i) {
    Place sum{};
    for (std::size_t b = 0; b < plain.walls.size(); ++b)
        sum = sum_of(sum, product_of(plain.rest_density * plain.wall_volumes[b],
                                     plain.kernel().gradient(
                                         difference_of(plain.positions[i], plain.walls[b]))));
    return sum;
}

TYPED_TEST(PairSums, DensityIsTheSumOverAllPairs) {
    this->for_each_fluid([&](const PlainFluid& plain, auto& sample) {
        const std::vector<double> expected = densities_of(plain);
        PlainFluid without_walls = plain;
        without_walls.walls.clear();
        const std::vector<double> fluid_part = densities_of(without_walls);
        const auto& fluid = sample.fluid;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            const double tolerance = this->tolerance * expected[i] / plain.rest_density;
            EXPECT_NEAR(fluid.density[i], expected[i] / plain.rest_density, tolerance);
            EXPECT_NEAR(fluid.wall_density[i], (expected[i] - fluid_part[i]) / plain.rest_density,
                        tolerance);
            EXPECT_EQ(fluid.velocity[i].w, fluid.density[i]);
        }
    });
}

TYPED_TEST(PairSums, PressureAccelerationIsTheSumOverAllPairs) {
    using Real = typename TypeParam::Real;
    this->for_each_fluid([&](const PlainFluid& plain, auto& sample) {
        RandomNumbers random(5);
        // p / rho^2 in m^5/(kg s^2) and in the step's units
        const double unit = plain.h * plain.h / plain.rest_density;
        std::vector<double> pressure;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            pressure.push_back(rounded_in_step<Real>((1 + random()) * unit, unit));
            sample.fluid.place[i].w = static_cast<Real>(pressure[i] / unit);
        }
        std::vector<Place> expected(plain.size());
        for (std::size_t i = 0; i < plain.size(); ++i) {
            plain.visit(i, [&](std::size_t j) {
                expected[i] =
                    sum_of(expected[i], product_of(-plain.mass * (pressure[i] + pressure[j]),
                                                   plain.kernel().gradient(plain.x_ij(i, j))));
            });
            expected[i] =
                sum_of(expected[i], product_of(-pressure[i], plain_wall_gradient(plain, i)));
        }
        const double max = max_over(expected);
        for (std::size_t i = 0; i < plain.size(); ++i) {
            const Place found = sample.in_metres(pressure_acceleration(sample.fluid, i));
            EXPECT_LT(length_of(difference_of(found, expected[i])), this->tolerance * max);
        }
    });
}

TYPED_TEST(PairSums, CompressionRateIsTheSumOverAllPairs) {
    this->for_each_fluid([&](const PlainFluid& plain, auto& sample) {
        std::vector<double> expected;
        double max = 0;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            double rate = dot_of(plain.velocities[i], plain_wall_gradient(plain, i));
            plain.visit(i, [&](std::size_t j) {
                rate += plain.mass * dot_of(difference_of(plain.velocities[i], plain.velocities[j]),
                                            plain.kernel().gradient(plain.x_ij(i, j)));
            });
            expected.push_back(rate / plain.rest_density);
            max = std::max(max, std::abs(expected[i]));
        }
        for (std::size_t i = 0; i < plain.size(); ++i)
            EXPECT_NEAR(compression_rate(sample.fluid, sample.fluid.velocity, i), expected[i],
                        this->tolerance * max);
    });
}

template <class SettingType>
class NeighborListsOfStep : public testing::Test {
public:
    using Real = typename SettingType::Real;
    static constexpr int dimension = SettingType::dimension;

    static std::vector<Row<Real>> rows_of(const Positions& places) {
        std::vector<Row<Real>> rows(places.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            rows[i] = {static_cast<Real>(places[i][0]), static_cast<Real>(places[i][1]),
                       static_cast<Real>(places[i][2]), 0};
        return rows;
    }

    /// By the arithmetic of the lists, so that no rounding tells them apart.
    static bool are_neighbors(const Row<Real>& a, const Row<Real>& b) {
        const Real x = a.x - b.x;
        const Real y = a.y - b.y;
        const Real z = a.z - b.z;
        return (x * x + y * y) + z * z < 1;
    }

    /// Sorts places into cells, finds lists for them and for others, and compares with all pairs.
    static void expect_all_pairs(const Positions& places, const Positions& others) {
        const ParticleLoop loop{StretchLoop{2}};
        const std::size_t count = places.size();
        const std::vector<Row<Real>> rows = rows_of(places);
        Cells<Real> cells;
        std::vector<std::uint32_t> cell_of;
        std::vector<std::uint32_t> order;
        sort_into_cells(rows.data(), count, loop.loop, cell_of, cells, order);
        expect_permutation(order, count);
        std::vector<Row<Real>> sorted;
        for (const std::uint32_t i : order)
            sorted.push_back(rows[i]);
        cells.take_coordinates(sorted.data(), count);

        ListBuffers buffers;
        LaneLists lists;
        const auto far = static_cast<std::uint32_t>(count);
        find_lists<Real, dimension>(cells, sorted.data(), count, true, far, loop, buffers, lists);
        expect_lists(lists, sorted, sorted, true);

        const std::vector<Row<Real>> other_rows = rows_of(others);
        ListBuffers other_buffers;
        LaneLists other_lists;
        find_lists<Real, dimension>(cells, other_rows.data(), others.size(), false, far, loop,
                                    other_buffers, other_lists);
        expect_lists(other_lists, sorted, other_rows, false);
    }
    static void expect_all_pairs(const Positions& places) { expect_all_pairs(places, places); }

    static Positions random_places(std::size_t count, double extent, unsigned seed) {
        RandomNumbers random(seed);
        Positions places;
        for (std::size_t i = 0; i < count; ++i)
            places.push_back(product_of(extent, random.vector(dimension)));
        return places;
    }

private:
    static void expect_permutation(std::vector<std::uint32_t> order, std::size_t count) {
        ASSERT_EQ(order.size(), count);
        std::sort(order.begin(), order.end());
        for (std::uint32_t i = 0; i < count; ++i)
            ASSERT_EQ(order[i], i);
    }

    static void expect_lists(const LaneLists& lists, const std::vector<Row<Real>>& rows,
                             const std::vector<Row<Real>>& centers, bool self) {
        ASSERT_EQ(lists.begin.size(), centers.size());
        for (std::size_t i = 0; i < centers.size(); ++i) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t j = 0; j < rows.size(); ++j)
                if ((!self || i != j) && are_neighbors(centers[i], rows[j]))
                    expected.push_back(j);
            const std::uint32_t* const begin = lists.begin[i];
            std::vector<std::uint32_t> found(begin, begin + lists.count[i]);
            std::sort(found.begin(), found.end());
            ASSERT_EQ(found, expected) << "place " << i;
            ASSERT_EQ(lists.padded_count(i) % lane_count, 0U);
            for (std::uint32_t n = lists.count[i]; n < lists.padded_count(i); ++n)
                ASSERT_EQ(begin[n], rows.size());
        }
    }
};
TYPED_TEST_SUITE(NeighborListsOfStep, Settings);

TYPED_TEST(NeighborListsOfStep, OfRandomPlaces) {
    for (unsigned seed = 0; seed < 5; ++seed)
        for (const double extent : {0.3, 2.0, 30.0})
            this->expect_all_pairs(this->random_places(700, extent, seed));
}

TYPED_TEST(NeighborListsOfStep, AroundPlacesOfOthers) {
    // Some of them beyond all cells.
    this->expect_all_pairs(this->random_places(700, 2, 1), this->random_places(300, 4, 2));
    this->expect_all_pairs({}, this->random_places(300, 4, 2));
    this->expect_all_pairs(this->random_places(700, 2, 1), {});
}

TYPED_TEST(NeighborListsOfStep, OfALatticeOfHalfTheRadius) {
    // Those two spacings apart lie at the radius exactly, or beside it by rounding.
    for (const double spacing : {0.5, 0.05 / 0.1, 0.5 * (1 - 1e-7), 0.1 * 5.000001}) {
        Positions places;
        for (int x = 0; x < 12; ++x)
            for (int y = 0; y < 12; ++y)
                for (int z = 0; z < (this->dimension == 3 ? 12 : 1); ++z)
                    places.push_back({0.1 + spacing * x, -3.7 + spacing * y,
                                      this->dimension == 3 ? 0.33 + spacing * z : 0});
        this->expect_all_pairs(places);
    }
}

TYPED_TEST(NeighborListsOfStep, OfALatticeWhoseRoundedRadiusIsTwoSpacings) {
    // Places as a scene has them, over h: 0.04 m apart, h = 0.08 m.
    Positions places;
    for (int x = 0; x < 30; ++x)
        for (int y = 0; y < 30; ++y)
            places.push_back({(-0.86 + 0.04 * x) / 0.08, (0.09 + 0.04 * y) / 0.08, 0});
    this->expect_all_pairs(places);
}

TYPED_TEST(NeighborListsOfStep, OfParticlesInOnePlace) {
    this->expect_all_pairs(Positions(300, Place{0.4, -0.2, 0}));
    Positions places = this->random_places(100, 1, 4);
    const Positions again = places;
    for (int n = 0; n < 3; ++n)
        places.insert(places.end(), again.begin(), again.end());
    this->expect_all_pairs(places);
}

TYPED_TEST(NeighborListsOfStep, OfTwoClustersFarApart) {
    Positions places = this->random_places(200, 1, 5);
    for (const Place& place : this->random_places(200, 1, 6))
        places.push_back(sum_of(place, {1e6, 0, 0}));
    this->expect_all_pairs(places);
    for (std::size_t i = 200; i < 400; ++i)
        places[i] = sum_of(places[i], {0, -1e6, this->dimension == 3 ? 1e6 : 0});
    this->expect_all_pairs(places);
}

TYPED_TEST(NeighborListsOfStep, OfOneParticleAndOfNone) {
    this->expect_all_pairs({{0.3, 0.2, 0}});
    this->expect_all_pairs({});
}

} // namespace
} // namespace meniscus
