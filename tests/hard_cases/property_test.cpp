// What must hold for any neighborhood, tried on thousands of random ones, those that once went
// wrong first.
#include "found_failures.hpp"
#include "neighborhoods.hpp"

#include <meniscus/labeler/monte_carlo/coverage.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <gtest/gtest.h>
#include <numeric>

namespace meniscus::test {
namespace {

constexpr double radius_ratio = 0.8;
/// Rounding moves lambda by no more; where many circles all but coincide, by this (exact_coverage).
constexpr double lambda_band = 1e-7;

class Properties : public testing::TestWithParam<int> {
protected:
    [[nodiscard]] static int dimension() { return GetParam(); }

    /// Calls property(neighborhood) for those that once failed, and then for `trials` new ones.
    template <class Property>
    static void for_neighborhoods(std::uint64_t first, std::uint64_t trials,
                                  const Property& property) {
        const auto run = [&](std::uint64_t number) {
            property(neighborhood(dimension(), number));
            return !HasFatalFailure();
        };
        for (const FoundFailure& found : found_failures)
            if (found.dimension == dimension() && !run(found.number))
                return;
        for (std::uint64_t trial = 0; trial < trials; ++trial)
            if (!run(first + trial))
                return;
    }
};

std::vector<Vector3> that_count(const Neighborhood& all) {
    const auto range = neighbor_range<double>(1, radius_ratio);
    std::vector<Vector3> counted;
    for (const Vector3& x : all.neighbors)
        if (range.contains(dot(x, x)))
            counted.push_back(x);
    return counted;
}

/// False where a neighbor lies so close to a limit that rounding decides whether it counts.
bool is_clear_of_limits(const Neighborhood& all) {
    const auto is_near = [](double value, double limit) {
        return std::abs(value - limit) < 1e-12 * limit;
    };
    return std::none_of(all.neighbors.begin(), all.neighbors.end(), [&](const Vector3& x) {
        const double distance = std::sqrt(dot(x, x));
        return is_near(distance, 1 - neighbor_band) ||
               is_near(distance, (1 - radius_ratio) * (1 + neighbor_band));
    });
}

UncoveredPart exact_part(int dimension, const std::vector<Vector3>& neighbors) {
    static const CoverageCells cells;
    static ExactCoverage coverage;
    coverage.caps.clear();
    for (const Vector3& x : neighbors)
        if (dimension == 2)
            add_cap<2>(coverage.caps, x, 1, radius_ratio);
        else
            add_cap<3>(coverage.caps, x, 1, radius_ratio);
    return dimension == 2 ? uncovered_part<2>(cells, coverage) : uncovered_part<3>(cells, coverage);
}

double lambda_of(int dimension, const std::vector<Vector3>& neighbors) {
    return exact_part(dimension, neighbors).fraction;
}

/// What is covered stays covered, and what is open by more than rounding stays open.
void expect_same_label(double lambda, double other, const std::string& what) {
    ASSERT_NEAR(lambda, other, lambda_band) << what;
    if (lambda == 0) {
        ASSERT_LE(other, zero_uncovered_fraction) << what;
    }
    if (lambda > zero_uncovered_fraction + lambda_band) {
        ASSERT_GT(other, zero_uncovered_fraction) << what;
    }
}

TEST_P(Properties, LambdaIsAFraction) {
    for_neighborhoods(1000000, 8000, [&](const Neighborhood& all) {
        const UncoveredPart part = exact_part(dimension(), that_count(all));
        ASSERT_TRUE(part.fraction >= 0 && part.fraction <= 1) << all.name() << part.fraction;
        ASSERT_LE(std::sqrt(dot(part.moment, part.moment)), part.fraction + lambda_band)
            << all.name();
    });
}

TEST_P(Properties, LabelsKnowNoPlaceDirectionScaleOrOrder) {
    for_neighborhoods(2000000, 4000, [&](const Neighborhood& all) {
        if (!is_clear_of_limits(all))
            return;
        const double lambda = lambda_of(dimension(), that_count(all));
        std::mt19937_64 generator(all.number);
        Neighborhood other = all;
        std::reverse(other.neighbors.begin(), other.neighbors.end());
        expect_same_label(lambda, lambda_of(dimension(), that_count(other)), "order " + all.name());
        const double angle = static_cast<double>(generator() % 6283) / 1000;
        const double cosine = std::cos(angle), sine = std::sin(angle);
        for (Vector3& x : other.neighbors)
            x = {cosine * x[0] - sine * x[1], sine * x[0] + cosine * x[1], x[2]};
        if (dimension() == 3)
            for (Vector3& x : other.neighbors)
                x = {x[0], cosine * x[1] - sine * x[2], sine * x[1] + cosine * x[2]};
        expect_same_label(lambda, lambda_of(dimension(), that_count(other)), "turn " + all.name());
        const double scale = std::ldexp(1 + static_cast<double>(generator() % 1000) / 1000, 7);
        const Vector3 place{static_cast<double>(generator() % 64), 3, dimension() == 2 ? 0.0 : 5.0};
        other = all;
        for (Vector3& x : other.neighbors)
            x = scaled(1 / scale, difference(sum(place, scaled(scale, x)), place));
        expect_same_label(lambda, lambda_of(dimension(), that_count(other)), "place " + all.name());
    });
}

TEST_P(Properties, MoreNeighborsNeverUncover) {
    for_neighborhoods(3000000, 400, [&](const Neighborhood& all) {
        std::vector<Vector3> some;
        double before = 1;
        for (const Vector3& x : that_count(all)) {
            some.push_back(x);
            const double after = lambda_of(dimension(), some);
            ASSERT_LE(after, before + lambda_band) << all.name() << ", neighbor " << some.size();
            before = after;
        }
    });
}

/// Of 2,000 independent directions no share lies so far off, but with probability 1e-9 for each of
/// the neighborhoods (Hoeffding 1963: 2 exp(-2 N t^2)).
TEST_P(Properties, ExactAndMonteCarloAgree) {
    constexpr std::size_t samples = 2000;
    const double tolerance = std::sqrt(std::log(2 / 1e-9) / (2.0 * samples));
    const SamplingScheme scheme = sampling_scheme("random");
    std::vector<Direction> directions(samples);
    DirectionBlocks blocks;
    Caps caps;
    caps.radius_ratio = radius_ratio;
    for_neighborhoods(4000000, 1500, [&](const Neighborhood& all) {
        const auto counted = that_count(all);
        scheme.fill(dimension(), 0, all.number, directions);
        plain_blocks(directions, blocks);
        caps.displacements.assign(counted.begin(), counted.end());
        const auto open = static_cast<double>(count_uncovered(blocks, caps));
        const double lambda = lambda_of(dimension(), counted);
        ASSERT_NEAR(open / samples, lambda, tolerance + lambda_band) << all.name();
        if (lambda == 0) {
            ASSERT_EQ(open, 0) << all.name();
        }
    });
}

/// The neighborhood as a fluid: the particle and its neighbors, with lists of all pairs.
template <class Real, int Dimension>
struct SmallFluid {
    std::vector<Real> positions;
    std::vector<std::size_t> offsets{0};
    std::vector<std::uint32_t> neighbors;

    explicit SmallFluid(const Neighborhood& all) {
        positions.assign(Dimension, Real(0));
        for (const Vector3& x : all.neighbors)
            for (int axis = 0; axis < Dimension; ++axis)
                positions.push_back(static_cast<Real>(x[axis]));
        for (std::size_t i = 0; i < size(); ++i) {
            for (std::size_t j = 0; j < size(); ++j)
                if (i != j)
                    neighbors.push_back(static_cast<std::uint32_t>(j));
            offsets.push_back(neighbors.size());
        }
    }

    [[nodiscard]] std::size_t size() const { return positions.size() / Dimension; }
    [[nodiscard]] CsrNeighborhood<Real, Dimension> view() const {
        return {positions.data(), nullptr, offsets.data(), neighbors.data()};
    }
};

template <class Real, int Dimension>
double length_of(const std::array<Real, Dimension>& vector) {
    double squares = 0;
    for (const Real coordinate : vector)
        squares += static_cast<double>(coordinate) * static_cast<double>(coordinate);
    return std::sqrt(squares);
}

/// Unit or zero normals, finite numbers, and no force on what is not surface.
template <class Real, int Dimension>
void expect_sound_step(const Neighborhood& all, SurfaceTension<Real, Dimension>& tension) {
    const SmallFluid<Real, Dimension> fluid(all);
    const UniformRadius<Real> radii{Real(1)};
    tension.step(fluid.view(), fluid.size(), radii, SerialLoop{});
    const auto& list = tension.surface();
    double forces = 0;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const double normal = length_of<Real, Dimension>(list.normal[slot]);
        const double force = length_of<Real, Dimension>(list.force[slot]);
        ASSERT_TRUE(normal == 0 || std::abs(normal - 1) < 1e-5) << all.name() << ' ' << normal;
        ASSERT_TRUE(is_finite(force) && is_finite(list.curvature[slot])) << all.name();
        if (list.surface_class[slot] != SurfaceClass::surface) {
            ASSERT_EQ(force, 0) << all.name();
        }
        forces += force;
    }
    tension.template balance_momentum<Dimension>(fluid.view(), NoBoundary{}, radii,
                                                 fluid.positions.data(), SerialLoop{});
    std::array<double, 3> net{};
    for (std::size_t slot = 0; slot < list.size(); ++slot)
        for (int axis = 0; axis < Dimension; ++axis)
            net[axis] += static_cast<double>(list.force[slot][axis]);
    const double off = std::sqrt(dot(net, net));
    ASSERT_LE(off, (sizeof(Real) == 4 ? 1e-5 : 1e-12) * forces) << all.name();
}

template <class Real, int Dimension>
void expect_sound_steps(const Neighborhood& all) {
    static SurfaceTension<Real, Dimension> ours;
    static SurfaceTension<Real, Dimension> paper(paper_options());
    expect_sound_step(all, ours);
    if (!testing::Test::HasFatalFailure())
        expect_sound_step(all, paper);
}

TEST_P(Properties, StepsAreSound) {
    for_neighborhoods(5000000, 1500, [&](const Neighborhood& all) {
        if (dimension() == 2) {
            expect_sound_steps<float, 2>(all);
            expect_sound_steps<double, 2>(all);
        } else {
            expect_sound_steps<float, 3>(all);
            expect_sound_steps<double, 3>(all);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Properties, testing::Values(2, 3),
                         [](const auto& info) { return std::to_string(info.param) + "D"; });

} // namespace
} // namespace meniscus::test
