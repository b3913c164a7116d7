// However little memory there is, the C interface answers with a status: each allocation of a
// create and a step fails once.
#include "hosts.hpp"
#include "runtime/own_new.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>

namespace {

std::atomic<int> allocations_left{std::numeric_limits<int>::max()};

} // namespace

void* allocate(std::size_t size) {
    if (allocations_left.fetch_sub(1) > 0)
        if (void* memory = std::malloc(size > 0 ? size : 1))
            return memory;
    throw std::bad_alloc();
}

namespace meniscus {
namespace {

TEST(OutOfMemory, EveryAllocationMayFail) {
    const Host<float, 3> host(ball<float, 3>(5, 0.2));
    const auto particles = host.particles();
    auto options = host_options<3>();
    options.threads = 2;
    int failures_in_create = 0;
    int failures_in_step = 0;
    for (int granted = 0;; ++granted) {
        ASSERT_LT(granted, 10000);
        meniscus_surface* surface = nullptr;
        allocations_left = granted;
        const int created = meniscus_create(&surface, &options, 3, MENISCUS_FLOAT);
        int stepped = created;
        if (created == MENISCUS_OK)
            stepped = meniscus_step(surface, &particles);
        if (stepped == MENISCUS_OK)
            stepped = meniscus_balance_momentum(surface, &particles);
        allocations_left = std::numeric_limits<int>::max();
        if (stepped == MENISCUS_OK) {
            meniscus_destroy(surface);
            break;
        }
        ASSERT_EQ(stepped, MENISCUS_OUT_OF_MEMORY) << granted;
        EXPECT_STREQ(meniscus_last_error(), "out of memory");
        failures_in_create += created != MENISCUS_OK ? 1 : 0;
        failures_in_step += created == MENISCUS_OK ? 1 : 0;
        if (created == MENISCUS_OK)
            EXPECT_EQ(meniscus_step(surface, &particles), MENISCUS_FAILURE);
        else
            EXPECT_EQ(surface, nullptr);
        meniscus_destroy(surface);
    }
    EXPECT_GT(failures_in_create, 5);
    EXPECT_GT(failures_in_step, 20);
}

} // namespace
} // namespace meniscus
