#include <meniscus/sph/tension/tension_models.hpp>

#include "sample_fluids.hpp"

namespace meniscus {
namespace {

// The papers' accelerations in SI units, over all pairs in double.

std::vector<Place> plain_cohesion(const PlainFluid& fluid, double phi, double min_distance) {
    std::vector<Place> accelerations(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i)
        fluid.visit(i, [&](std::size_t j) { // Huber et al. 2015, eq. 2, masses being equal
            const double w = fluid.kernel().value(std::max(fluid.distance(i, j), min_distance));
            accelerations[i] = sum_of(accelerations[i], product_of(-phi * w, fluid.x_ij(i, j)));
        });
    return accelerations;
}

/// Eq. 5; in 2D with the constant that makes the integral over the disk that over the ball in 3D.
double plain_akinci_cohesion(double r, double h, int dimension) {
    const double factor = dimension == 3 ? 32 / (plain_pi * std::pow(h, 9))
                                         : 40.318979266347688 / (plain_pi * std::pow(h, 8));
    if (2 * r > h && r <= h)
        return factor * std::pow(h - r, 3) * std::pow(r, 3);
    if (r > 0 && 2 * r <= h)
        return factor * (2 * std::pow(h - r, 3) * std::pow(r, 3) - std::pow(h, 6) / 64);
    return 0;
}

std::vector<Place> plain_akinci(const PlainFluid& fluid, double gamma) {
    const std::vector<double> density = densities_of(fluid);
    std::vector<Place> normal(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i)
        fluid.visit(i, [&](std::size_t j) { // eq. 6
            normal[i] = sum_of(normal[i], product_of(fluid.h * fluid.mass / density[j],
                                                     fluid.kernel().gradient(fluid.x_ij(i, j))));
        });
    std::vector<Place> accelerations(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i)
        fluid.visit(i, [&](std::size_t j) {
            const double r = fluid.distance(i, j);
            Place force{};
            if (r > 0) // eq. 4
                force = product_of(-gamma * fluid.mass * fluid.mass / r *
                                       plain_akinci_cohesion(r, fluid.h, fluid.dimension),
                                   fluid.x_ij(i, j));
            force = sum_of(force, product_of(-gamma * fluid.mass, // eq. 7
                                             difference_of(normal[i], normal[j])));
            const double k = 2 * fluid.rest_density / (density[i] + density[j]); // eqs. 8 and 9
            accelerations[i] = sum_of(accelerations[i], product_of(k / fluid.mass, force));
        });
    return accelerations;
}

std::vector<Place> plain_he(const PlainFluid& fluid, double kappa) {
    const PlainKernel kernel = fluid.kernel();
    std::vector<double> volume;
    for (const double density : densities_of(fluid))
        volume.push_back(fluid.mass / density);
    std::vector<double> squared_gradient;
    for (std::size_t i = 0; i < fluid.size(); ++i) { // eq. 11
        Place above{};
        double below = volume[i] * kernel.value(0);
        fluid.visit(i, [&](std::size_t j) {
            above = sum_of(above, product_of(volume[j], kernel.gradient(fluid.x_ij(i, j))));
            below += volume[j] * kernel.value(fluid.distance(i, j));
        });
        squared_gradient.push_back(dot_of(above, above) / (below * below));
    }
    std::vector<Place> accelerations(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i)
        fluid.visit(i, [&](std::size_t j) { // eq. 12
            const double size = kappa / 2 * volume[i] * volume[j] *
                                ((squared_gradient[i] + squared_gradient[j]) / 2);
            accelerations[i] = sum_of(
                accelerations[i], product_of(size / fluid.mass, kernel.gradient(fluid.x_ij(i, j))));
        });
    return accelerations;
}

std::vector<Place> plain_color_field(const PlainFluid& fluid, double sigma) {
    const PlainKernel kernel = fluid.kernel();
    const std::vector<double> density = densities_of(fluid);
    std::vector<Place> accelerations(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i) { // Mueller et al. 2003, eqs. 15 to 19
        Place normal{};
        double laplacian = fluid.mass / density[i] * kernel.laplacian(0);
        fluid.visit(i, [&](std::size_t j) {
            const double r = fluid.distance(i, j);
            const double volume = fluid.mass / density[j];
            laplacian += volume * kernel.laplacian(r);
            if (r > 0)
                normal = sum_of(normal,
                                product_of(volume * kernel.value_slope(r) / r, fluid.x_ij(i, j)));
        });
        const double length = length_of(normal);
        const double threshold = 0.1 / fluid.h;
        EXPECT_GT(std::abs(length - threshold), 1e-4 * threshold) << "rounding would decide";
        if (length > threshold)
            accelerations[i] = product_of(-sigma * laplacian / (length * density[i]), normal);
    }
    return accelerations;
}

std::vector<Place> plain_accelerations(std::string_view model, const PlainFluid& fluid,
                                       double coefficient) {
    if (model == "becker_2007")
        return plain_cohesion(fluid, coefficient, 0);
    if (model == "huber_2015")
        return plain_cohesion(fluid, coefficient, fluid.spacing);
    if (model == "akinci_2013")
        return plain_akinci(fluid, coefficient);
    if (model == "he_2014")
        return plain_he(fluid, coefficient);
    return plain_color_field(fluid, coefficient);
}

constexpr std::array<std::string_view, 5> rivals = {"becker_2007", "huber_2015", "akinci_2013",
                                                    "he_2014", "color_field"};

bool keeps_momentum(std::string_view model) {
    return model != "color_field";
}

template <class SettingType>
class RivalTension : public testing::Test {
public:
    using Real = typename SettingType::Real;
    static constexpr int dimension = SettingType::dimension;

    static std::unique_ptr<SurfaceTensionModel<Real, dimension>>
    model_of(std::string_view model, double coefficient, const PlainFluid& plain) {
        TensionOptions options;
        options.model = model;
        options.coefficient = coefficient;
        return make_tension_model<Real, dimension>(options, {plain.h, plain.rest_density, {}},
                                                   plain.spacing / plain.h);
    }

    /// The step's accelerations, m/s^2.
    static std::vector<Place> accelerations(std::string_view model, PlainFluid& plain,
                                            double coefficient) {
        SampleFluid<Real, dimension> sample(plain);
        model_of(model, coefficient, plain)->add_accelerations(sample.fluid);
        std::vector<Place> found;
        for (std::size_t i = 0; i < plain.size(); ++i)
            found.push_back(sample.acceleration(i));
        return found;
    }

    /// Returns the largest acceleration.
    static double expect_as_plain(std::string_view model, PlainFluid plain) {
        const auto found = accelerations(model, plain, 0.7); // rounds the fluid
        const auto expected = plain_accelerations(model, plain, 0.7);
        const double max = max_over(expected);
        for (std::size_t i = 0; i < plain.size(); ++i)
            EXPECT_LE(length_of(difference_of(found[i], expected[i])), SettingType::tolerance * max)
                << "particle " << i << ", h " << plain.h << ", model " << model;
        return max;
    }
};
TYPED_TEST_SUITE(RivalTension, Settings);

TYPED_TEST(RivalTension, PairsMoveAsTheFormulasSay) {
    for (const std::string_view model : rivals)
        for (const KernelKind kernel : all_kernels)
            for (const double h : {0.125, 1e-3, 40.0})
                for (const double share : {0.1, 0.35, 0.45, 0.7, 0.95}) {
                    const bool moves =
                        this->expect_as_plain(
                            model, particle_pair(this->dimension, kernel, h, share * h)) > 0;
                    // So far apart, the gradient of the color field is none of a surface.
                    EXPECT_EQ(moves, model != "color_field" || share < 0.9);
                }
}

TYPED_TEST(RivalTension, BallsMoveAsTheFormulasSay) {
    for (const std::string_view model : rivals)
        for (const KernelKind kernel : all_kernels)
            for (const double h : {0.125, 1e-3, 40.0})
                for (const double jitter : {0.0, 0.3})
                    EXPECT_GT(this->expect_as_plain(
                                  model, lattice_ball(this->dimension, kernel, h, jitter)),
                              0);
}

TYPED_TEST(RivalTension, PullsABallInward) {
    for (const std::string_view model : rivals) {
        PlainFluid ball = lattice_ball(this->dimension, KernelKind::mueller, 0.125, 0);
        const auto accelerations = this->accelerations(model, ball, 1);
        double inward = 0;
        for (std::size_t i = 0; i < ball.size(); ++i)
            inward -= dot_of(accelerations[i], ball.positions[i]);
        EXPECT_GT(inward, 0) << model;
    }
}

TYPED_TEST(RivalTension, PairForcesAreOpposite) {
    for (const std::string_view model : rivals)
        for (const double share : {0.1, 0.45, 0.7}) {
            PlainFluid pair =
                particle_pair(this->dimension, KernelKind::mueller, 0.125, share * 0.125);
            const auto accelerations = this->accelerations(model, pair, 1);
            EXPECT_EQ(accelerations[0], product_of(-1, accelerations[1]));
        }
}

TYPED_TEST(RivalTension, MomentumIsKeptWhereTheModelDoes) {
    for (const std::string_view model : rivals)
        for (const KernelKind kernel : all_kernels) {
            PlainFluid ball = lattice_ball(this->dimension, kernel, 0.125, 0.3);
            const auto accelerations = this->accelerations(model, ball, 1);
            Place sum{};
            double size = 0;
            for (const Place& acceleration : accelerations) {
                sum = sum_of(sum, acceleration);
                size += length_of(acceleration);
            }
            if (keeps_momentum(model))
                EXPECT_LT(length_of(sum), TypeParam::tolerance / 10 * size);
            else
                EXPECT_GT(length_of(sum), 1e-3 * size);
        }
}

TYPED_TEST(RivalTension, TwoInOnePlaceDoNotMoveEachOther) {
    for (const std::string_view model : rivals)
        for (const KernelKind kernel : all_kernels) {
            PlainFluid pair = particle_pair(this->dimension, kernel, 0.125, 0);
            for (const Place& acceleration : this->accelerations(model, pair, 1))
                EXPECT_EQ(acceleration, Place{});
        }
}

TYPED_TEST(RivalTension, ManyInOnePlaceStayFinite) {
    for (const std::string_view model : rivals)
        for (const KernelKind kernel : all_kernels) {
            PlainFluid ball = lattice_ball(this->dimension, kernel, 0.125, 0.3);
            for (std::size_t i = 0; i + 1 < ball.size(); i += 2)
                ball.positions[i] = ball.positions[i + 1];
            for (const Place& acceleration : this->accelerations(model, ball, 1))
                EXPECT_TRUE(std::isfinite(length_of(acceleration)));
        }
}

TYPED_TEST(RivalTension, AloneNothingPulls) {
    for (const std::string_view model : rivals)
        for (const KernelKind kernel : all_kernels) {
            PlainFluid pair = particle_pair(this->dimension, kernel, 0.125, 1.01 * 0.125);
            pair.positions.push_back({3, 0, 0});
            for (const Place& acceleration : this->accelerations(model, pair, 1))
                EXPECT_EQ(acceleration, Place{});
        }
}

TYPED_TEST(RivalTension, AddsToWhatIsThere) {
    for (const std::string_view model : rivals) {
        PlainFluid plain = particle_pair(this->dimension, KernelKind::mueller, 1, 0.5);
        const auto alone = this->accelerations(model, plain, 1);
        SampleFluid<typename TypeParam::Real, TypeParam::dimension> sample(plain);
        sample.fluid.acceleration[0] = {100, 0, 0, 0};
        this->model_of(model, 1, plain)->add_accelerations(sample.fluid);
        EXPECT_NEAR(sample.acceleration(0)[0], 100 + alone[0][0], 1e-4);
    }
}

/// Two particles in 3D, 0.25 m apart along x, with h = 0.5 m and Mueller's kernels.
PlainFluid pair_by_hand() {
    PlainFluid pair = particle_pair(3, KernelKind::mueller, 0.5, 0.25);
    pair.positions[1] = {0.25, 0, 0};
    return pair;
}

using ByHand = RivalTension<Setting<double, 3>>;

TEST_F(ByHand, Becker) {
    // W(h / 2) = 315 / (64 pi h^3) (3/4)^3 = 1.5666815 * 0.421875 / 0.125 = 5.2875500 1/m^3;
    // phi = 2 m^3/s^2: a = -phi x W = 2 * 0.25 * 5.2875500 = 2.6437750 m/s^2.
    PlainFluid pair = pair_by_hand();
    EXPECT_NEAR(accelerations("becker_2007", pair, 2)[0][0], 2.6437750, 1e-7);
}

TEST_F(ByHand, HuberPullsAtHalfASpacingByTheKernelAtOne) {
    // With a spacing of 0.3 m, q = 0.6: W = 1.5666815 * 0.64^3 / 0.125 = 3.2855692 1/m^3;
    // phi = 2 m^3/s^2: a = 2 * 0.25 * 3.2855692 = 1.6427846 m/s^2.
    PlainFluid pair = pair_by_hand();
    pair.spacing = 0.3;
    EXPECT_NEAR(accelerations("huber_2015", pair, 2)[0][0], 1.6427846, 1e-7);
}

TEST_F(ByHand, Akinci) {
    // One mass of 8 kg, rest density 1000 kg/m^3. W(0) = 1.5666815 / 0.125 = 12.5334518 and
    // W(h / 2) = 5.2875500: rho = 8 * 17.8210018 = 142.5680143 kg/m^3 and K = 1000 / rho =
    // 7.0141961. C(h / 2) = 32 / (64 pi h^3) = 1 / (2 pi 0.125) = 1.2732395, so the cohesion is
    // 8 * 1.2732395 = 10.1859164. W'(h / 2) = -45 / (pi h^4) / 4 = -57.2957795 (spiky), so
    // n_0 = 0.5 * 8 / 142.5680143 * 57.2957795 = 1.6075353 towards the other, n_0 - n_1 =
    // 3.2150706 to it, which pushes: a = 7.0141961 (10.1859164 - 3.2150706) = 48.8948785.
    PlainFluid pair = pair_by_hand();
    EXPECT_NEAR(accelerations("akinci_2013", pair, 1)[0][0], 48.8948785, 1e-5);
}

TEST(AkinciAdhesion, PullsTowardsAWallBetweenHalfAndWholeRadius) {
    // A(q) / q = 0.007 (-4 q^2 + 6 q - 2)^(1/4) / q: at q = 3/4, 0.007 * 0.25^(1/4) / 0.75.
    const auto lanes = [](double q) { return all_lanes<Lanes<double>>(q * q); };
    EXPECT_NEAR(akinci_adhesion<double>(lanes(0.75))[0], 0.006599663, 1e-9);
    EXPECT_EQ(akinci_adhesion<double>(lanes(0.49))[0], 0);
    EXPECT_EQ(akinci_adhesion<double>(lanes(1.2))[0], 0);
}

} // namespace
} // namespace meniscus
