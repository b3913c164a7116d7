// Normals are as accurate as docs/normals.md says, on fewer clouds than there.
#include "normals/normal_cases.hpp"
#include "normals/normal_schemes.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

using PassErrors = std::array<double, circle_passes>;

/// Mean distances on circles after no, one and two smoothing passes.
template <class Fill>
PassErrors circle_errors(const SurfaceTensionOptions& options, const Fill& fill) {
    static const std::vector<NormalCase> cases = {circle_case(4, 1), circle_case(4, 2)};
    std::array<Spread, circle_passes> errors;
    SurfaceParticles<double, 2> list;
    std::vector<std::array<double, 2>> before;
    SampleDirections directions;
    for (std::size_t seed = 0; seed < cases.size(); ++seed) {
        fill(seed, directions);
        expose<2>(cases[seed], directions, options, list);
        for (std::size_t pass = 0; pass < circle_passes; ++pass) {
            if (pass > 0)
                smooth_normals<double, 2>(0.5, SerialLoop{}, list, before);
            errors[pass].add(distance_error<2>(cases[seed], list));
        }
    }
    return {errors[0].mean(), errors[1].mean(), errors[2].mean()};
}

PassErrors outward_circle_errors(std::size_t samples) {
    return circle_errors({}, [=](std::size_t seed, SampleDirections& directions) {
        fill_outward_directions<2>(samples, seed, directions);
    });
}

/// What each row of the preprint's table is divided by, without smoothing.
constexpr std::array<double, 5> wanted_lead = {2, 2, 2, 5, 10};

TEST(CircleNormals, BeatThePreprintsTable) {
    for (std::size_t row = 0; row < circle_sample_counts.size(); ++row) {
        SCOPED_TRACE(circle_sample_counts[row]);
        const auto errors = outward_circle_errors(circle_sample_counts[row]);
        EXPECT_LT(errors[0], preprint_circle_errors[row][0] / wanted_lead[row]);
        EXPECT_LT(errors[1], preprint_circle_errors[row][1] / 2);
        EXPECT_LT(errors[2], preprint_circle_errors[row][2] / 2);
    }
}

TEST(CircleNormals, FallFasterThanThoseOfRandomDirections) {
    const double decay = std::log(outward_circle_errors(500)[0] / outward_circle_errors(10)[0]);
    EXPECT_LT(decay / std::log(50), -0.8);
}

TEST(CircleNormals, OfRandomDirectionsAreThePreprints) {
    SurfaceTensionOptions as_published;
    as_published.verification = Verification::drop;
    for (std::size_t row = 0; row < circle_sample_counts.size(); ++row) {
        const auto errors =
            circle_errors(as_published, [=](std::size_t seed, SampleDirections& directions) {
                fill_from_scheme("random", 2, circle_sample_counts[row], seed, directions);
            });
        EXPECT_NEAR(errors[0] / preprint_circle_errors[row][0], 1, 0.25)
            << circle_sample_counts[row];
    }
}

TEST(CircleNormals, AreExactWhereCoverageIs) {
    SurfaceTensionOptions exact;
    exact.coverage = CoverageMethod::exact;
    EXPECT_LT(circle_errors(exact, [](std::size_t, SampleDirections&) {})[0], 0.002);
}

/// Mean angle in degrees on saddles, without smoothing.
double saddle_error(const std::string& scheme, std::size_t samples) {
    static const std::vector<NormalCase> cases = {saddle_case(2, 1), saddle_case(2, 2)};
    Spread error;
    SurfaceParticles<double, 3> list;
    SampleDirections directions;
    for (std::size_t seed = 0; seed < cases.size(); ++seed) {
        normal_scheme(scheme).fill(samples, seed, directions);
        normal_scheme(scheme).expose(cases[seed], seed, directions, list);
        error.add(angular_error<3>(cases[seed], list));
    }
    return error.mean();
}

TEST(SaddleNormals, AreWithinFiveDegreesFromSixtySamples) {
    EXPECT_LT(saddle_error("outward", 60), 5);
}

TEST(SaddleNormals, AreWithinTwoDegreesWhereCoverageIsExact) {
    EXPECT_LT(saddle_error("exact", 0), 2);
}

TEST(SaddleNormals, TakeLessThanHalfOfHaltonsSamples) {
    for (const std::size_t samples : {30, 60, 120})
        EXPECT_LT(saddle_error("outward", samples), saddle_error("Halton 2-3", 2 * samples));
}

TEST(SaddleNormals, OfPublishedSchemesAreThePapers) {
    EXPECT_NEAR(saddle_error("random", 360), 4.7, 0.5); // "just below 5 degrees"
    EXPECT_NEAR(saddle_error("Halton 2-3", 120), 4.7, 0.5);
}

} // namespace
} // namespace meniscus
