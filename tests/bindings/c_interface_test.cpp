// The C interface gives what the headers give, and says what is wrong.
#include "c_host.h"
#include "hosts.hpp"
#include "runtime/option_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <sys/resource.h>

namespace meniscus {
namespace {

using Surface = std::unique_ptr<meniscus_surface, decltype(&meniscus_destroy)>;

Surface create(const meniscus_options& options, int dimension, int precision) {
    meniscus_surface* surface = nullptr;
    EXPECT_EQ(meniscus_create(&surface, &options, dimension, precision), MENISCUS_OK)
        << meniscus_last_error();
    return {surface, meniscus_destroy};
}

meniscus_results results_of(const meniscus_surface* surface) {
    meniscus_results results{};
    results.size = sizeof results;
    EXPECT_EQ(meniscus_get_results(surface, &results), MENISCUS_OK);
    return results;
}

TEST(CInterface, ServesAHostInC) {
    const char* wrong = run_c_host();
    EXPECT_EQ(wrong, nullptr) << wrong;
}

/// The same from the headers.
template <class Real, int Dimension>
Found found_in_cpp(const SurfaceParticles<Real, Dimension>& list) {
    meniscus_results results{};
    results.slots = list.size();
    results.particle = list.particle.data();
    results.surface_class = reinterpret_cast<const std::uint8_t*>(list.surface_class.data());
    results.uncovered_fraction = list.uncovered_fraction.data();
    results.normal = list.normal.data();
    results.curvature = list.curvature.data();
    results.force = list.force.data();
    return Found::of<Real>(results, Dimension);
}

/// Strides, widths of offsets, ids, momentum and numbers of threads.
template <class Real, int Dimension>
void compare_with_headers(bool paper) {
    const auto fluid = ball<Real, Dimension>(Dimension == 3 ? 5 : 12, 0.2);
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < fluid.size(); ++i)
        ids.push_back(static_cast<std::uint32_t>(7 * i + 3));
    SurfaceTension<Real, Dimension> tension(
        options_for<Dimension>(paper ? paper_options() : SurfaceTensionOptions{}));
    tension.step(fluid.view(), NoBoundary{}, fluid.size(), fluid.radii(), ids.data(), SerialLoop{});
    const Found expected = found_in_cpp(tension.surface());
    tension.template balance_momentum<Dimension>(fluid.view(), NoBoundary{}, fluid.radii(),
                                                 fluid.coordinates(), SerialLoop{});
    const Found balanced = found_in_cpp(tension.surface());
    ASSERT_GT(expected.particle.size(), 50U);
    ASSERT_FALSE(expected == balanced);

    for (const std::size_t stride : {Dimension, Dimension + 1, Dimension + 2})
        for (const int bits : {32, 64})
            for (const int threads : {0, 1, 3}) {
                auto options = host_options<Dimension>(paper);
                options.threads = threads;
                const Host<Real, Dimension> host(fluid, stride);
                auto particles = host.particles(bits);
                particles.ids = ids.data();
                const auto surface = create(options, Dimension, precision_of<Real>);
                ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
                EXPECT_TRUE(Found::of<Real>(results_of(surface.get()), Dimension) == expected)
                    << stride << ' ' << bits << ' ' << threads;
                ASSERT_EQ(meniscus_balance_momentum(surface.get(), &particles), MENISCUS_OK);
                EXPECT_TRUE(Found::of<Real>(results_of(surface.get()), Dimension) == balanced)
                    << stride << ' ' << bits << ' ' << threads;
            }
}

TEST(CInterface, GivesWhatTheHeadersGive) {
    for (const bool paper : {false, true}) {
        compare_with_headers<float, 2>(paper);
        compare_with_headers<float, 3>(paper);
        compare_with_headers<double, 2>(paper);
        compare_with_headers<double, 3>(paper);
    }
}

/// Options that name no line have the one that ships for the dimension of the handle.
template <int Dimension>
void expect_shipped_line(bool paper) {
    const auto fluid = ball<double, Dimension>(Dimension == 3 ? 5 : 12, 0.2);
    const Host<double, Dimension> host(fluid);
    const auto found_by = [&](const meniscus_options& options) {
        const auto surface = create(options, Dimension, MENISCUS_DOUBLE);
        const auto particles = host.particles();
        EXPECT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
        return Found::of<double>(results_of(surface.get()), Dimension);
    };
    meniscus_options options;
    (paper ? meniscus_options_paper : meniscus_options_init)(&options, sizeof options);
    const Found found = found_by(options);
    const SurfaceTensionOptions shipped = completed({}, Dimension);
    options.k = shipped.k;
    options.d = shipped.d;
    options.boundary_weight = shipped.boundary_weight;
    EXPECT_FALSE(found == found_by(options)); // one line alone leaves more candidates
    const SecondLine& line = shipped.second_line;
    const meniscus_second_line second = {
        {feature_list[line.x].name, feature_list[line.y].name}, line.k, line.d, line.above};
    options.second_line = &second;
    EXPECT_TRUE(found == found_by(options));
    const meniscus_second_line unknown = {{"mass_offset", "pressure"}, 1, 1, 0};
    options.second_line = &unknown;
    meniscus_surface* surface = nullptr;
    EXPECT_EQ(meniscus_create(&surface, &options, Dimension, MENISCUS_DOUBLE),
              MENISCUS_BAD_ARGUMENT);
    EXPECT_NE(std::string(meniscus_last_error()).find("second_line"), std::string::npos);
    options.second_line = nullptr;
    options.k = options.d = std::nan("");
    options.spacing_ratio = 7;
    EXPECT_EQ(meniscus_create(&surface, &options, Dimension, MENISCUS_DOUBLE),
              MENISCUS_BAD_ARGUMENT);
    EXPECT_NE(std::string(meniscus_last_error()).find("spacing_ratio is 7"), std::string::npos);
}

TEST(CInterface, TakesTheLineOfTheDimension) {
    for (const bool paper : {false, true}) {
        expect_shipped_line<2>(paper);
        expect_shipped_line<3>(paper);
    }
}

/// A drop on a wall, with radii of its own and the host's candidates.
TEST(CInterface, BoundaryRadiiAndCandidates) {
    const auto fluid = ball<double, 3>(4, 0.2);
    const Host<double, 3> host(fluid);
    std::vector<double> radii;
    for (std::size_t i = 0; i < fluid.size(); ++i)
        radii.push_back(1 - 0.1 * static_cast<double>(i % 2));
    std::vector<double> walls;
    std::vector<std::uint64_t> offsets = {0};
    std::vector<std::uint32_t> rows;
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
            walls.insert(walls.end(), {0.5 * x, 0.5 * y, -2.5});
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        for (std::uint32_t wall = 0; wall < walls.size() / 3; ++wall)
            rows.push_back(wall);
        offsets.push_back(rows.size());
    }
    const std::vector<std::uint8_t> candidates(fluid.size(), 1);
    auto particles = host.particles();
    particles.support_radius = 0;
    particles.support_radii = radii.data();
    particles.boundary_count = walls.size() / 3;
    particles.boundary_positions = walls.data();
    particles.boundary_offsets = offsets.data();
    particles.boundary_neighbors = rows.data();
    particles.candidates = candidates.data();

    const auto wall_view = [&](std::size_t i, auto&& visit) {
        for (std::size_t wall = 0; wall < walls.size() / 3; ++wall) {
            std::array<double, 3> step;
            for (std::size_t axis = 0; axis < 3; ++axis)
                step[axis] = walls[3 * wall + axis] - fluid.positions[i][axis];
            visit(wall, step, 1.0);
        }
    };
    const std::vector<float> angles(walls.size() / 3, 60);
    particles.boundary_contact_angles = angles.data();
    const BoundaryView<decltype(wall_view)> boundary{wall_view, angles.data()};
    const std::vector<std::uint32_t> counts(fluid.size(), 100);
    SurfaceTension<double, 3> tension(options_for<3>());
    tension.step(fluid.view(), boundary, fluid.size(), VaryingRadii<double>{radii.data()}, nullptr,
                 candidates.data(), counts.data(), SerialLoop{});

    const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
    ASSERT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
    ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
    const auto results = results_of(surface.get());
    ASSERT_EQ(results.slots, fluid.size());
    const auto& list = tension.surface();
    for (std::size_t slot = 0; slot < results.slots; ++slot) {
        EXPECT_EQ(results.surface_class[slot], static_cast<std::uint8_t>(list.surface_class[slot]));
        EXPECT_EQ(static_cast<const double*>(results.curvature)[slot], list.curvature[slot]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_EQ(static_cast<const double*>(results.force)[3 * slot + axis],
                      list.force[slot][axis]);
    }
    particles.boundary_contact_angles = nullptr;
    const Found at_60 = Found::of<double>(results, 3);
    ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
    EXPECT_FALSE(Found::of<double>(results_of(surface.get()), 3) == at_60);
    // The drop touches the wall, so its net force stays, and the wall gets it back.
    tension.balance_momentum<3>(fluid.view(), boundary, VaryingRadii<double>{radii.data()},
                                fluid.positions[0].data(), SerialLoop{});
    const auto reaction = tension.wall_reaction();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double net = 0;
        for (std::size_t slot = 0; slot < list.size(); ++slot)
            net += list.force[slot][axis];
        EXPECT_EQ(reaction[axis], -net);
    }
    EXPECT_NE(reaction[2], 0);
    const Found before = Found::of<double>(results_of(surface.get()), 3);
    ASSERT_EQ(meniscus_balance_momentum(surface.get(), &particles), MENISCUS_OK);
    EXPECT_TRUE(Found::of<double>(results_of(surface.get()), 3) == before);
    particles.boundary_positions = nullptr;
    ASSERT_EQ(meniscus_balance_momentum(surface.get(), &particles), MENISCUS_OK);
    EXPECT_FALSE(Found::of<double>(results_of(surface.get()), 3) == before);
}

TEST(CInterface, ScattersAndAccelerates) {
    const auto fluid = ball<float, 2>(8, 0.2);
    const Host<float, 2> host(fluid);
    const auto particles = host.particles();
    const auto surface = create(host_options<2>(), 2, MENISCUS_FLOAT);
    ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
    const auto found = results_of(surface.get());
    ASSERT_LT(found.slots, fluid.size());

    const std::size_t count = fluid.size();
    std::vector<std::uint8_t> classes(count, 9);
    std::vector<float> fractions(count, 9);
    std::vector<float> curvatures(count, 9);
    std::vector<float> normals(3 * count, 9);
    std::vector<float> forces(3 * count, 9);
    ASSERT_EQ(meniscus_scatter(surface.get(), classes.data(), fractions.data(), normals.data(),
                               curvatures.data(), forces.data(), 3),
              MENISCUS_OK);
    ASSERT_EQ(meniscus_scatter(surface.get(), nullptr, nullptr, nullptr, nullptr, nullptr, 0),
              MENISCUS_OK);
    std::vector<float> masses(count);
    for (std::size_t i = 0; i < count; ++i)
        masses[i] = 1 + static_cast<float>(i);
    std::vector<float> accelerations(2 * count, 100);
    ASSERT_EQ(meniscus_add_accelerations(surface.get(), masses.data(), 0, accelerations.data(), 0),
              MENISCUS_OK);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t slot = found.slot_of[i];
        const auto expected = [&](const void* values, int of) {
            return slot < 0 ? 0 : static_cast<const float*>(values)[of];
        };
        EXPECT_EQ(classes[i], slot < 0 ? 0 : found.surface_class[slot]);
        EXPECT_EQ(fractions[i], expected(found.uncovered_fraction, slot));
        EXPECT_EQ(curvatures[i], expected(found.curvature, slot));
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_EQ(normals[3 * i + axis], expected(found.normal, 2 * slot + axis));
            EXPECT_EQ(forces[3 * i + axis], expected(found.force, 2 * slot + axis));
            EXPECT_EQ(accelerations[2 * i + axis], 100 + forces[3 * i + axis] / masses[i]);
        }
        EXPECT_EQ(normals[3 * i + 2], 9) << "padding is the host's";
    }
}

TEST(CInterface, SamplesAndLineChange) {
    const auto fluid = ball<double, 3>(4, 0.2);
    const Host<double, 3> host(fluid);
    const auto particles = host.particles();
    const auto step = [&](meniscus_surface* surface) {
        EXPECT_EQ(meniscus_step(surface, &particles), MENISCUS_OK);
        return Found::of<double>(results_of(surface), 3);
    };
    auto options = host_options<3>();
    const auto changed = create(options, 3, MENISCUS_DOUBLE);
    const Found with_64 = step(changed.get());
    options.samples = 320;
    const Found with_320 = step(create(options, 3, MENISCUS_DOUBLE).get());
    EXPECT_FALSE(with_64 == with_320);
    EXPECT_EQ(meniscus_set_samples(changed.get(), 320), MENISCUS_OK);
    EXPECT_TRUE(step(changed.get()) == with_320);
    EXPECT_EQ(meniscus_set_samples_for_time_step(changed.get(), 1e-9, 1e4, 64), MENISCUS_OK);
    EXPECT_TRUE(step(changed.get()) == with_64);
    EXPECT_EQ(meniscus_set_samples_for_time_step(changed.get(), 0.03125, 10240, 64), MENISCUS_OK);
    EXPECT_TRUE(step(changed.get()) == with_320);
    EXPECT_EQ(meniscus_set_line(changed.get(), 0, 1000), MENISCUS_OK);
    EXPECT_EQ(step(changed.get()).particle.size(), fluid.size());
}

TEST(CInterface, MapsOfCurvatureAreTheHosts) {
    const auto fluid = ball<double, 3>(4, 0.2);
    const Host<double, 3> host(fluid);
    const auto particles = host.particles();
    const meniscus_curvature_map map{{0.5, 0, 0, 0}, -1, 1, 1};
    auto options = host_options<3>();
    options.curvature_map = &map;
    const auto surface = create(options, 3, MENISCUS_DOUBLE);
    ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
    const auto found = results_of(surface.get());
    for (std::size_t slot = 0; slot < found.slots; ++slot)
        EXPECT_EQ(static_cast<const double*>(found.curvature)[slot],
                  found.surface_class[slot] == MENISCUS_AT_SURFACE ? 0.5 : 0);
}

TEST(CInterface, NoParticles) {
    const auto surface = create(host_options<3>(), 3, MENISCUS_FLOAT);
    EXPECT_EQ(results_of(surface.get()).slots, 0U); // before the first step
    meniscus_particles none{};
    none.size = sizeof none;
    EXPECT_EQ(meniscus_step(surface.get(), &none), MENISCUS_OK) << meniscus_last_error();
    EXPECT_EQ(meniscus_check(surface.get(), &none), MENISCUS_OK) << meniscus_last_error();
    EXPECT_EQ(meniscus_balance_momentum(surface.get(), &none), MENISCUS_OK);
    EXPECT_EQ(meniscus_add_accelerations(surface.get(), nullptr, 1, nullptr, 0), MENISCUS_OK);
    EXPECT_EQ(results_of(surface.get()).slots, 0U);
    EXPECT_EQ(meniscus_reserve(surface.get(), 0, 0), MENISCUS_OK);
}

/// One particle alone, for which lists are empty and no array of neighbors need be there.
TEST(CInterface, ListsWithoutNeighbors) {
    const auto surface = create(host_options<3>(), 3, MENISCUS_FLOAT);
    const Host<float, 3> host(Fluid<float, 3>({{0, 0, 0}}, 1));
    auto particles = host.particles();
    particles.neighbors = nullptr;
    EXPECT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
    EXPECT_EQ(results_of(surface.get()).slots, 1U);
}

/// The options of C, set member by member.
meniscus_options in_c(const SurfaceTensionOptions& options) {
    meniscus_options made;
    meniscus_options_init(&made, sizeof made);
#define MENISCUS_ROW(name, range, only_sampled, unit, meaning)                                     \
    made.name = static_cast<decltype(made.name)>(options.name);
    MENISCUS_SURFACE_TENSION_OPTIONS(MENISCUS_ROW)
#undef MENISCUS_ROW
    return made;
}

/// That they are the same but for `size`, whichever members there are.
void expect_same_options(const meniscus_options& a, const meniscus_options& b) {
#define MENISCUS_ROW(name, range, only_sampled, unit, meaning)                                     \
    EXPECT_EQ(std::memcmp(&a.name, &b.name, sizeof a.name), 0) << #name;
    MENISCUS_SURFACE_TENSION_OPTIONS(MENISCUS_ROW)
#undef MENISCUS_ROW
}

TEST(CInterface, HasTheOptionsOfTheTable) {
    std::size_t size = sizeof(meniscus_options::size) + sizeof(meniscus_options::curvature_map) +
                       sizeof(meniscus_options::second_line) + sizeof(meniscus_options::threads);
#define MENISCUS_ROW(name, range, only_sampled, unit, meaning)                                     \
    size += sizeof(meniscus_options::name);
    MENISCUS_SURFACE_TENSION_OPTIONS(MENISCUS_ROW)
#undef MENISCUS_ROW
    const std::size_t whole = alignof(meniscus_options);
    EXPECT_EQ(sizeof(meniscus_options), (size + whole - 1) / whole * whole);
    meniscus_options options;
    meniscus_options_init(&options, sizeof options);
    expect_same_options(options, in_c({}));
    meniscus_options_paper(&options, sizeof options);
    expect_same_options(options, in_c(paper_options()));
}

/// Set here or there, an option gives the same bits.
TEST(CInterface, EachOptionIsThatOfTheHeaders) {
    const auto fluid = ball<double, 3>(4, 0.2);
    const Host<double, 3> host(fluid);
    const auto particles = host.particles();
    for_each_surface_option([&](const auto& option) {
        auto options = options_for<3>();
        set_other(option, options);
        SurfaceTension<double, 3> tension(options);
        tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
        const auto surface = create(in_c(options), 3, MENISCUS_DOUBLE);
        ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
        EXPECT_TRUE(Found::of<double>(results_of(surface.get()), 3) ==
                    found_in_cpp(tension.surface()))
            << option.name;
    });
}

void expect_bad(int status, const std::string& part) {
    EXPECT_EQ(status, MENISCUS_BAD_ARGUMENT) << part;
    EXPECT_NE(std::string(meniscus_last_error()).find(part), std::string::npos)
        << meniscus_last_error() << ", expected " << part;
}

TEST(CInterfaceErrors, OptionsAreNamed) {
    struct Case {
        const char* name;
        std::function<void(meniscus_options&)> spoil;
    };
    const std::vector<Case> cases = {
        {"options.size", [](auto& o) { o.size = 0; }},
        {"options.size", [](auto& o) { ++o.size; }},
        {"threads", [](auto& o) { o.threads = -1; }},
        {"threads", [](auto& o) { o.threads = 1000000; }},
    };
    for (const auto& [name, spoil] : cases) {
        auto options = host_options<3>();
        spoil(options);
        int something = 0;
        auto* surface = reinterpret_cast<meniscus_surface*>(&something);
        expect_bad(meniscus_create(&surface, &options, 3, MENISCUS_FLOAT), name);
        EXPECT_EQ(surface, nullptr);
    }
    for_each_surface_option([&](const auto& option) {
        for (const auto value : values_out_of_range(option)) {
            auto spoilt = options_for<3>();
            spoilt.*option.member = value;
            const auto options = in_c(spoilt);
            meniscus_surface* surface = nullptr;
            const int status = meniscus_create(&surface, &options, 3, MENISCUS_FLOAT);
            expect_bad(status, option.name);
            for (const std::string& word : words_of(option.range))
                expect_bad(status, word);
        }
    });
    const auto options = host_options<3>();
    meniscus_surface* surface = nullptr;
    expect_bad(meniscus_create(&surface, &options, 4, MENISCUS_FLOAT), "dimension");
    expect_bad(meniscus_create(&surface, &options, 3, 2), "precision");
    expect_bad(meniscus_create(&surface, nullptr, 3, MENISCUS_FLOAT), "options is NULL");
    expect_bad(meniscus_create(nullptr, &options, 3, MENISCUS_FLOAT), "surface is NULL");
    expect_bad(meniscus_options_init(nullptr, sizeof options), "options is NULL");
    meniscus_options unchanged{};
    expect_bad(meniscus_options_paper(&unchanged, sizeof unchanged - 8), "size");
    EXPECT_EQ(unchanged.size, 0U);
}

TEST(CInterfaceErrors, ParticlesAreNamed) {
    struct Case {
        const char* name;
        std::function<void(meniscus_particles&)> spoil;
    };
    const std::vector<Case> cases = {
        {"particles.size", [](auto& p) { p.size = 0; }},
        {"particles.count", [](auto& p) { p.count = std::size_t{1} << 31; }},
        {"particles.positions", [](auto& p) { p.positions = nullptr; }},
        {"particles.stride", [](auto& p) { p.stride = 2; }},
        {"particles.support_radius", [](auto& p) { p.support_radius = 0; }},
        {"particles.support_radius", [](auto& p) { p.support_radius = -1; }},
        {"particles.support_radius", [](auto& p) { p.support_radius = 1e-60; }}, // 0 in float
        {"particles.support_radius", [](auto& p) { p.support_radius = 1e60; }},
        {"particles.support_radius",
         [](auto& p) { p.support_radius = std::numeric_limits<double>::quiet_NaN(); }},
        {"particles.offsets", [](auto& p) { p.offsets = nullptr; }},
        {"particles.neighbors", [](auto& p) { p.neighbors = nullptr; }},
        {"particles.offset_bits", [](auto& p) { p.offset_bits = 0; }},
        {"particles.boundary_offsets", [](auto& p) { p.boundary_positions = p.positions; }},
        {"particles.boundary_neighbors",
         [](auto& p) {
             p.boundary_positions = p.positions;
             p.boundary_offsets = p.offsets;
         }},
    };
    const Host<float, 3> host(ball<float, 3>(3, 0.2));
    const auto surface = create(host_options<3>(), 3, MENISCUS_FLOAT);
    for (const auto& [name, spoil] : cases) {
        auto particles = host.particles();
        spoil(particles);
        expect_bad(meniscus_step(surface.get(), &particles), name);
        expect_bad(meniscus_check(surface.get(), &particles), name);
        expect_bad(meniscus_balance_momentum(surface.get(), &particles), name);
    }
    expect_bad(meniscus_step(surface.get(), nullptr), "particles is NULL");
    const auto particles = host.particles();
    expect_bad(meniscus_balance_momentum(surface.get(), &particles), "last step");
    EXPECT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK); // nothing is broken
}

TEST(CInterfaceErrors, CheckFindsWhatStepsTrust) {
    const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
    const auto check = [&](const Host<double, 3>& host, const auto& change, const char* part) {
        for (const int bits : {32, 64}) {
            auto particles = host.particles(bits);
            change(particles);
            expect_bad(meniscus_check(surface.get(), &particles), part);
        }
    };
    const Host<double, 3> good(ball<double, 3>(3, 0.2));
    const auto nothing = [](meniscus_particles&) {};
    auto bad = good;
    bad.positions[3 * 7 + 2] = std::numeric_limits<double>::infinity();
    check(bad, nothing, "particles.positions[7]");
    bad = good;
    bad.positions[3 * 8 + 1] = 1e17;
    check(bad, nothing, "particles.positions[8] lies so far from the origin");
    bad = good;
    std::swap(bad.short_offsets[5], bad.short_offsets[6]);
    std::swap(bad.long_offsets[5], bad.long_offsets[6]);
    check(bad, nothing, "particles.offsets[6]");
    bad = good;
    bad.neighbors[0] = static_cast<std::uint32_t>(bad.count);
    check(bad, nothing, "particles.offsets[0]");
    std::vector<double> values(good.count, 1);
    values[9] = 0;
    check(
        good, [&](auto& p) { p.masses = values.data(); }, "particles.masses[9]");
    check(
        good, [&](auto& p) { p.support_radii = values.data(); }, "particles.support_radii[9]");
    const auto walls = [&](std::size_t count) {
        return [&, count](meniscus_particles& p) {
            p.boundary_positions = p.positions;
            p.boundary_offsets = p.offsets;
            p.boundary_neighbors = p.neighbors;
            p.boundary_count = count;
        };
    };
    check(good, walls(3), "particles.boundary_offsets[");
    auto particles = good.particles();
    walls(good.count)(particles);
    EXPECT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
    std::vector<float> angles(good.count, 90);
    angles[4] = 5;
    check(
        good,
        [&](auto& p) {
            walls(good.count)(p);
            p.boundary_contact_angles = angles.data();
        },
        "particles.boundary_contact_angles[4]");
}

TEST(CInterfaceErrors, OtherArguments) {
    const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
    const Host<double, 3> host(ball<double, 3>(3, 0.2));
    const auto particles = host.particles();
    ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
    expect_bad(meniscus_set_samples(surface.get(), 3), "samples");
    expect_bad(meniscus_set_samples(surface.get(), 16385), "samples");
    expect_bad(meniscus_set_samples_for_time_step(surface.get(), 0, 1e4, 16), "time_step");
    expect_bad(meniscus_set_samples_for_time_step(surface.get(), 1, -1, 16), "sampling_density");
    expect_bad(meniscus_set_samples_for_time_step(surface.get(), 1, 1, 0), "minimum");
    expect_bad(meniscus_set_line(surface.get(), std::numeric_limits<double>::quiet_NaN(), 0),
               "k must be");
    expect_bad(meniscus_set_line(surface.get(), 0, 2e6), "d must be");
    std::vector<double> accelerations(3 * host.count);
    expect_bad(meniscus_add_accelerations(surface.get(), nullptr, 0, accelerations.data(), 0),
               "mass");
    expect_bad(meniscus_add_accelerations(surface.get(), nullptr, 1, nullptr, 0), "accelerations");
    expect_bad(meniscus_add_accelerations(surface.get(), nullptr, 1, accelerations.data(), 2),
               "stride");
    expect_bad(meniscus_scatter(surface.get(), nullptr, nullptr, nullptr, nullptr, nullptr, 1),
               "stride");
    meniscus_results results{};
    expect_bad(meniscus_get_results(surface.get(), &results), "results.size");
    expect_bad(meniscus_get_results(surface.get(), nullptr), "results is NULL");
    for (const int status :
         {meniscus_reserve(nullptr, 1, 1), meniscus_set_samples(nullptr, 16),
          meniscus_set_line(nullptr, 1, 1), meniscus_step(nullptr, &particles),
          meniscus_check(nullptr, &particles), meniscus_balance_momentum(nullptr, &particles),
          meniscus_scatter(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, 0),
          meniscus_add_accelerations(nullptr, nullptr, 1, accelerations.data(), 0)})
        expect_bad(status, "surface is NULL");
    meniscus_destroy(nullptr);
    EXPECT_EQ(results_of(surface.get()).count, host.count); // all of that changed nothing
}

/// More than there can be, which no machine grants.
TEST(CInterfaceErrors, ThreadsThatCannotBeStarted) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer itself needs more than the limit";
#endif
    const auto limited = [] { // in a process of its own
        rlimit limit{};
        getrlimit(RLIMIT_AS, &limit);
        limit.rlim_cur = 2'000'000'000; // far less than the stacks of all
        setrlimit(RLIMIT_AS, &limit);
        auto options = host_options<3>();
        options.threads = 1024;
        meniscus_surface* surface = nullptr;
        const int status = meniscus_create(&surface, &options, 3, MENISCUS_FLOAT);
        std::fputs(meniscus_last_error(), stderr);
        std::exit(status);
    };
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    EXPECT_EXIT(limited(), testing::ExitedWithCode(MENISCUS_FAILURE),
                "1024 threads cannot be started: .*; take fewer");
}

TEST(CInterfaceErrors, TooMuchMemory) {
    const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
    EXPECT_EQ(meniscus_reserve(surface.get(), std::size_t{1} << 62, 1), MENISCUS_OUT_OF_MEMORY);
    const Host<double, 3> host(ball<double, 3>(3, 0.2));
    const auto particles = host.particles();
    EXPECT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_FAILURE);
    EXPECT_NE(std::string(meniscus_last_error()).find("destroy"), std::string::npos);
}

} // namespace
} // namespace meniscus
