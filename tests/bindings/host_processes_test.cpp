// The C interface in hosts that trap floating-point exceptions, that fork, and that call it from
// several threads; and what such hosts change while they run.
#include "hosts.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <memory>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace meniscus {
namespace {

using Surface = std::unique_ptr<meniscus_surface, decltype(&meniscus_destroy)>;

Surface create(const meniscus_options& options, int dimension, int precision) {
    meniscus_surface* surface = nullptr;
    EXPECT_EQ(meniscus_create(&surface, &options, dimension, precision), MENISCUS_OK)
        << meniscus_last_error();
    return {surface, meniscus_destroy};
}

/// Fluid, a particle of spray, and walls, from creation to destruction.
template <class Real, int Dimension>
std::vector<Real> forces_of(const meniscus_options& options) {
    auto places = ball<Real, Dimension>(Dimension == 3 ? 4 : 9, 0.2).positions;
    places.push_back({Real(40)});
    const Host<Real, Dimension> host(Fluid<Real, Dimension>(places, 1));
    std::vector<Real> distances, normals, forces(Dimension * host.count);
    for (const auto& place : places) {
        distances.push_back(place[0] + Real(1.5));
        for (int axis = 0; axis < Dimension; ++axis)
            normals.push_back(axis == 0 ? 1 : 0);
    }
    const auto surface = create(options, Dimension, precision_of<Real>);
    meniscus_particles none{};
    none.size = sizeof none;
    EXPECT_EQ(meniscus_step(surface.get(), &none), MENISCUS_OK);
    EXPECT_EQ(meniscus_reserve(surface.get(), host.count, 50), MENISCUS_OK);
    auto particles = host.particles();
    for (const bool has_walls : {false, true}) {
        particles.wall_count = has_walls ? 1 : 0;
        particles.wall_distances = distances.data();
        particles.wall_normals = normals.data();
        EXPECT_EQ(meniscus_check(surface.get(), &particles), MENISCUS_OK) << meniscus_last_error();
        EXPECT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
        EXPECT_EQ(meniscus_balance_momentum(surface.get(), &particles), MENISCUS_OK);
        EXPECT_EQ(meniscus_add_accelerations(surface.get(), nullptr, 1, forces.data(), 0),
                  MENISCUS_OK);
    }
    return forces;
}

template <class Real, int Dimension>
void run_with_traps() {
    for (const int coverage : {MENISCUS_SAMPLED, MENISCUS_EXACT}) {
        meniscus_options options;
        meniscus_options_init(&options, sizeof options);
        options.coverage = coverage;
        options.threads = Dimension - 1; // one, and more than one
        const auto expected = forces_of<Real, Dimension>(options);
        constexpr int trapped = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(trapped);
        const auto forces = forces_of<Real, Dimension>(options);
        const int enabled = fedisableexcept(FE_ALL_EXCEPT);
        EXPECT_EQ(enabled, trapped);
        EXPECT_EQ(std::fetestexcept(trapped), 0);
        EXPECT_EQ(forces, expected);
    }
}

TEST(HostProcesses, MayTrapOverflowInTheNumberOfSamples) {
    meniscus_options options;
    meniscus_options_init(&options, sizeof options);
    options.coverage = MENISCUS_EXACT;
    const auto surface = create(options, 2, MENISCUS_DOUBLE);
    feenableexcept(FE_OVERFLOW);
    EXPECT_EQ(meniscus_set_samples_for_time_step(surface.get(), 1e300, 1e300, 16), MENISCUS_OK);
    fedisableexcept(FE_ALL_EXCEPT);
}

TEST(HostProcesses, MayTrapFloatingPointExceptions) {
    run_with_traps<float, 2>();
    run_with_traps<float, 3>();
    run_with_traps<double, 2>();
    run_with_traps<double, 3>();
}

meniscus_options two_threads() {
    meniscus_options options;
    meniscus_options_init(&options, sizeof options);
    options.threads = 2;
    return options;
}

/// Ended by an alarm where it waits for threads that a child does not have.
TEST(HostProcesses, MayForkAfterAStep) {
    const auto host = Host<double, 3>(ball<double, 3>(6, 0.2));
    const auto particles = host.particles();
    const auto surface = create(two_threads(), 3, MENISCUS_DOUBLE);
    ASSERT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
    const auto found = [&](const meniscus_surface* of) {
        meniscus_results results{};
        results.size = sizeof results;
        meniscus_get_results(of, &results);
        return Found::of<double>(results, 3);
    };
    const Found expected = found(surface.get());
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        alarm(20);
        const bool same = meniscus_step(surface.get(), &particles) == MENISCUS_OK &&
                          found(surface.get()) == expected;
        const auto fresh = create(two_threads(), 3, MENISCUS_DOUBLE);
        const bool fresh_is_same =
            meniscus_step(fresh.get(), &particles) == MENISCUS_OK && found(fresh.get()) == expected;
        _exit(same && fresh_is_same ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_EQ(meniscus_step(surface.get(), &particles), MENISCUS_OK);
    EXPECT_TRUE(found(surface.get()) == expected);
}

TEST(HostProcesses, MayCallFromThreadsOfTheirOwn) {
    const auto expected = forces_of<float, 3>(two_threads());
    std::vector<std::vector<float>> forces(3);
    std::vector<std::thread> callers;
    for (auto& own : forces)
        callers.emplace_back([&] { own = forces_of<float, 3>(two_threads()); });
    for (std::thread& caller : callers)
        caller.join();
    for (const auto& own : forces)
        EXPECT_EQ(own, expected);
}

/// Changed while it runs, a handle gives what a new one gives.
TEST(HostProcesses, MayChangeOptions) {
    const auto host = Host<double, 3>(ball<double, 3>(4, 0.2));
    const auto particles = host.particles();
    auto options = two_threads();
    const auto forces = [&](meniscus_surface* surface) {
        EXPECT_EQ(meniscus_step(surface, &particles), MENISCUS_OK);
        std::vector<double> all(3 * host.count);
        meniscus_scatter(surface, nullptr, nullptr, nullptr, nullptr, all.data(), 0);
        return all;
    };
    const auto changed = create(options, 3, MENISCUS_DOUBLE);
    auto before = forces(changed.get());
    const auto expect_same = [&](int status) {
        EXPECT_EQ(status, MENISCUS_OK) << meniscus_last_error();
        const auto now = forces(changed.get());
        EXPECT_EQ(now, forces(create(options, 3, MENISCUS_DOUBLE).get()));
        EXPECT_NE(now, before);
        before = now;
    };
    options.surface_tension = 0.5;
    expect_same(meniscus_set_surface_tension(changed.get(), 0.5));
    options.fade = 0.9;
    expect_same(meniscus_set_fade(changed.get(), 0.9));
    options.normal_passes = 3;
    options.curvature_passes = 2;
    expect_same(meniscus_set_smoothing(changed.get(), 3, 2));
    EXPECT_EQ(meniscus_set_contact_angle(changed.get(), 60), MENISCUS_OK);
    const auto refuses = [&](int status, const std::string& part) {
        EXPECT_EQ(status, MENISCUS_BAD_ARGUMENT) << part;
        EXPECT_NE(std::string(meniscus_last_error()).find(part), std::string::npos)
            << meniscus_last_error();
    };
    refuses(meniscus_set_surface_tension(changed.get(), std::nan("")), "surface_tension must be");
    refuses(meniscus_set_fade(changed.get(), 2), "fade must be");
    refuses(meniscus_set_smoothing(changed.get(), -1, 0), "normal_passes must be");
    refuses(meniscus_set_smoothing(changed.get(), 0, 1001), "curvature_passes must be");
    refuses(meniscus_set_contact_angle(changed.get(), 5), "contact_angle must be");
    for (const int status :
         {meniscus_set_surface_tension(nullptr, 1), meniscus_set_fade(nullptr, 0.5),
          meniscus_set_smoothing(nullptr, 1, 1), meniscus_set_contact_angle(nullptr, 90)})
        refuses(status, "surface is NULL");
    EXPECT_EQ(forces(changed.get()), before);
}

TEST(HostProcesses, AreToldRatioAndTimeStep) {
    double value = 0;
    EXPECT_EQ(meniscus_spacing_ratio(2, 1, 3, &value), MENISCUS_OK);
    EXPECT_DOUBLE_EQ(value, 2);
    EXPECT_EQ(meniscus_capillary_time_step(0.072, 1000, 1e-3, &value), MENISCUS_OK);
    EXPECT_NEAR(value, std::sqrt(1e-6 / (2 * 3.14159265358979 * 0.072)), 1e-12);
    EXPECT_EQ(meniscus_spacing_ratio(2, 1, 3, nullptr), MENISCUS_BAD_ARGUMENT);
    EXPECT_EQ(meniscus_spacing_ratio(2, -1, 3, &value), MENISCUS_BAD_ARGUMENT);
    EXPECT_EQ(meniscus_spacing_ratio(2, 1, 4, &value), MENISCUS_BAD_ARGUMENT);
    EXPECT_EQ(meniscus_capillary_time_step(-1, 1, 1, &value), MENISCUS_BAD_ARGUMENT);
    EXPECT_EQ(meniscus_capillary_time_step(1, 1, 1, nullptr), MENISCUS_BAD_ARGUMENT);
}

} // namespace
} // namespace meniscus
