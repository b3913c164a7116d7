#include <meniscus/sph/tension/color_field.hpp>

#include "sample_fluids.hpp"

namespace meniscus {
namespace {

template <class SettingType>
class Kernels : public testing::Test {
public:
    using Real = typename SettingType::Real;
    static constexpr int dimension = SettingType::dimension;

    /// What a function of q^2 in lanes gives for one q.
    template <class Function>
    static double at(double q, const Function& function) {
        const auto real = static_cast<Real>(q);
        return static_cast<double>(function(all_lanes<Lanes<Real>>(real * real))[0]);
    }

    /// The integral of f(q) over the ball (in 2D the disk) of radius 1.
    template <class Function>
    static double integral(const Function& f) {
        constexpr int steps = 20000;
        double sum = 0;
        for (int n = 0; n < steps; ++n) {
            const double q = (n + 0.5) / steps;
            sum += f(q) * (dimension == 3 ? 4 * plain_pi * q * q : 2 * plain_pi * q) / steps;
        }
        return sum;
    }

    /// Calls body(kernel) for each.
    template <class Body>
    static void for_each_kernel(const Body& body) {
        body(CubicSpline<Real, dimension>{});
        body(MuellerKernels<Real, dimension>{});
    }

    static constexpr double tolerance = sizeof(Real) == 4 ? 2e-6 : 1e-8;
    /// A step for differences, and how exact they are of a function of order 10.
    static constexpr double step = sizeof(Real) == 4 ? 4e-3 : 1e-5;
    static constexpr double slope_tolerance = sizeof(Real) == 4 ? 5e-3 : 1e-7;
};
TYPED_TEST_SUITE(Kernels, Settings);

TYPED_TEST(Kernels, IntegrateToOne) {
    this->for_each_kernel([&](const auto& kernel) {
        EXPECT_NEAR(this->integral([&](double q) {
            return this->at(q, [&](auto squared) { return kernel.value(squared); });
        }),
                    1, this->tolerance);
    });
}

TYPED_TEST(Kernels, GradientsBelongToKernelsThatIntegrateToOne) {
    // By parts: the integral of W is minus that of W'(q) q / D, and W'(q) q is gradient(q^2) q^2.
    this->for_each_kernel([&](const auto& kernel) {
        EXPECT_NEAR(this->integral([&](double q) {
            return -q * q / this->dimension *
                   this->at(q, [&](auto squared) { return kernel.gradient(squared); });
        }),
                    1, this->tolerance);
    });
}

TYPED_TEST(Kernels, CubicSplinesGradientIsTheDerivativeOfItsValue) {
    const CubicSpline<typename TypeParam::Real, TypeParam::dimension> kernel;
    for (double q = 0.05; q < 0.96; q += 0.05) {
        const auto value = [&](double at) {
            return this->at(at, [&](auto squared) { return kernel.value(squared); });
        };
        const double slope = (value(q + this->step) - value(q - this->step)) / (2 * this->step);
        EXPECT_NEAR(this->at(q, [&](auto squared) { return kernel.gradient(squared); }) * q, slope,
                    this->slope_tolerance);
    }
}

TYPED_TEST(Kernels, SpikyGradientIsTheDerivativeOfMuellersSpikyKernel) {
    constexpr int dimension = TypeParam::dimension;
    const MuellerKernels<typename TypeParam::Real, dimension> kernel;
    const auto spiky = [](double q) { // Mueller et al. 2003, eq. 21
        return (dimension == 3 ? 15 : 10) / plain_pi * std::pow(1 - q, 3);
    };
    for (double q = 0.05; q < 0.96; q += 0.05) {
        const double slope = (spiky(q + 1e-5) - spiky(q - 1e-5)) / 2e-5;
        EXPECT_NEAR(this->at(q, [&](auto squared) { return kernel.gradient(squared); }) * q, slope,
                    100 * TypeParam::tolerance + 1e-8);
    }
}

TYPED_TEST(Kernels, AreZeroBeyondTheSupportAndFiniteInOnePlace) {
    this->for_each_kernel([&](const auto& kernel) {
        for (const double q : {1.0, 1.001, 3.0, 1e6}) {
            EXPECT_EQ(this->at(q, [&](auto s) { return kernel.value(s); }), 0) << q;
            EXPECT_EQ(this->at(q, [&](auto s) { return kernel.gradient(s); }), 0) << q;
            EXPECT_EQ(this->at(q, [&](auto s) { return color_derivatives(kernel, s).gradient; }),
                      0);
            EXPECT_EQ(this->at(q, [&](auto s) { return color_derivatives(kernel, s).laplacian; }),
                      0);
        }
        for (const double q : {0.0, 1e-20, 1e-7, 1e-3}) {
            EXPECT_GT(this->at(q, [&](auto s) { return kernel.value(s); }), 0) << q;
            EXPECT_TRUE(std::isfinite(this->at(q, [&](auto s) { return kernel.gradient(s); })))
                << q;
        }
    });
}

TYPED_TEST(Kernels, ColorDerivativesAreThoseOfTheValue) {
    this->for_each_kernel([&](const auto& kernel) {
        const auto value = [&](double q) {
            return this->at(q, [&](auto s) { return kernel.value(s); });
        };
        const auto gradient = [&](double q) {
            return this->at(q, [&](auto s) { return color_derivatives(kernel, s).gradient; });
        };
        for (double q = 0.14; q < 0.96; q += 0.05) {
            const double step = this->step;
            EXPECT_NEAR(gradient(q) * q, (value(q + step) - value(q - step)) / (2 * step),
                        this->slope_tolerance);
            // lap W = (q^(D-1) W')' / q^(D-1)
            const auto flux = [&](double at) {
                return gradient(at) * std::pow(at, TypeParam::dimension);
            };
            EXPECT_NEAR(this->at(q, [&](auto s) { return color_derivatives(kernel, s).laplacian; }),
                        (flux(q + step) - flux(q - step)) /
                            (2 * step * std::pow(q, TypeParam::dimension - 1)),
                        20 * this->slope_tolerance)
                << q;
        }
        // At the center W'' is the same along all axes, and is the limit of W' / q.
        EXPECT_NEAR(this->at(0, [&](auto s) { return color_derivatives(kernel, s).laplacian; }),
                    TypeParam::dimension * gradient(0), 1e-4);
    });
}

} // namespace
} // namespace meniscus
