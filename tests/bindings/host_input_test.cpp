// What meniscus_check and a step say of arrays that look sound and are not.
#include "hosts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace meniscus {
namespace {

using Surface = std::unique_ptr<meniscus_surface, decltype(&meniscus_destroy)>;

Surface create(meniscus_options options, int dimension, int precision) {
    meniscus_surface* surface = nullptr;
    options.threads = 1;
    EXPECT_EQ(meniscus_create(&surface, &options, dimension, precision), MENISCUS_OK)
        << meniscus_last_error();
    return {surface, meniscus_destroy};
}

void expect_bad(int status, const std::string& part) {
    EXPECT_EQ(status, MENISCUS_BAD_ARGUMENT) << part;
    EXPECT_NE(std::string(meniscus_last_error()).find(part), std::string::npos)
        << meniscus_last_error() << ", expected " << part;
}

template <class Real>
void expect_no_step_at_absurd_radii() {
    const Host<Real, 3> host(block<Real, 3>({4, 4, 4}));
    const auto surface = create(host_options<3>(), 3, precision_of<Real>);
    auto particles = host.particles();
    std::vector<Real> radii(host.count, 1);
    particles.support_radii = radii.data();
    EXPECT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
    const Real largest = std::numeric_limits<Real>::max();
    for (const Real absurd : {largest, largest / 4, std::numeric_limits<Real>::min(), Real(0),
                              Real(-1), std::numeric_limits<Real>::quiet_NaN()}) {
        radii[3] = absurd;
        expect_bad(meniscus_check(surface.get(), &particles), "particles.support_radii[3]");
        expect_bad(meniscus_step(surface.get(), &particles), "particle 3");
    }
    radii[3] = Real(1e8);
    expect_bad(meniscus_check(surface.get(), &particles), "particles.support_radii[3]");
    expect_bad(meniscus_step(surface.get(), &particles), "1000000 times the smallest");
}

TEST(HostInput, RadiiThatTheNumberTypeCannotHold) {
    expect_no_step_at_absurd_radii<float>();
    expect_no_step_at_absurd_radii<double>();
}

/// Lists that end at the radius that was searched with, and another that is given.
template <int Dimension>
void expect_radius_is_compared(const Fluid<double, Dimension>& fluid) {
    const Host<double, Dimension> host(fluid);
    const auto surface = create(host_options<Dimension>(), Dimension, MENISCUS_DOUBLE);
    const auto check = [&](double times) {
        auto particles = host.particles();
        particles.support_radius *= times;
        return meniscus_check(surface.get(), &particles);
    };
    EXPECT_EQ(check(1), MENISCUS_OK) << meniscus_last_error();
    for (const double times : {0.001, 0.5, 2.0, 3.0, 1000.0})
        EXPECT_EQ(check(times), MENISCUS_BAD_ARGUMENT) << times << ", " << fluid.size();
}

TEST(HostInput, ARadiusThatIsNotThatOfTheLists) {
    expect_radius_is_compared(block<double, 3>({3, 3, 3}));
    expect_radius_is_compared(block<double, 3>({6, 6, 6}));
    expect_radius_is_compared(ball<double, 3>(5, 0.2));
    expect_radius_is_compared(block<double, 2>({7, 7, 1}));
    expect_radius_is_compared(ball<double, 2>(9, 0.2));
}

TEST(HostInput, FewParticlesThatAreFineAsTheyAre) {
    const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
    for (const auto& places : std::vector<std::vector<std::array<double, 3>>>{
             {{0, 0, 0}},
             {{0, 0, 0}, {0, 0, 0.3}},
             {{0, 0, 0}, {0, 0, 1}},
             {{0, 0, 0}, {0, 0, 1.004}}, // listed by a search with a margin
             {{0, 0, 0}, {0, 0, 0.3}, {5, 5, 5}, {5, 5, 5.3}},
             {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}) {
        const Host<double, 3> host(Fluid<double, 3>(places, 1));
        const auto particles = host.particles();
        EXPECT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
    }
}

TEST(HostInput, HalfListsAtAnyRadius) {
    auto host = Host<double, 3>(block<double, 3>({5, 5, 5}));
    std::vector<std::uint32_t> later;
    std::vector<std::uint64_t> offsets{0};
    for (std::size_t i = 0; i < host.count; ++i) {
        for (auto n = host.long_offsets[i]; n < host.long_offsets[i + 1]; ++n)
            if (host.neighbors[n] > i)
                later.push_back(host.neighbors[n]);
        offsets.push_back(later.size());
    }
    host.neighbors = later;
    host.long_offsets = offsets;
    const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
    for (const double radius : {0.5, 1.0, 2.0, 1000.0}) {
        auto particles = host.particles();
        particles.support_radius = radius;
        EXPECT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_BAD_ARGUMENT) << radius;
    }
}

/// Offsets of one width in arrays no longer than they must be, said to be of the other.
TEST(HostInput, OffsetsOfAnotherWidth) {
    const Host<double, 3> host(block<double, 3>({3, 3, 3}));
    const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
    auto particles = host.particles(32);
    particles.offset_bits = 64;
    expect_bad(meniscus_check(surface.get(), &particles), "of 32 bits where offset_bits says 64");
    particles = host.particles(64);
    particles.offset_bits = 32;
    expect_bad(meniscus_check(surface.get(), &particles), "of 64 bits where offset_bits says 32");
    // The first particles alone, so that a row begins within the array and ends beyond.
    auto lonely = Fluid<double, 3>({{0, 0, 0}, {9, 0, 0}, {20, 0, 0}, {20, 0, 0.5}}, 1);
    const Host<double, 3> few(lonely);
    particles = few.particles(32);
    particles.offset_bits = 64;
    expect_bad(meniscus_check(surface.get(), &particles), "of 32 bits where offset_bits says 64");
}

TEST(HostInput, MassesWhoseSumsLeaveTheNumberType) {
    const Host<float, 3> host(block<float, 3>({3, 3, 3}));
    const auto surface = create(host_options<3>(), 3, MENISCUS_FLOAT);
    auto particles = host.particles();
    std::vector<float> masses(host.count, 1);
    particles.masses = masses.data();
    EXPECT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
    for (const float mass : {1e38F, 1e-45F}) {
        masses[5] = mass;
        expect_bad(meniscus_check(surface.get(), &particles), "particles.masses[5]");
        ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
        std::vector<float> forces(3 * host.count);
        meniscus_scatter(surface.get(), nullptr, nullptr, nullptr, nullptr, forces.data(), 0);
        for (const float force : forces)
            EXPECT_TRUE(std::isfinite(force));
        std::vector<float> accelerations(3 * host.count, 7);
        const auto before = accelerations;
        if (mass < 1) {
            expect_bad(meniscus_add_accelerations(surface.get(), masses.data(), 0,
                                                  accelerations.data(), 0),
                       "masses[5]");
            EXPECT_EQ(accelerations, before);
        }
    }
    std::vector<float> accelerations(3 * host.count);
    for (const double mass : {1e-60, 1e60})
        expect_bad(
            meniscus_add_accelerations(surface.get(), nullptr, mass, accelerations.data(), 0),
            "mass");
}

TEST(HostInput, SizesThatOverflow) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    for (const auto& [particles, neighbors] :
         std::vector<std::array<std::size_t, 2>>{{100, most},
                                                 {1, most},
                                                 {0, most},
                                                 {most, 1},
                                                 {most, most},
                                                 {most, 0},
                                                 {std::size_t{1} << 33, std::size_t{1} << 33},
                                                 {3, most / 2},
                                                 {0, most / 64},
                                                 {std::size_t{1} << 62, 4}}) {
        const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
        EXPECT_EQ(meniscus_reserve(surface.get(), particles, neighbors), MENISCUS_OUT_OF_MEMORY)
            << particles << ' ' << neighbors;
    }
    const Host<double, 3> host(block<double, 3>({3, 3, 3}));
    const auto surface = create(host_options<3>(), 3, MENISCUS_DOUBLE);
    auto particles = host.particles();
    ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
    std::vector<double> values(3 * host.count);
    for (const std::size_t stride : {most, most / 2, most / 8}) {
        particles.stride = stride;
        expect_bad(meniscus_step(surface.get(), &particles), "particles.stride");
        expect_bad(meniscus_check(surface.get(), &particles), "particles.stride");
        expect_bad(meniscus_scatter(surface.get(), nullptr, nullptr, nullptr, nullptr,
                                    values.data(), stride),
                   "stride");
        expect_bad(meniscus_add_accelerations(surface.get(), nullptr, 1, values.data(), stride),
                   "stride");
    }
}

/// The bottom of a box of fluid on a wall that is no particle.
TEST(HostInput, WallsAsDistances) {
    const auto fluid = block<double, 3>({6, 6, 6});
    const Host<double, 3> host(fluid);
    auto options = host_options<3>();
    meniscus_options_init(&options, sizeof options);
    options.spacing_ratio = 2;
    const auto surface = create(options, 3, MENISCUS_DOUBLE);
    auto particles = host.particles();
    std::vector<double> distances, normals;
    for (std::size_t i = 0; i < host.count; ++i) {
        distances.insert(distances.end(),
                         {fluid.positions[i][2] + 0.25, std::numeric_limits<double>::infinity()});
        normals.insert(normals.end(), {0, 0, 1, 0, 0, 0});
    }
    const std::size_t bottom = 2 * 6 + 2; // away from the sides
    const auto class_of_bottom = [&] {
        EXPECT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
        std::vector<std::uint8_t> classes(host.count);
        meniscus_scatter(surface.get(), classes.data(), nullptr, nullptr, nullptr, nullptr, 0);
        return classes[bottom];
    };
    EXPECT_EQ(class_of_bottom(), MENISCUS_AT_SURFACE);
    particles.wall_count = 2;
    expect_bad(meniscus_step(surface.get(), &particles), "particles.wall_distances");
    particles.wall_distances = distances.data();
    expect_bad(meniscus_step(surface.get(), &particles), "particles.wall_normals");
    particles.wall_normals = normals.data();
    EXPECT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
    EXPECT_NE(class_of_bottom(), MENISCUS_AT_SURFACE);
    const auto forces = [&] {
        EXPECT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
        std::vector<double> all(3 * host.count);
        meniscus_scatter(surface.get(), nullptr, nullptr, nullptr, nullptr, all.data(), 0);
        return all;
    };
    const auto at_90 = forces();
    const std::vector<float> angles(2, 60);
    particles.wall_contact_angles = angles.data();
    const auto at_60 = forces();
    EXPECT_NE(at_60, at_90);
    particles.wall_contact_angles = nullptr;
    EXPECT_EQ(meniscus_set_contact_angle(surface.get(), 60), MENISCUS_OK);
    EXPECT_EQ(forces(), at_60);
    // At a wall a component keeps its net force.
    EXPECT_EQ(meniscus_balance_momentum(surface.get(), &particles), MENISCUS_OK);
    EXPECT_EQ(forces(), at_60);
    // Beside boundary particles, which go on counting.
    const std::vector<double> far_wall(3, -50.0);
    const std::vector<std::uint64_t> none(host.count + 1, 0);
    particles.boundary_count = 1;
    particles.boundary_positions = far_wall.data();
    particles.boundary_offsets = none.data();
    EXPECT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
    EXPECT_EQ(forces(), at_60);
    std::vector<double> lid;
    std::vector<std::uint64_t> rows{0};
    std::vector<std::uint32_t> beside;
    for (int n = 0; n < 100; ++n)
        lid.insert(lid.end(), {0.5 * (n % 10 - 2), 0.5 * (n / 10 - 2), 3.0});
    for (std::size_t i = 0; i < host.count; ++i) {
        for (std::uint32_t b = 0; b < 100; ++b)
            beside.push_back(b);
        rows.push_back(beside.size());
    }
    particles.boundary_count = 100;
    particles.boundary_positions = lid.data();
    particles.boundary_offsets = rows.data();
    particles.boundary_neighbors = beside.data();
    EXPECT_NE(class_of_bottom(), MENISCUS_AT_SURFACE);
    std::vector<std::uint8_t> classes(host.count);
    meniscus_scatter(surface.get(), classes.data(), nullptr, nullptr, nullptr, nullptr, 0);
    EXPECT_NE(classes[host.count - 1 - bottom], MENISCUS_AT_SURFACE);
    particles.wall_count = 0;
    EXPECT_EQ(class_of_bottom(), MENISCUS_AT_SURFACE);
    particles.wall_count = 2;
    particles.boundary_positions = nullptr;
    distances[2 * 7] = std::numeric_limits<double>::quiet_NaN();
    expect_bad(meniscus_check(surface.get(), &particles), "particles.wall_distances[14]");
    distances[2 * 7] = 0.1;
    normals[6 * 7 + 2] = 3;
    expect_bad(meniscus_check(surface.get(), &particles), "particles.wall_normals[14]");
    normals[6 * 7 + 2] = 1;
    const std::vector<float> absurd(2, 200);
    particles.wall_contact_angles = absurd.data();
    expect_bad(meniscus_check(surface.get(), &particles), "particles.wall_contact_angles[0]");
    particles.wall_count = 2000;
    expect_bad(meniscus_step(surface.get(), &particles), "particles.wall_count");
}

} // namespace
} // namespace meniscus
