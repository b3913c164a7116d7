// The step as a whole: it bears whatever comes, and no result depends on how the work was spread.
#include "fluids.hpp"
#include "option_values.hpp"
#include "threaded_loop.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <numeric>
#include <string>

namespace meniscus {
namespace {

template <class Real, int Dimension>
using Places = std::vector<std::array<Real, Dimension>>;

template <class Number>
class SurfaceTensionStep : public ::testing::Test {};

struct Float2 {
    using Real = float;
    static constexpr int dimension = 2;
};
struct Float3 {
    using Real = float;
    static constexpr int dimension = 3;
};
struct Double2 {
    using Real = double;
    static constexpr int dimension = 2;
};
struct Double3 {
    using Real = double;
    static constexpr int dimension = 3;
};
using Kinds = ::testing::Types<Float2, Float3, Double2, Double3>;
TYPED_TEST_SUITE(SurfaceTensionStep, Kinds);

/// Both forces and curvatures, both ways of coverage, with and without what else there is.
template <int Dimension>
std::vector<SurfaceTensionOptions> all_options() {
    std::vector<SurfaceTensionOptions> all = {options_for<Dimension>(),
                                              options_for<Dimension>(paper_options())};
    all.push_back(all[0]);
    all.back().coverage = CoverageMethod::exact;
    all.back().covariance_share = 0.5;
    all.back().curvature_passes = 2;
    all.push_back(all[0]);
    all.back().curvature = CurvatureForm::closed;
    all.back().fade = 0;
    all.back().normal_passes = 3;
    all.back().tau = 1;
    all.push_back(all[1]);
    all.back().covariance_share = 1;
    all.back().tau = 0;
    return all;
}

template <class Real, std::size_t Size>
bool is_finite_vector(const std::array<Real, Size>& vector) {
    return std::all_of(vector.begin(), vector.end(), [](Real v) { return is_finite(v); });
}

template <class Real, int Dimension>
void expect_finite(const SurfaceParticles<Real, Dimension>& found) {
    for (std::size_t slot = 0; slot < found.size(); ++slot) {
        ASSERT_TRUE(is_finite_vector(found.normal[slot])) << slot;
        ASSERT_TRUE(is_finite_vector(found.force[slot])) << slot;
        for (const auto* values :
             {&found.uncovered_fraction, &found.exposure, &found.weight, &found.curvature})
            ASSERT_TRUE(is_finite((*values)[slot])) << slot;
        ASSERT_GE(found.uncovered_fraction[slot], 0);
        ASSERT_LE(found.uncovered_fraction[slot], 1);
        ASSERT_NE(found.surface_class[slot], SurfaceClass::interior);
    }
}

/// Runs a fluid with all options; nothing may become NaN or infinite.
template <class Real, int Dimension>
void expect_finite_results(const Fluid<Real, Dimension>& fluid, const char* name) {
    SCOPED_TRACE(name);
    for (const auto& options : all_options<Dimension>()) {
        SurfaceTension<Real, Dimension> tension(options);
        tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
        expect_finite(tension.surface());
        tension.template balance_momentum<Dimension>(fluid.view(), NoBoundary{}, fluid.radii(),
                                                     fluid.coordinates(), SerialLoop{});
        expect_finite(tension.surface());
    }
}

TYPED_TEST(SurfaceTensionStep, DegenerateFluidsGiveNumbers) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    using Vector = std::array<Real, dimension>;
    const auto along = [](Real x) {
        Vector place{};
        place[0] = x;
        return place;
    };
    expect_finite_results(Fluid<Real, dimension>{}, "no particle");
    expect_finite_results(Fluid<Real, dimension>({along(3)}, 1), "isolated");
    expect_finite_results(Fluid<Real, dimension>({along(0), along(Real(0.5))}, 1), "pair");
    expect_finite_results(Fluid<Real, dimension>(Places<Real, dimension>(300, along(2)), 1),
                          "one place");
    expect_finite_results(Fluid<Real, dimension>({along(0), along(1)}, 1), "pair at exactly h");
    expect_finite_results(block<Real, dimension>({40, 1, 1}), "filament");
    expect_finite_results(block<Real, dimension>({12, 12, 1}), "sheet");
    expect_finite_results(block<Real, dimension>({12, 12, 2}), "sheet of two layers");
    expect_finite_results(block<Real, dimension>({9, 9, 9}), "lattice");
    expect_finite_results(ball<Real, dimension>(4, 0.3), "jittered");

    auto many = ball<Real, dimension>(dimension == 3 ? 6 : 20, 0.4).positions;
    for (auto& place : many) // more than a thousand within h of each
        for (Real& coordinate : place)
            coordinate *= dimension == 3 ? Real(0.13) : Real(0.04);
    expect_finite_results(Fluid<Real, dimension>(std::move(many), 1), "many neighbors");
}

/// Whatever the unit of length, down to where squares vanish, which is refused: all distances would
/// be 0, and everything surface.
TYPED_TEST(SurfaceTensionStep, AbsurdScalesGiveNumbers) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    for (const double radius : {1e9, 1e-9, 1e-15, 1e15})
        expect_finite_results(ball<Real, dimension>(3, 0.2, radius),
                              ("radius " + std::to_string(radius)).c_str());
    const auto min = static_cast<double>(std::numeric_limits<Real>::min());
    for (const double radius : {16 * min, 1 / (16 * min)}) {
        const auto fluid = ball<Real, dimension>(3, 0.2, radius);
        SurfaceTension<Real, dimension> tension(options_for<dimension>());
        EXPECT_THROW(tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{}),
                     std::invalid_argument);
    }
    auto close = Fluid<Real, dimension>(Places<Real, dimension>(20), 1);
    close.positions[3][0] = std::numeric_limits<Real>::denorm_min();
    expect_finite_results(close, "denormal distances");
}

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

template <class Real, int Dimension>
void expect_same(const SurfaceParticles<Real, Dimension>& a,
                 const SurfaceParticles<Real, Dimension>& b) {
    EXPECT_EQ(a.particle, b.particle);
    EXPECT_EQ(a.slot_of, b.slot_of);
    EXPECT_EQ(a.surface_class, b.surface_class);
    EXPECT_TRUE(same_bits(a.uncovered_fraction, b.uncovered_fraction));
    EXPECT_TRUE(same_bits(a.normal, b.normal));
    EXPECT_TRUE(same_bits(a.curvature, b.curvature));
    EXPECT_TRUE(same_bits(a.force, b.force));
}

/// A step and its balance; the surface is returned by copy.
template <class Real, int Dimension, class Loop>
SurfaceParticles<Real, Dimension> surface_of(const Fluid<Real, Dimension>& fluid,
                                             const SurfaceTensionOptions& options,
                                             const Loop& loop) {
    SurfaceTension<Real, Dimension> tension(options);
    tension.step(fluid.view(), fluid.size(), fluid.radii(), loop);
    tension.template balance_momentum<Dimension>(fluid.view(), NoBoundary{}, fluid.radii(),
                                                 fluid.coordinates(), loop);
    return tension.surface();
}

template <class Real, int Dimension>
Fluid<Real, Dimension> droplet() {
    return ball<Real, Dimension>(Dimension == 3 ? 6 : 14, 0.2);
}

TYPED_TEST(SurfaceTensionStep, SameBitsWhateverTheLoop) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const auto fluid = droplet<Real, dimension>();
    for (const auto& options : all_options<dimension>()) {
        // Another kind of loop is other code, in which -ffast-math and contraction may round
        // otherwise.
        const auto expected = surface_of(fluid, options, ThreadedLoop{1, fluid.size() + 1});
        ASSERT_GT(expected.size(), 50U);
        for (const ThreadedLoop loop : {ThreadedLoop{1, 1}, {2, 7}, {3, 16}, {4, 1000}})
            expect_same(surface_of(fluid, options, loop), expected);
#if !defined(__FAST_MATH__) && !defined(__FMA__)
        expect_same(surface_of(fluid, options, SerialLoop{}), expected);
#if defined(_OPENMP)
        for (const int threads : {1, 2, 3, 4})
            expect_same(surface_of(fluid, options, OpenMpLoop{threads}), expected);
#endif
#endif
    }
}

/// The memory of one step serves the next.
TYPED_TEST(SurfaceTensionStep, StepsDoNotDependOnEarlierOnes) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const auto fluid = droplet<Real, dimension>();
    const auto other = block<Real, dimension>({5, 7, 9});
    SurfaceTension<Real, dimension> tension(options_for<dimension>());
    tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    const auto first = tension.surface();
    tension.step(other.view(), other.size(), other.radii(), SerialLoop{});
    tension.set_samples(16);
    tension.set_samples(64);
    tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    expect_same(tension.surface(), first);
}

/// Where a host sorts its particles, each keeps its samples by its id.
TYPED_TEST(SurfaceTensionStep, PermutedParticlesKeepTheirResults) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const auto fluid = droplet<Real, dimension>();
    std::vector<std::uint32_t> ids(fluid.size());
    std::iota(ids.begin(), ids.end(), 0U);
    Numbers numbers(3);
    for (std::size_t i = ids.size() - 1; i > 0; --i)
        std::swap(ids[i],
                  ids[static_cast<std::size_t>(numbers.next() * static_cast<double>(i + 1))]);
    Places<Real, dimension> places;
    for (const std::uint32_t id : ids)
        places.push_back(fluid.positions[id]);
    const Fluid<Real, dimension> permuted(std::move(places), 1);

    const auto options = options_for<dimension>();
    const auto tolerance = sizeof(Real) == sizeof(double) ? 1e-9 : 1e-4;
    SurfaceTension<Real, dimension> one(options);
    SurfaceTension<Real, dimension> two(options);
    one.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    two.step(permuted.view(), NoBoundary{}, permuted.size(), permuted.radii(), ids.data(),
             SerialLoop{});
    const auto& plain = one.surface();
    const auto& found = two.surface();
    ASSERT_EQ(found.size(), plain.size());
    int surface = 0;
    for (std::size_t slot = 0; slot < found.size(); ++slot) {
        const std::int32_t same = plain.slot_of[ids[found.particle[slot]]];
        ASSERT_GE(same, 0);
        EXPECT_EQ(found.surface_class[slot], plain.surface_class[same]);
        surface += found.surface_class[slot] == SurfaceClass::surface ? 1 : 0;
        // The frame of the samples turns with rounding, so a sample may fall on the other side.
        EXPECT_NEAR(found.uncovered_fraction[slot], plain.uncovered_fraction[same], tolerance);
        for (int axis = 0; axis < dimension; ++axis)
            EXPECT_NEAR(found.force[slot][axis], plain.force[same][axis], tolerance);
    }
    EXPECT_GT(surface, 20);
}

/// Without ids the samples change with the order, so that the test above says something.
/// p_0 on all of a ball's surface, whose radius is that of the particles' volume.
TYPED_TEST(SurfaceTensionStep, AmbientPressureActsOnTheWholeSurface) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const auto fluid = ball<Real, dimension>(dimension == 3 ? 8 : 16, 0);
    auto options = options_for<dimension>();
    SurfaceTension<Real, dimension> plain(options);
    options.ambient_pressure = 0.5;
    SurfaceTension<Real, dimension> in_air(options);
    plain.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    in_air.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    ASSERT_EQ(in_air.surface().particle, plain.surface().particle);
    double pressed = 0;
    for (std::size_t slot = 0; slot < plain.surface().size(); ++slot)
        for (std::size_t axis = 0; axis < dimension; ++axis)
            pressed += static_cast<double>(
                (plain.surface().force[slot][axis] - in_air.surface().force[slot][axis]) *
                plain.surface().normal[slot][axis]);
    const double volume = static_cast<double>(fluid.size()) * std::pow(0.5, dimension);
    const double radius = dimension == 3 ? std::cbrt(0.75 * volume / pi) : std::sqrt(volume / pi);
    const double area = dimension == 3 ? 4 * pi * radius * radius : 2 * pi * radius;
    const double pressure = 0.5 * (dimension - 1) * options.surface_tension;
    EXPECT_NEAR(pressed, pressure * area, 0.05 * pressure * area);
}

/// In the paper's form that is its face and weight.
TYPED_TEST(SurfaceTensionStep, AmbientPressureActsOnThePapersFaces) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const auto fluid = ball<Real, dimension>(dimension == 3 ? 5 : 10, 0.2);
    auto options = options_for<dimension>(paper_options());
    SurfaceTension<Real, dimension> plain(options);
    options.ambient_pressure = 0.5;
    SurfaceTension<Real, dimension> in_air(options);
    plain.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    in_air.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    const double face = std::pow(0.5, dimension - 1);
    const double pressure = 0.5 * (dimension - 1) * options.surface_tension;
    for (std::size_t slot = 0; slot < plain.surface().size(); ++slot)
        for (std::size_t axis = 0; axis < dimension; ++axis)
            ASSERT_NEAR(static_cast<double>(plain.surface().force[slot][axis] -
                                            in_air.surface().force[slot][axis]),
                        pressure * face *
                            static_cast<double>(plain.surface().weight[slot] *
                                                plain.surface().normal[slot][axis]),
                        1e-5 * pressure);
}

TEST(SurfaceTensionIds, KeyTheSamples) {
    const auto fluid = droplet<double, 3>();
    std::vector<std::uint32_t> ids(fluid.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
        ids[i] = static_cast<std::uint32_t>(i + 1);
    SurfaceTension<double, 3> tension(options_for<3>());
    tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    const auto plain = tension.surface();
    tension.step(fluid.view(), NoBoundary{}, fluid.size(), fluid.radii(), ids.data(), SerialLoop{});
    EXPECT_EQ(tension.surface().surface_class, plain.surface_class);
    EXPECT_FALSE(same_bits(tension.surface().uncovered_fraction, plain.uncovered_fraction));
}

TYPED_TEST(SurfaceTensionStep, HostsOwnClassificationGivesTheSame) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const auto fluid = droplet<Real, dimension>();
    const auto options = options_for<dimension>();
    SurfaceTension<Real, dimension> own(options);
    own.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});

    std::vector<std::uint8_t> candidates;
    std::vector<int> counts;
    const SurfaceLine<Real> line{static_cast<Real>(options.k), static_cast<Real>(options.d)};
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const auto sum = sum_features<Real, dimension>(
            fluid.view(), i, neighbor_range<Real>(1, options.radius_ratio));
        candidates.push_back(is_surface(sum, line, Real(1)) ? 1 : 0);
        counts.push_back(sum.count);
    }
    SurfaceTension<Real, dimension> hosts(options);
    hosts.step(fluid.view(), NoBoundary{}, fluid.size(), fluid.radii(), nullptr, candidates.data(),
               counts.data(), SerialLoop{});
    expect_same(hosts.surface(), own.surface());
}

/// A host's counts that are too small, as of a search with another radius, or its rounding, must
/// not make one particle's pairs run into those of the next.
TYPED_TEST(SurfaceTensionStep, CountsThatAreTooSmallAreBorne) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const auto fluid = droplet<Real, dimension>();
    const std::vector<std::uint8_t> candidates(fluid.size(), 1);
    const std::vector<int> counts(fluid.size(), 1);
    SurfaceTension<Real, dimension> tension(options_for<dimension>());
    tension.step(fluid.view(), NoBoundary{}, fluid.size(), fluid.radii(), nullptr,
                 candidates.data(), counts.data(), SerialLoop{});
    const auto& found = tension.surface();
    expect_finite(found);
    for (std::size_t slot = 0; slot < found.size(); ++slot)
        EXPECT_LE(found.pairs_count[slot], 1U);
}

/// View over a boundary's neighbor lists.
template <class Real, int Dimension>
struct Walls {
    const Fluid<Real, Dimension>* fluid;
    const Places<Real, Dimension>* walls;

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        for (std::size_t j = 0; j < walls->size(); ++j) {
            std::array<Real, Dimension> displacement;
            for (int axis = 0; axis < Dimension; ++axis)
                displacement[axis] = (*walls)[j][axis] - fluid->positions[i][axis];
            visit(j, displacement, Real(1));
        }
    }
};

/// A block on a wall: what faces the wall is no surface, and the body keeps its net force.
TYPED_TEST(SurfaceTensionStep, BoundaryCovers) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    Places<Real, dimension> fluid_places;
    Places<Real, dimension> wall_places;
    for (const auto& place : block<Real, dimension>({12, 12, 12}).positions)
        (place[0] < Real(1.75) ? wall_places : fluid_places).push_back(place);
    const Fluid<Real, dimension> fluid(std::move(fluid_places), 1);
    const Walls<Real, dimension> view{&fluid, &wall_places};
    const BoundaryView<Walls<Real, dimension>> boundary{view};

    SurfaceTension<Real, dimension> dry(options_for<dimension>());
    SurfaceTension<Real, dimension> wet(options_for<dimension>());
    dry.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    wet.step(fluid.view(), boundary, fluid.size(), fluid.radii(), nullptr, SerialLoop{});
    const auto is_at = [&](const auto& tension, std::size_t slot) {
        return tension.surface().surface_class[slot] == SurfaceClass::surface;
    };
    ASSERT_EQ(dry.surface().particle, wet.surface().particle);
    int changed = 0;
    for (std::size_t slot = 0; slot < dry.surface().size(); ++slot) {
        const auto& place = fluid.positions[dry.surface().particle[slot]];
        const bool inner = place[1] > Real(1.2) && place[1] < Real(4.3) &&
                           (dimension == 2 ||
                            (place[dimension - 1] > Real(1.2) && place[dimension - 1] < Real(4.3)));
        if (place[0] < Real(2.2) && inner) { // the first layer above the wall
            EXPECT_TRUE(is_at(dry, slot));
            EXPECT_FALSE(is_at(wet, slot));
            ++changed;
        } else if (place[0] > Real(3)) {
            EXPECT_EQ(is_at(dry, slot), is_at(wet, slot));
        }
    }
    EXPECT_GT(changed, 5);

    const auto before = wet.surface().force;
    wet.template balance_momentum<dimension>(fluid.view(), boundary, fluid.radii(),
                                             fluid.coordinates(), SerialLoop{});
    EXPECT_TRUE(same_bits(wet.surface().force, before));
    wet.template balance_momentum<dimension>(fluid.view(), NoBoundary{}, fluid.radii(),
                                             fluid.coordinates(), SerialLoop{});
    EXPECT_FALSE(same_bits(wet.surface().force, before));
}

/// The paper's rule can only lose surface particles; the exact way finds those of the default.
TYPED_TEST(SurfaceTensionStep, SurfaceIsCompleteWhateverTheSamples) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const auto fluid = droplet<Real, dimension>();
    auto exact = options_for<dimension>();
    exact.coverage = CoverageMethod::exact;
    auto few = options_for<dimension>();
    few.samples = 4;
    auto dropping = few;
    dropping.verification = Verification::drop;
    const auto complete = surface_of(fluid, exact, SerialLoop{}).surface_class;
    EXPECT_EQ(surface_of(fluid, few, SerialLoop{}).surface_class, complete);
    const auto dropped = surface_of(fluid, dropping, SerialLoop{}).surface_class;
    int lost = 0;
    for (std::size_t slot = 0; slot < complete.size(); ++slot) {
        EXPECT_LE(dropped[slot], complete[slot]);
        lost += dropped[slot] != complete[slot] ? 1 : 0;
    }
    EXPECT_GT(lost, 0);
}

/// What a step of a jittered ball finds, byte by byte.
template <class Real, int Dimension>
std::vector<Real> numbers_of(SurfaceTension<Real, Dimension> tension) {
    const auto fluid = ball<Real, Dimension>(Dimension == 3 ? 5 : 12, 0.2);
    tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    const auto& list = tension.surface();
    std::vector<Real> numbers(list.uncovered_fraction);
    numbers.insert(numbers.end(), list.curvature.begin(), list.curvature.end());
    for (const auto& force : list.force)
        numbers.insert(numbers.end(), force.begin(), force.end());
    return numbers;
}

TYPED_TEST(SurfaceTensionStep, DefaultsAreTheLineAndTheMapThatShip) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    using Tension = SurfaceTension<Real, dimension>;
    for (const bool paper : {false, true}) {
        const auto defaults = paper ? paper_options() : SurfaceTensionOptions{};
        auto options = defaults;
        set_shipped_classifier(options, dimension);
        options.curvature_map = shipped_curvature_map(dimension);
        const auto expected = numbers_of(Tension(options));
        EXPECT_GT(expected.size(), 100U);
        EXPECT_EQ(numbers_of(Tension(defaults)), expected);
        EXPECT_EQ(numbers_of(Tension{}) == expected, !paper);
    }
}

/// Where the line and the number of samples are such that all have something to do.
SurfaceTensionOptions busy_options() {
    auto options = options_for<3>();
    options.samples = 16;
    return options;
}

TEST(SurfaceTensionOptions, EachChangesTheResult) {
    const auto usual = numbers_of(SurfaceTension<double, 3>(busy_options()));
    for_each_surface_option([&](const auto& option) {
        auto options = busy_options();
        set_other(option, options);
        const std::string name = option.name;
        if (name == "boundary_weight" || name == "contact_angle")
            return; // there is no boundary
        EXPECT_NE(numbers_of(SurfaceTension<double, 3>(options)), usual) << option.name;
    });
}

/// That the constructor refuses the options, in these words.
void expect_refused(const SurfaceTensionOptions& options, const std::vector<std::string>& words) {
    try {
        const SurfaceTension<float, 3> tension(options);
        ADD_FAILURE() << words[0];
    } catch (const std::invalid_argument& error) {
        for (const std::string& word : words)
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
                << error.what() << ", expected " << word;
    }
}

TEST(SurfaceTensionCheck, NamesWhatIsOutOfRange) {
    EXPECT_NO_THROW((SurfaceTension<float, 3>(options_for<3>())));
    int refused = 0;
    for_each_surface_option([&](const auto& option) {
        auto words = words_of(option.range);
        words.emplace_back(option.name);
        for (const auto value : values_out_of_range(option)) {
            auto options = options_for<3>();
            options.*option.member = value;
            expect_refused(options, words);
            ++refused;
        }
    });
    EXPECT_GT(refused, 40);
    auto options = options_for<3>();
    options.curvature_map = shipped_curvature_map(2);
    expect_refused(options, {"curvature_map"});
    options.curvature = CurvatureForm::closed;
    EXPECT_NO_THROW((SurfaceTension<float, 3>(options)));
}

TEST(SurfaceTensionCheck, TakesTheEndsOfEachRange) {
    for_each_surface_option([&](const auto& option) {
        using Value = std::decay_t<decltype(std::declval<SurfaceTensionOptions>().*option.member)>;
        for (const double end : {option.range.min, option.range.max}) {
            auto options = options_for<3>();
            options.*option.member = end < 1e19 || std::is_floating_point_v<Value>
                                         ? static_cast<Value>(end)
                                         : static_cast<Value>(-1); // the largest of a seed
            EXPECT_NO_THROW(check(options, 3)) << option.name;
        }
    });
}

TEST(SurfaceTensionCheck, AmbientPressureNeedsOneRadius) {
    const auto fluid = ball<double, 3>(3, 0.2);
    auto options = options_for<3>();
    options.ambient_pressure = 0.5;
    SurfaceTension<double, 3> tension(options);
    std::vector<double> radii(fluid.size(), 1);
    const auto step = [&] {
        tension.step(fluid.view(), fluid.size(), VaryingRadii<double>{radii.data()}, SerialLoop{});
    };
    EXPECT_NO_THROW(step());
    radii[0] = 1.5;
    EXPECT_THROW(step(), std::invalid_argument);
}

TEST(SurfaceTensionCheck, HistoryHasAShareBelow1) {
    const auto fluid = ball<double, 3>(3, 0.2);
    SurfaceTension<double, 3> tension;
    TemporalCurvature<double> history;
    tension.history = &history;
    for (const double share : {-0.1, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
        history.share = share;
        EXPECT_THROW(tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{}),
                     std::invalid_argument);
    }
    history.share = 0;
    EXPECT_NO_THROW(tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{}));
}

} // namespace
} // namespace meniscus
