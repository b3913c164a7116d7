// Surfaces that meet a wall: at the contact angle nothing bends them.
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace meniscus {
namespace {

/// A lattice of fluid on a wall, cut off by a plane that meets the wall at an angle, as lists of
/// all neighbors within a radius of two spacings. Lengths in spacings; the wall is y = -1, the
/// mirror between it and the fluid -1/2, where the plane meets it at x = 0.
template <class Real, int Dimension>
struct Wedge {
    static constexpr double h = 2;
    std::vector<Coordinates<Real, Dimension>> fluid, boundary;
    Coordinates<double, Dimension> outward{};

    explicit Wedge(double degrees) {
        constexpr int reach = Dimension == 3 ? 8 : 12;
        constexpr int depth = Dimension == 3 ? 8 : 0;
        const double theta = degrees * pi / 180;
        outward[0] = std::sin(theta);
        outward[1] = std::cos(theta);
        const double along[2] = {-std::cos(theta), std::sin(theta)}; // up the surface
        for (int z = -depth; z <= depth; ++z) {
            // Rows along the surface, so that it is flat.
            for (int row = 0; row < reach; ++row)
                for (int place_in_row = -3 * reach; place_in_row < 3 * reach; ++place_in_row) {
                    const double u = place_in_row + 0.5;
                    const double w = row + 0.5;
                    add_fluid(u * along[0] - w * outward[0], -0.5 + u * along[1] - w * outward[1],
                              z, reach);
                }
            for (int x = -2 * reach; x <= 2 * reach; ++x)
                boundary.push_back(place(x, -1, z));
        }
    }

    static Coordinates<Real, Dimension> place(double x, double y, double z) {
        Coordinates<Real, Dimension> made{static_cast<Real>(x), static_cast<Real>(y)};
        if constexpr (Dimension == 3)
            made[Dimension - 1] = static_cast<Real>(z);
        return made;
    }

    void add_fluid(double x, double y, double z, double reach) {
        if (y > -0.5 && y < reach && std::abs(x) < 2 * reach)
            fluid.push_back(place(x, y, z));
    }

    template <class Visit>
    void visit(const std::vector<Coordinates<Real, Dimension>>& others, std::size_t i,
               const Visit& visit) const {
        for (std::size_t j = 0; j < others.size(); ++j) {
            Coordinates<Real, Dimension> displacement;
            Real squared = 0;
            for (std::size_t axis = 0; axis < Dimension; ++axis) {
                displacement[axis] = others[j][axis] - fluid[i][axis];
                squared += displacement[axis] * displacement[axis];
            }
            if (squared < static_cast<Real>(h * h))
                visit(j, displacement, Real(1));
        }
    }

    SurfaceTension<Real, Dimension> stepped(const SurfaceTensionOptions& options,
                                            const float* angles = nullptr) const {
        SurfaceTension<Real, Dimension> tension(options);
        const auto view = [&](std::size_t i, const auto& visitor) { visit(fluid, i, visitor); };
        const auto walls = [&](std::size_t i, const auto& visitor) { visit(boundary, i, visitor); };
        tension.step(view, BoundaryView<decltype(walls)>{walls, angles}, fluid.size(),
                     UniformRadius<Real>{static_cast<Real>(h)}, nullptr, SerialLoop{});
        return tension;
    }

    /// Of surface particles on the plane, at most h from the wall and not at the lattice's ends.
    [[nodiscard]] bool is_watched(std::size_t i) const {
        const auto x = static_cast<double>(fluid[i][0]);
        const double y = static_cast<double>(fluid[i][1]) + 0.5;
        const bool in_the_middle =
            Dimension == 2 || std::abs(static_cast<double>(fluid[i][Dimension - 1])) < 2.5;
        const double below = -(x * outward[0] + y * outward[1]);
        return below < 0.6 && y < h && in_the_middle;
    }
};

SurfaceTensionOptions exact_options(double contact_angle) {
    SurfaceTensionOptions options;
    options.coverage = CoverageMethod::exact;
    options.contact_angle = contact_angle;
    return options;
}

/// How far normals near the contact line are off, in degrees, and the largest |h kappa| there.
template <class Real, int Dimension>
std::pair<double, double> errors_at(const Wedge<Real, Dimension>& wedge,
                                    const SurfaceTensionOptions& options,
                                    const float* angles = nullptr) {
    const auto tension = wedge.stepped(options, angles);
    const auto& surface = tension.surface();
    double max_turn = 0, max_curvature = 0;
    int watched = 0;
    for (std::size_t slot = 0; slot < surface.size(); ++slot) {
        if (surface.surface_class[slot] != SurfaceClass::surface ||
            !wedge.is_watched(surface.particle[slot]))
            continue;
        ++watched;
        double cosine = 0;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            cosine += static_cast<double>(surface.normal[slot][axis]) * wedge.outward[axis];
        max_turn = (std::max)(max_turn, std::acos((std::min)(cosine, 1.0)) * 180 / pi);
        max_curvature = (std::max)(
            max_curvature, std::abs(static_cast<double>(surface.curvature[slot])) * wedge.h);
    }
    EXPECT_GE(watched, Dimension == 2 ? 1 : 5);
    return {max_turn, max_curvature};
}

template <class Real, int Dimension>
void expect_flat_at_right_angle() {
    const Wedge<Real, Dimension> wedge(90);
    const auto [turn, curvature] = errors_at(wedge, exact_options(90));
    EXPECT_LT(turn, 0.05); // an arc cosine near 1 in float
    EXPECT_LT(curvature, 1e-3);
}

TEST(WallContact, ALevelSurfaceAtARightAngleStaysFlat) {
    expect_flat_at_right_angle<float, 2>();
    expect_flat_at_right_angle<double, 2>();
    expect_flat_at_right_angle<float, 3>();
    expect_flat_at_right_angle<double, 3>();
}

TEST(WallContact, NothingBendsASurfaceAtItsContactAngle) {
    for (const double degrees : {45.0, 60.0, 75.0, 105.0, 120.0, 135.0}) {
        SCOPED_TRACE(degrees);
        const auto [turn, curvature] = errors_at(Wedge<double, 2>(degrees), exact_options(degrees));
        EXPECT_LT(turn, 15); // the wall cuts the rows of the lattice off
        EXPECT_LT(curvature, 0.2);
    }
}

TEST(WallContact, AnotherAngleBendsTheSurfaceTowardsIt) {
    const Wedge<double, 2> wedge(90);
    const auto curvature_for = [&](double angle) {
        const auto tension = wedge.stepped(exact_options(angle));
        double sum = 0;
        for (std::size_t slot = 0; slot < tension.surface().size(); ++slot)
            if (wedge.is_watched(tension.surface().particle[slot]))
                sum += tension.surface().curvature[slot];
        return sum;
    };
    EXPECT_LT(curvature_for(60), -0.1); // concave: pulled out along the wall
    EXPECT_GT(curvature_for(120), 0.1);
}

TEST(WallContact, BoundaryParticlesMayHaveAnglesOfTheirOwn) {
    const Wedge<double, 2> wedge(60);
    const std::vector<float> angles(wedge.boundary.size(), 60);
    EXPECT_EQ(errors_at(wedge, exact_options(120), angles.data()),
              errors_at(wedge, exact_options(60)));
}

TEST(WallContact, AFilmThatLiesOnAWallHasNoContactLine) {
    Wedge<double, 2> film(90);
    film.fluid.clear();
    for (int x = -20; x <= 20; ++x)
        for (int y = 0; y < 2; ++y)
            film.fluid.push_back({x + 0.0, y + 0.0});
    for (const double angle : {20.0, 90.0, 160.0}) {
        const auto tension = film.stepped(exact_options(angle));
        for (std::size_t slot = 0; slot < tension.surface().size(); ++slot) {
            const auto& place = film.fluid[tension.surface().particle[slot]];
            if (tension.surface().surface_class[slot] != SurfaceClass::surface ||
                std::abs(place[0]) > 10)
                continue;
            EXPECT_NEAR(tension.surface().normal[slot][1], 1, 1e-9);
            EXPECT_NEAR(tension.surface().curvature[slot], 0, 1e-9);
        }
    }
}

TEST(WallContact, RefusesAnglesOutOfRange) {
    for (const double angle : {9.0, 171.0, -60.0})
        EXPECT_THROW((SurfaceTension<double, 2>(exact_options(angle))), std::invalid_argument);
}

} // namespace
} // namespace meniscus
