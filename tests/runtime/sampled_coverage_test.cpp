// Directions and what they say of the uncovered part: as a plain loop over the same directions
// says, without bias, and close to the exact part.
#include <meniscus/runtime/coverage/exact_coverage.hpp>
#include <meniscus/runtime/coverage/sampled_coverage.hpp>

#include "random_caps.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace meniscus {
namespace {

template <int Dimension>
SampleDirections outward_directions(std::size_t samples, std::uint64_t seed = 0) {
    SampleDirections directions;
    fill_outward_directions<Dimension>(samples, seed, directions);
    return directions;
}

/// The same, said to lie as they are.
template <int Dimension>
SampleDirections fixed_directions(std::size_t samples, std::uint64_t seed = 0) {
    SampleDirections directions = outward_directions<Dimension>(samples, seed);
    directions.outward = false;
    return directions;
}

/// The caps of neighbors, as surface_particles.hpp collects them.
SampledCaps caps_of(const Displacements& neighbors, double radius_ratio = test_radius_ratio) {
    SampledCaps caps;
    caps.reserve(neighbors.size());
    for (const Vector3& u : neighbors) {
        caps.x[caps.count] = static_cast<float>(u[0]);
        caps.y[caps.count] = static_cast<float>(u[1]);
        caps.z[caps.count] = static_cast<float>(u[2]);
        caps.limit[caps.count] =
            static_cast<float>((dot(u, u) + 1 - radius_ratio * radius_ratio) / 2);
        ++caps.count;
    }
    return caps;
}

template <int Dimension>
SampledPart sampled(const SampleDirections& directions, std::size_t set,
                    const Displacements& neighbors) {
    Vector3 outward{};
    for (const Vector3& u : neighbors)
        outward = difference(outward, u);
    SampledCaps caps = caps_of(neighbors);
    return sample_coverage<Dimension>(directions, set * directions.stride, outward, caps);
}

template <int Dimension>
void test_sets(std::size_t samples) {
    SCOPED_TRACE(samples);
    const auto directions = outward_directions<Dimension>(samples);
    ASSERT_GE(directions.sets, 1U);
    ASSERT_EQ(directions.x.size(), directions.sets * directions.stride);
    for (std::size_t set = 0; set < directions.sets; ++set) {
        double weights = 0;
        for (std::size_t k = 0; k < directions.stride; ++k) {
            const std::size_t n = set * directions.stride + k;
            weights += directions.weight[n];
            EXPECT_EQ(directions.weight[n] == 0, k >= samples);
            const Vector3 place = {directions.x[n], directions.y[n], directions.z[n]};
            ASSERT_NEAR(dot(place, place), 1, 1e-6);
            ASSERT_TRUE(Dimension == 3 || place[2] == 0);
        }
        EXPECT_NEAR(weights, 1, 1e-5) << set;
    }
}

TEST(SampleDirections, AreUnitVectorsWhoseWeightsAddUpToOne) {
    for (const std::size_t samples : {4, 5, 9, 10, 11, 60, 128, 1000, 16384, 20000}) {
        test_sets<2>(samples);
        test_sets<3>(samples);
    }
}

TEST(SampleDirections, AreThoseOfTheSeedAndOfTheParticle) {
    const auto directions = outward_directions<3>(60, 1);
    EXPECT_EQ(directions.x, outward_directions<3>(60, 1).x);
    EXPECT_NE(directions.x, outward_directions<3>(60, 2).x);
    std::vector<int> taken(directions.sets);
    for (std::uint64_t particle = 0; particle < 100 * directions.sets; ++particle) {
        const std::size_t begin = directions.set_begin(particle);
        ASSERT_EQ(begin % directions.stride, 0U);
        ++taken.at(begin / directions.stride);
    }
    for (const int times : taken)
        EXPECT_NEAR(times, 100, 60);
}

TEST(SampleDirections, NumberFollowsTheTimeStep) {
    EXPECT_EQ(samples_for_time_step(0.001, 100000, 32), 100U);
    EXPECT_EQ(samples_for_time_step(0.0001, 100000, 32), 32U);
    EXPECT_EQ(samples_for_time_step(1e30, 1e30, 32), max_samples);
    EXPECT_EQ(samples_for_time_step(-1, 100000, 32), 32U);
}

/// Mean and the standard error of it.
struct Sample {
    double sum = 0, squares = 0, count = 0;

    void add(double value) {
        sum += value;
        squares += value * value;
        count += 1;
    }
    [[nodiscard]] double mean() const { return sum / count; }
    [[nodiscard]] double error() const {
        return std::sqrt((squares / count - mean() * mean()) / count);
    }
};

/// Area of the cap that a neighbor covers and its moment along the neighbor, per area of the whole.
template <int Dimension>
std::array<double, 2> covered_by(double distance) {
    const double cosine =
        (distance * distance + 1 - test_radius_ratio * test_radius_ratio) / (2 * distance);
    const double sine = std::sqrt(1 - cosine * cosine);
    if (Dimension == 2)
        return {std::acos(cosine) / pi, sine / pi};
    return {(1 - cosine) / 2, sine * sine / 4};
}

template <int Dimension>
void test_bias(std::size_t samples, bool outward) {
    std::mt19937_64 engine(samples);
    Sample fraction, along;
    const double distance = 0.7;
    // Toward it one direction only, so that chance is in the sets alone.
    const Vector3 toward = random_direction(engine, Dimension);
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const auto directions = outward ? outward_directions<Dimension>(samples, seed)
                                        : fixed_directions<Dimension>(samples, seed);
        for (std::size_t set = 0; set < directions.sets; ++set) {
            const auto part = sampled<Dimension>(directions, set, {scaled(distance, toward)});
            fraction.add(part.fraction);
            along.add(dot(part.moment, toward));
        }
    }
    const auto [area, moment] = covered_by<Dimension>(distance);
    EXPECT_NEAR(fraction.mean(), 1 - area, 5 * fraction.error() + 1e-6) << samples;
    EXPECT_NEAR(along.mean(), -moment, 5 * along.error() + 1e-6) << samples;
    EXPECT_LT(fraction.error(), 4e-3);
}

TEST(SampledCoverage, HasNoBias) {
    for (const std::size_t samples : {4, 10, 60})
        for (const bool outward : {false, true}) {
            test_bias<2>(samples, outward);
            test_bias<3>(samples, outward);
        }
}

/// The part by a plain loop, and the weight of samples that rounding may decide otherwise.
struct PlainPart {
    double fraction = 0;
    Vector3 moment{};
    double doubtful = 0;
};

template <int Dimension>
std::array<Vector3, 3> axes_of(const SampleDirections& directions, const Displacements& neighbors) {
    Vector3 outward{};
    for (const Vector3& u : neighbors)
        outward = difference(outward, u);
    const double length = std::sqrt(dot(outward, outward));
    if (!directions.outward || length == 0)
        return {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    const Vector3 axis = scaled(1 / length, outward);
    if (Dimension == 2)
        return {axis, Vector3{-axis[1], axis[0], 0}, Vector3{0, 0, 1}};
    return {Frame(axis).first, Frame(axis).second, axis};
}

template <int Dimension>
PlainPart plain_part(const SampleDirections& directions, std::size_t set,
                     const Displacements& neighbors) {
    const auto axes = axes_of<Dimension>(directions, neighbors);
    PlainPart part;
    for (std::size_t k = 0; k < directions.samples; ++k) {
        const std::size_t n = set * directions.stride + k;
        const Vector3 place =
            sum(sum(scaled(directions.x[n], axes[0]), scaled(directions.y[n], axes[1])),
                scaled(directions.z[n], axes[2]));
        double nearest = 10; // squared distance to a neighbor, less that of its sphere
        for (const Vector3& u : neighbors) {
            const Vector3 apart = difference(place, u);
            nearest = std::min(nearest, dot(apart, apart) - test_radius_ratio * test_radius_ratio);
        }
        const double weight = directions.weight[n];
        part.doubtful += std::fabs(nearest) < 1e-5 ? weight : 0;
        if (nearest >= 0) {
            part.fraction += weight;
            part.moment = sum(part.moment, scaled(weight, place));
        }
    }
    return part;
}

template <int Dimension>
void test_plain(const SampleDirections& directions) {
    std::mt19937_64 engine(directions.samples);
    int doubtful = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const auto neighbors = random_neighborhood(engine, Dimension);
        const std::size_t set = engine() % directions.sets;
        const auto part = sampled<Dimension>(directions, set, neighbors);
        const PlainPart plain = plain_part<Dimension>(directions, set, neighbors);
        doubtful += plain.doubtful > 0 ? 1 : 0;
        EXPECT_NEAR(part.fraction, plain.fraction, plain.doubtful + 2e-6);
        const Vector3 apart = difference(part.moment, plain.moment);
        EXPECT_LE(std::sqrt(dot(apart, apart)), plain.doubtful + 2e-6);
        EXPECT_TRUE(!part.is_certain || part.fraction > 0);
    }
    EXPECT_LT(doubtful, 40);
}

TEST(SampledCoverage, IsThatOfAPlainLoop) {
    for (const std::size_t samples : {5, 64, 200}) {
        test_plain<2>(outward_directions<2>(samples));
        test_plain<3>(outward_directions<3>(samples));
        test_plain<2>(fixed_directions<2>(samples));
        test_plain<3>(fixed_directions<3>(samples));
    }
}

template <int Dimension>
void test_against_exact(double max_error_of_one, double max_error_of_all) {
    const auto directions = outward_directions<Dimension>(128);
    std::mt19937_64 engine(1);
    Sample of_one, of_all;
    for (int trial = 0; trial < 300; ++trial) {
        const auto neighbors = random_neighborhood(engine, Dimension);
        const UncoveredPart exact = uncovered<Dimension>(neighbors);
        double mean = 0;
        for (std::size_t set = 0; set < directions.sets; ++set) {
            const auto part = sampled<Dimension>(directions, set, neighbors);
            mean += part.fraction / static_cast<double>(directions.sets);
            of_one.add(std::pow(part.fraction - exact.fraction, 2));
        }
        of_all.add(std::pow(mean - exact.fraction, 2));
    }
    EXPECT_LT(std::sqrt(of_one.mean()), max_error_of_one);
    EXPECT_LT(std::sqrt(of_all.mean()), max_error_of_all);
}

TEST(SampledCoverage, AgreesWithExactCoverageWithinTheErrorOfSampling) {
    // That of as many random directions: sqrt(lambda (1 - lambda) / samples), 0.03 at most.
    test_against_exact<2>(0.01, 0.002);
    test_against_exact<3>(0.01, 0.002);
}

template <int Dimension>
void test_certainty() {
    const auto directions = outward_directions<Dimension>(128);
    std::mt19937_64 engine(2);
    std::uniform_real_distribution<double> uniform;
    int covered = 0, certain = 0, open = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        auto neighbors = random_neighborhood(engine, Dimension);
        // Half of them crowded: mostly covered.
        for (int more = trial % 2 * trial % 200; more > 0; --more)
            neighbors.push_back(
                scaled(0.3 + 0.69 * uniform(engine), random_direction(engine, Dimension)));
        const double lambda = uncovered<Dimension>(neighbors).fraction;
        const auto part = sampled<Dimension>(directions, engine() % directions.sets, neighbors);
        if (lambda <= zero_uncovered_fraction) {
            ++covered;
            EXPECT_FALSE(part.is_certain) << trial;
        }
        open += lambda > 0.1 ? 1 : 0;
        certain += lambda > 0.1 && part.is_certain ? 1 : 0;
    }
    EXPECT_GT(covered, 500);
    EXPECT_GT(open, 500);
    EXPECT_EQ(certain, open);
}

TEST(SampledCoverage, IsCertainOnlyWhereExactCoverageSaysSurface) {
    test_certainty<2>();
    test_certainty<3>();
}

/// A neighbor whose cap ends a given angle before the pole, where all directions are.
SampledPart sampled_at_edge(double angle) {
    SampleDirections pole;
    fill_directions(
        8, false,
        [](std::size_t, std::size_t) {
            return Vector3{0, 0, 1};
        },
        [](std::size_t) { return 0.125; }, pole);
    const double distance = 0.6; // where the cap is largest: its radius has the cosine 0.6
    const double turn = std::acos(0.6) + angle;
    return sampled<3>(pole, 0, {{distance * std::sin(turn), 0, distance * std::cos(turn)}});
}

TEST(SampledCoverage, IsCertainOnlyBeyondRounding) {
    EXPECT_EQ(sampled_at_edge(-1e-3).fraction, 0);
    EXPECT_EQ(sampled_at_edge(1e-5).fraction, 1);
    EXPECT_FALSE(sampled_at_edge(1e-5).is_certain);
    EXPECT_EQ(sampled_at_edge(1e-3).fraction, 1);
    EXPECT_TRUE(sampled_at_edge(1e-3).is_certain);
}

TEST(SampledCoverage, OfAParticleAloneIsAllUncovered) {
    for (const std::size_t samples : {4, 60, 500}) {
        const auto part = sampled<3>(outward_directions<3>(samples), 0, {});
        EXPECT_NEAR(part.fraction, 1, 1e-5);
        EXPECT_LE(part.fraction, 1);
        EXPECT_TRUE(part.is_certain);
    }
}

/// A product and a sum, rounded once or twice as the compiler has it.
float product_and_sum(volatile float a, volatile float b, volatile float c) {
    return a * b + c;
}

bool is_contracted() {
    return product_and_sum(1 + 0x1p-13F, 1 - 0x1p-13F, -1) != 0;
}

/// fraction and moment in float, summed in sixteen lanes as the kernels do on every machine.
std::array<float, 4> in_lanes(const SampleDirections& directions, std::size_t begin,
                              const SampledCaps& caps) {
    float lanes[4][16] = {};
    for (std::size_t k = 0; k < directions.stride; ++k) {
        const std::size_t n = begin + k;
        const float place[3] = {directions.x[n], directions.y[n], directions.z[n]};
        bool is_open = true;
        for (std::size_t c = 0; c < caps.count; ++c)
            is_open = is_open && place[0] * caps.x[c] + place[1] * caps.y[c] +
                                         place[2] * caps.z[c] - caps.limit[c] <=
                                     0;
        if (!is_open)
            continue;
        lanes[0][k % 16] += directions.weight[n];
        for (int axis = 0; axis < 3; ++axis)
            lanes[1 + axis][k % 16] += directions.weight[n] * place[axis];
    }
    std::array<float, 4> sums;
    for (int what = 0; what < 4; ++what) {
        for (int half = 8; half > 0; half /= 2)
            for (int lane = 0; lane < half; ++lane)
                lanes[what][lane] += lanes[what][lane + half];
        sums[what] = lanes[what][0];
    }
    return sums;
}

TEST(SampledCoverage, HasTheSameBitsWhateverTheVectors) {
#if defined(__FAST_MATH__)
    GTEST_SKIP() << "fast mathematics rounds as it likes";
#endif
    if (is_contracted())
        GTEST_SKIP() << "products and sums are contracted";
    const auto directions = fixed_directions<3>(200);
    std::mt19937_64 engine(3);
    for (int trial = 0; trial < 400; ++trial) {
        const auto neighbors = random_neighborhood(engine, 3);
        const std::size_t set = engine() % directions.sets;
        const auto part = sampled<3>(directions, set, neighbors);
        const auto plain = in_lanes(directions, set * directions.stride, caps_of(neighbors));
        EXPECT_EQ(part.fraction, std::min(plain[0], 1.0F));
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(part.moment[axis], static_cast<double>(plain[1 + axis]));
    }
}

} // namespace
} // namespace meniscus
