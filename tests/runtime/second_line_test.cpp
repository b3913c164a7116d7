// The second line of a classifier against features by the list, and boundary particles in both.
#include <meniscus/runtime/features/check_neighborhood.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <gtest/gtest.h>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace meniscus {
namespace {

/// Random fluid around the origin, where particle 0 lies, and a layer of boundary particles beside.
template <class Real, int Dimension>
struct Beside {
    std::vector<Real> positions;
    std::vector<Real> masses;
    std::vector<Real> radii;
    std::vector<Real> wall;
    std::vector<Real> weights;

    Beside(std::size_t count, std::size_t boundary, unsigned seed, Real h, bool vary) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(0, 1);
        const auto place = [&](std::vector<Real>& to, bool below) {
            for (int axis = 0; axis < Dimension; ++axis)
                to.push_back(static_cast<Real>(
                    (axis == 0 && below ? -0.5 : 2 * unit(random) - 0.8) * double{h}));
        };
        for (std::size_t n = 0; n < count; ++n) {
            place(positions, false);
            masses.push_back(static_cast<Real>(0.5 + unit(random)));
            radii.push_back(vary ? h * static_cast<Real>(0.7 + 0.6 * unit(random)) : h);
        }
        std::fill_n(positions.begin(), Dimension, Real(0));
        for (std::size_t b = 0; b < boundary; ++b) {
            place(wall, true);
            weights.push_back(static_cast<Real>(0.5 + unit(random)));
        }
    }

    template <class Visit>
    static void visit_all(const std::vector<Real>& of, const std::vector<Real>& values,
                          const Real* center, const Visit& visit) {
        for (std::size_t j = 0; j < values.size(); ++j) {
            Coordinates<Real, Dimension> displacement;
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                displacement[axis] = of[j * Dimension + axis] - center[axis];
            visit(j, displacement, values[j]);
        }
    }

    [[nodiscard]] auto view() const {
        return [this](std::size_t i, auto&& visit) {
            visit_all(positions, masses, &positions[i * Dimension], visit);
        };
    }
    [[nodiscard]] auto boundary() const {
        const auto view = [this](std::size_t i, auto&& visit) {
            visit_all(wall, weights, &positions[i * Dimension], visit);
        };
        return BoundaryView<decltype(view)>{view};
    }
};

/// The neighbors of particle 0 in double, boundary particles with the mean mass of the others.
template <int Dimension, class Real, class Radii>
std::vector<FeatureNeighbor<double, Dimension>>
neighbors_of_first(const Beside<Real, Dimension>& some, const Radii& radii) {
    const auto range = range_of(radii, 0.8);
    std::vector<FeatureNeighbor<double, Dimension>> found;
    double mass = 0, count = 0;
    const auto add = [&](const auto& one, double weight) {
        FeatureNeighbor<double, Dimension> neighbor;
        for (int axis = 0; axis < Dimension; ++axis)
            neighbor.step[axis] = double{one.step[axis]};
        neighbor.squared = double{one.squared};
        neighbor.mass = weight > 0 ? weight * (count > 0 ? mass / count : 1) : double{one.mass};
        neighbor.count = weight > 0 ? weight : double{one.count};
        found.push_back(neighbor);
    };
    some.view()(0, [&](std::size_t j, const auto& displacement, Real its_mass) {
        visit_if_in_range<Dimension>(displacement, its_mass, 0, j, radii, range,
                                     [&](const auto& one) { add(one, 0); });
    });
    for (const auto& one : found) {
        mass += one.mass;
        count += one.count;
    }
    some.boundary()(0, [&](std::size_t, const auto& displacement, Real weight) {
        visit_if_in_range<Dimension>(displacement, Real(1), 0, 0, radii, range,
                                     [&](const auto& one) { add(one, double{weight}); });
    });
    return found;
}

/// Lines of all pairs just above and just below the particle decide as they must.
template <int Dimension, class Real, class Radii>
void expect_lines_decide(const Beside<Real, Dimension>& some, const Radii& radii) {
    const auto neighbors = neighbors_of_first<Dimension>(some, radii);
    ASSERT_GT(neighbors.size(), 3U);
    GatheredNeighbors gathered;
    for (std::size_t a = 0; a < feature_count; ++a)
        for (std::size_t b = 0; b < feature_count; ++b) {
            if (a == b)
                continue;
            const auto value = [&](std::size_t f) {
                return feature_value<double, Dimension>(f, neighbors.data(), neighbors.size());
            };
            const double x = value(a), y = value(b);
            const double k = 3;
            const double margin =
                2 * (k * feature_list[a].float_error * std::max(1.0, std::abs(x)) +
                     feature_list[b].float_error * std::max(1.0, std::abs(y)));
            for (const bool above : {false, true})
                for (const double side : {-1.0, 1.0}) {
                    const SecondLine line{true, a, b, k, y - k * x + side * margin, above};
                    EXPECT_EQ((is_surface<Dimension>(some.view(), some.boundary(), 0, radii, line,
                                                     0.8, gathered)),
                              above ? side < 0 : side > 0)
                        << feature_list[a].name << " " << feature_list[b].name;
                }
        }
}

template <class Real>
class SecondLines : public testing::Test {};
using RealTypes = testing::Types<float, double>;
TYPED_TEST_SUITE(SecondLines, RealTypes);

template <class Real, int Dimension>
void expect_lines_decide() {
    for (const std::size_t count : {12U, 60U, 140U})
        for (const Real h : {Real(1), Real(0.025)})
            for (const bool vary : {false, true}) {
                const Beside<Real, Dimension> some(count, 20, 7 + count, h, vary);
                if (vary)
                    expect_lines_decide<Dimension>(some, VaryingRadii<Real>{some.radii.data()});
                else
                    expect_lines_decide<Dimension>(some, UniformRadius<Real>{h});
            }
}

TYPED_TEST(SecondLines, DecideByAnyTwoFeaturesBesideABoundary) {
    expect_lines_decide<TypeParam, 2>();
    expect_lines_decide<TypeParam, 3>();
}

/// Both lines and a boundary, as a header has them.
struct SecondInPlane {
    static constexpr const char* features[] = {"direction_offset", "direction_eigenvalue"};
    static constexpr bool surface_above = false;
    static constexpr double k = 20;
    static constexpr double d = 30;
    static constexpr int dimension = 2;
};
struct SecondInSpace {
    static constexpr const char* features[] = {"direction_offset", "direction_eigenvalue"};
    static constexpr bool surface_above = false;
    static constexpr double k = 20;
    static constexpr double d = 10;
    static constexpr int dimension = 3;
};
template <int D>
struct Cascade {
    static constexpr double k = D == 3 ? 200 : 250;
    static constexpr double d = D == 3 ? 40 : 90;
    static constexpr int dimension = D;
    static constexpr double radius_ratio = 0.8;
    static constexpr double boundary_weight = 1;
    using SecondLine = std::conditional_t<D == 2, SecondInPlane, SecondInSpace>;
};

/// The stages of a step, the function for hosts that only classify, and each line by itself.
template <class Real, int Dimension>
void expect_entries_agree() {
    using Lines = Cascade<Dimension>;
    const Beside<Real, Dimension> some(300, 60, 3, Real(0.5), false);
    const std::size_t count = some.masses.size();
    const UniformRadius<Real> radii{Real(0.5)};
    SurfaceTensionOptions options;
    set_classifier<Lines>(options);
    EXPECT_EQ(options.boundary_weight, 1);
    SurfaceTension<Real, Dimension> tension(options);
    std::vector<std::uint8_t> surface(count), first(count);
    std::vector<std::uint32_t> counts(count);
    const auto range = range_of(radii, 0.8);
    for (const bool has_boundary : {false, true}) {
        std::size_t found = 0;
        if (has_boundary) {
            tension.step(some.view(), some.boundary(), count, radii, nullptr, SerialLoop{});
            found = classify<Lines, Real, Dimension>(some.view(), some.boundary(), 0, count, radii,
                                                     1.0, surface.data());
        } else {
            tension.step(some.view(), count, radii, SerialLoop{});
            found = classify<Lines, Real, Dimension>(some.view(), 0, count, radii.radius,
                                                     surface.data());
        }
        EXPECT_EQ(tension.surface().size(), found);
        std::size_t by_first = 0;
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(tension.surface().slot_of[i] >= 0, surface[i] != 0) << i;
            const auto sum = sum_features_reference<Real, Dimension>(some.view(), i, range);
            const auto all = has_boundary ? with_boundary(sum, some.boundary(), i, range)
                                          : with_boundary(sum, NoBoundary{}, i, range);
            first[i] = is_surface(all, surface_line<Lines, Real>(), radii.radius) ? 1 : 0;
            counts[i] = static_cast<std::uint32_t>(sum.count);
            by_first += first[i];
        }
        EXPECT_LT(found, by_first); // the second line keeps fewer
        EXPECT_GT(found, 0U);
        // A host that applied the first line in its density loop gets the same.
        if (has_boundary) {
            tension.step(some.view(), some.boundary(), count, radii, nullptr, first.data(),
                         counts.data(), SerialLoop{});
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_EQ(tension.surface().slot_of[i] >= 0, surface[i] != 0) << i;
        }
    }
}

TYPED_TEST(SecondLines, AreTheSameWhicheverWayAHostAsks) {
    expect_entries_agree<TypeParam, 2>();
    expect_entries_agree<TypeParam, 3>();
}

/// A boundary that only covers leaves the candidates alone.
TEST(SecondLine, LeavesOutABoundaryThatOnlyCovers) {
    const Beside<double, 3> some(200, 60, 5, 0.5, false);
    SurfaceTensionOptions options;
    set_classifier<Cascade<3>>(options);
    options.boundary_weight = 0;
    SurfaceTension<double, 3> tension(options);
    const UniformRadius<double> radii{0.5};
    tension.step(some.view(), some.boundary(), 200, radii, nullptr, SerialLoop{});
    const auto beside = tension.surface().particle;
    tension.step(some.view(), 200, radii, SerialLoop{});
    EXPECT_EQ(tension.surface().particle, beside);
    EXPECT_GT(beside.size(), 0U);
}

TEST(SecondLine, IsCheckedWithTheOptions) {
    SurfaceTensionOptions options;
    set_classifier<Cascade<3>>(options);
    options.second_line.y = feature_count;
    EXPECT_THROW((SurfaceTension<float, 3>(options)), std::invalid_argument);
    options.second_line.y = options.second_line.x;
    EXPECT_THROW((SurfaceTension<float, 3>(options)), std::invalid_argument);
    set_classifier<Cascade<3>>(options);
    options.second_line.k = std::numeric_limits<double>::infinity();
    EXPECT_THROW((SurfaceTension<float, 3>(options)), std::invalid_argument);
}

template <int Dimension>
void expect_pivots_agree() {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    constexpr int entries = matrix_terms<Dimension>;
    for (int n = 0; n < 2000; ++n) {
        double matrix[entries];
        for (double& entry : matrix)
            entry = normal(random);
        const double smallest = min_eigenvalue<Dimension>(matrix);
        EXPECT_TRUE(is_min_eigenvalue_above<Dimension>(matrix, smallest - 1e-6));
        EXPECT_FALSE(is_min_eigenvalue_above<Dimension>(matrix, smallest + 1e-6));
    }
}

TEST(SecondLine, PivotsTellTheSmallestEigenvalue) {
    expect_pivots_agree<2>();
    expect_pivots_agree<3>();
}

/// A block of particles one apart with lists of those closer than h, and what is done to them.
struct Block {
    std::vector<double> positions;
    std::vector<std::vector<std::uint32_t>> lists;

    Block(int edge, double h) {
        for (int n = 0; n < edge * edge * edge; ++n)
            for (const int at : {n % edge, n / edge % edge, n / edge / edge})
                positions.push_back(at);
        lists.resize(positions.size() / 3);
        for (std::uint32_t i = 0; i < lists.size(); ++i)
            for (std::uint32_t j = 0; j < lists.size(); ++j)
                if (std::hypot(positions[3 * i] - positions[3 * j],
                               positions[3 * i + 1] - positions[3 * j + 1],
                               positions[3 * i + 2] - positions[3 * j + 2]) < h)
                    lists[i].push_back(j); // itself, too
    }

    [[nodiscard]] std::string fault(double h, double spacing_ratio) const {
        const auto view = [this](std::size_t i, auto&& visit) {
            for (const std::uint32_t j : lists[i]) {
                Coordinates<double, 3> displacement;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    displacement[axis] = positions[3 * j + axis] - positions[3 * i + axis];
                visit(std::size_t{j}, displacement, 1.0);
            }
        };
        try {
            check_lists<double, 3>(view, lists.size(), UniformRadius<double>{h});
            check_spacing_ratio<double, 3>(view, lists.size(), UniformRadius<double>{h},
                                           spacing_ratio);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    }
};

TEST(CheckNeighborhood, FindsListsThatAreNotWhole) {
    const Block good(9, 2.1);
    EXPECT_EQ(good.fault(2.1, 2), "");
    EXPECT_EQ(good.fault(2.1, 2.1), "");
    Block half = good;
    for (std::uint32_t i = 0; i < half.lists.size(); ++i)
        half.lists[i].erase(std::upper_bound(half.lists[i].begin(), half.lists[i].end(), i),
                            half.lists[i].end());
    EXPECT_NE(half.fault(2.1, 2).find("not in that of the other"), std::string::npos);
    Block twice = good;
    twice.lists[5].push_back(twice.lists[5].back());
    EXPECT_NE(twice.fault(2.1, 2).find("particle 5 has"), std::string::npos);
    EXPECT_NE(twice.fault(2.1, 2).find("more than once"), std::string::npos);
    Block lost = good;
    lost.lists[40].pop_back();
    EXPECT_NE(lost.fault(2.1, 2), "");
    Block far = good;
    far.lists[7].push_back(700); // beyond the support radius: no matter
    EXPECT_EQ(far.fault(2.1, 2), "");
}

TEST(CheckNeighborhood, FindsARadiusOfAnotherRatio) {
    const Block good(12, 3.46);
    EXPECT_EQ(good.fault(3.46, 3.46), "");
    EXPECT_NE(good.fault(3.46, 2).find("spacing_ratio is 2,"), std::string::npos);
    EXPECT_NE(good.fault(3.46 / 2, 3.46).find("spacing_ratio is 3.46"), std::string::npos);
}

} // namespace
} // namespace meniscus
