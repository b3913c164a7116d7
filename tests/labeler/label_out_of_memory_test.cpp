// However little memory there is, labelling ends in an exception, whichever thread runs out of it:
// each allocation fails once.
#include "runtime/own_new.hpp"

#include <meniscus/labeler/labeler.hpp>

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

Snapshot block(int edge) {
    Snapshot snapshot;
    for (int x = 0; x < edge; ++x)
        for (int y = 0; y < edge; ++y)
            for (int z = 0; z < edge; ++z)
                snapshot.positions.push_back({double(x), double(y), double(z)});
    return snapshot;
}

TEST(LabelOutOfMemory, EveryAllocationMayFail) {
    Snapshot snapshot = block(8);
    snapshot.boundary = {{-1, 0, 0}, {-1, 1, 0}};
    LabelOptions options;
    options.threads = 2;
    options.features = {0, 2};
    int failures = 0;
    for (int granted = 0;; ++granted) {
        ASSERT_LT(granted, 10000);
        bool failed = false;
        allocations_left = granted;
        try {
            label_particles(snapshot, 2, options);
        } catch (const std::bad_alloc&) {
            failed = true;
        }
        allocations_left = std::numeric_limits<int>::max();
        if (!failed)
            break;
        ++failures;
    }
    EXPECT_GT(failures, 40);
}

} // namespace
} // namespace meniscus
