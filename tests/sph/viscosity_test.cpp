#include <meniscus/sph/fluid/viscosity.hpp>

#include "sample_fluids.hpp"

namespace meniscus {
namespace {

Place velocity_difference(const PlainFluid& fluid, std::size_t i, std::size_t j) {
    return difference_of(fluid.velocities[i], fluid.velocities[j]);
}

std::vector<Place> plain_viscosity(const PlainFluid& fluid, double nu, bool corrected) {
    const std::vector<double> density = densities_of(fluid);
    std::vector<Place> accelerations(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i)
        fluid.visit(i, [&](std::size_t j) { // Monaghan 2005, eq. 8.12, of the mean density
            const Place x = fluid.x_ij(i, j);
            const double mean = (density[i] + density[j]) / 2;
            double size = 2 * (fluid.dimension + 2) * nu * fluid.mass / mean *
                          dot_of(velocity_difference(fluid, i, j), x) /
                          (dot_of(x, x) + 0.01 * fluid.h * fluid.h);
            if (corrected)
                size *= fluid.rest_density / mean;
            accelerations[i] =
                sum_of(accelerations[i], product_of(size, fluid.kernel().gradient(x)));
        });
    return accelerations;
}

std::vector<Place> plain_xsph(const PlainFluid& fluid, double share) {
    const std::vector<double> density = densities_of(fluid);
    std::vector<Place> velocities = fluid.velocities;
    for (std::size_t i = 0; i < fluid.size(); ++i)
        fluid.visit(i, [&](std::size_t j) { // Monaghan 1989
            const double weight = share * fluid.mass / ((density[i] + density[j]) / 2) *
                                  fluid.kernel().value(fluid.distance(i, j));
            velocities[i] =
                sum_of(velocities[i], product_of(-weight, velocity_difference(fluid, i, j)));
        });
    return velocities;
}

template <class SettingType>
class Viscosity : public testing::Test {
public:
    using Real = typename SettingType::Real;
    static constexpr int dimension = SettingType::dimension;
    using Sample = SampleFluid<Real, dimension>;

    static std::vector<Place> accelerations(const Sample& sample) {
        std::vector<Place> found;
        for (std::size_t i = 0; i < sample.fluid.count; ++i)
            found.push_back(sample.acceleration(i));
        return found;
    }

    static void expect_same(const std::vector<Place>& found, const std::vector<Place>& expected) {
        const double max = max_over(expected);
        EXPECT_GT(max, 0);
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_LT(length_of(difference_of(found[i], expected[i])), SettingType::tolerance * max)
                << "particle " << i;
    }

    static void expect_no_sum(const std::vector<Place>& vectors) {
        Place sum{};
        double size = 0;
        for (const Place& vector : vectors) {
            sum = sum_of(sum, vector);
            size += length_of(vector);
        }
        EXPECT_LT(length_of(sum), SettingType::tolerance / 10 * size);
    }
};
TYPED_TEST_SUITE(Viscosity, Settings);

TYPED_TEST(Viscosity, IsTheSumOverAllPairsAndKeepsMomentum) {
    for (const KernelKind kernel : all_kernels)
        for (const double h : {0.125, 1e-3, 40.0})
            for (const bool corrected : {false, true}) {
                PlainFluid plain = lattice_ball(this->dimension, kernel, h, 0.3);
                typename TestFixture::Sample sample(plain);
                ViscosityOptions options;
                options.kinematic = 0.01;
                options.density_correction = corrected;
                add_viscosity(options, sample.fluid);
                this->expect_same(this->accelerations(sample),
                                  plain_viscosity(plain, 0.01, corrected));
                this->expect_no_sum(this->accelerations(sample));
            }
}

TYPED_TEST(Viscosity, OfZeroIsNone) {
    PlainFluid plain = lattice_ball(this->dimension, KernelKind::cubic_spline, 0.1, 0.3);
    typename TestFixture::Sample sample(plain);
    add_viscosity({}, sample.fluid);
    for (const Place& acceleration : this->accelerations(sample))
        EXPECT_EQ(acceleration, Place{});
}

TYPED_TEST(Viscosity, IsFiniteForParticlesInOnePlace) {
    PlainFluid plain = particle_pair(this->dimension, KernelKind::mueller, 0.1, 0);
    plain.velocities = {{1, 0, 0}, {-1, 0, 0}};
    typename TestFixture::Sample sample(plain);
    ViscosityOptions options;
    options.kinematic = 0.01;
    add_viscosity(options, sample.fluid);
    for (const Place& acceleration : this->accelerations(sample))
        EXPECT_EQ(acceleration, Place{});
}

TYPED_TEST(Viscosity, XsphIsTheSumOverAllPairsAndKeepsMomentum) {
    using Real = typename TypeParam::Real;
    for (const KernelKind kernel : all_kernels)
        for (const double h : {0.125, 40.0}) {
            PlainFluid plain = lattice_ball(this->dimension, kernel, h, 0.3);
            typename TestFixture::Sample sample(plain);
            std::vector<Row<Real>> smoothed;
            smooth_velocities(Real(0.3), sample.fluid, smoothed);
            ASSERT_EQ(smoothed.size(), plain.size() + 1);
            std::vector<Place> velocities;
            std::vector<Place> changes;
            for (std::size_t i = 0; i < plain.size(); ++i) {
                velocities.push_back(sample.in_metres(smoothed[i]));
                changes.push_back(difference_of(velocities[i], plain.velocities[i]));
                EXPECT_EQ(smoothed[i].w, sample.fluid.density[i]);
            }
            this->expect_same(velocities, plain_xsph(plain, 0.3));
            this->expect_no_sum(changes);
        }
}

} // namespace
} // namespace meniscus
