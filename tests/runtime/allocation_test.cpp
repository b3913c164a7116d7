// Within what was reserved, a step allocates nothing: no call of operator new from here on counts
// but those of steps.
#include "fluids.hpp"
#include "own_new.hpp"
#include "two_threads.hpp"

#include <gtest/gtest.h>

#include <atomic>

namespace {

std::atomic<bool> counting{false};
std::atomic<int> allocations{0};

} // namespace

void* allocate(std::size_t size) {
    if (counting)
        ++allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1))
        return memory;
    throw std::bad_alloc();
}

namespace meniscus {
namespace {

template <class Act>
int allocations_in(const Act& act) {
    allocations = 0;
    counting = true;
    act();
    counting = false;
    return allocations;
}

template <class Real, int Dimension>
std::size_t max_neighbors(const Fluid<Real, Dimension>& fluid) {
    std::size_t max = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i)
        max = std::max(max, fluid.offsets[i + 1] - fluid.offsets[i]);
    return max;
}

/// The options under which every stage runs.
template <int Dimension>
std::vector<SurfaceTensionOptions> options_of_all_stages() {
    std::vector<SurfaceTensionOptions> all = {options_for<Dimension>(),
                                              options_for<Dimension>(paper_options())};
    for (auto& options : all) {
        options.covariance_share = 0.3;
        options.curvature_passes = 2;
    }
    all.push_back(all[0]);
    all.back().coverage = CoverageMethod::exact;
    return all;
}

/// First steps after reserve(), and later ones with other numbers of samples.
template <class Real, int Dimension, class Loop>
void expect_no_allocation(const Fluid<Real, Dimension>& fluid, const Loop& loop) {
    const std::vector<std::uint8_t> all(fluid.size(), 1);
    std::vector<int> counts;
    for (std::size_t i = 0; i < fluid.size(); ++i)
        counts.push_back(static_cast<int>(fluid.offsets[i + 1] - fluid.offsets[i]));
    const auto view = fluid.view();
    for (const auto& options : options_of_all_stages<Dimension>()) {
        SurfaceTension<Real, Dimension> tension(options);
        tension.reserve(fluid.size(), max_neighbors(fluid), loop.workers());
        const auto step_and_balance = [&](const auto& boundary) {
            tension.step(view, boundary, fluid.size(), fluid.radii(), nullptr, loop);
            tension.template balance_momentum<Dimension>(view, boundary, fluid.radii(),
                                                         fluid.coordinates(), loop);
        };
        EXPECT_EQ(allocations_in([&] { step_and_balance(NoBoundary{}); }), 0);
        EXPECT_EQ(allocations_in([&] {
                      tension.set_samples(200);
                      step_and_balance(NoBoundary{});
                      tension.set_samples(16);
                      tension.set_line({1000, 1000}); // everything is a candidate
                      step_and_balance(NoBoundary{});
                  }),
                  0);
        EXPECT_EQ(tension.surface().size(), fluid.size());
        EXPECT_EQ(allocations_in([&] {
                      tension.step(view, NoBoundary{}, fluid.size(), fluid.radii(), nullptr,
                                   all.data(), counts.data(), loop);
                  }),
                  0);
    }
}

template <class Real, int Dimension>
void expect_no_allocation() {
    const TwoThreads two_threads;
    for (const auto& fluid : {ball<Real, Dimension>(5, 0.2), block<Real, Dimension>({7, 7, 7}),
                              Fluid<Real, Dimension>({{}, {Real(0.5)}, {Real(0.9)}}, 1)}) {
        expect_no_allocation(fluid, SerialLoop{});
        expect_no_allocation(fluid, two_threads);
    }
}

TEST(Allocation, NoneInFloat3D) {
    expect_no_allocation<float, 3>();
}
TEST(Allocation, NoneInDouble3D) {
    expect_no_allocation<double, 3>();
}
TEST(Allocation, NoneInFloat2D) {
    expect_no_allocation<float, 2>();
}
TEST(Allocation, NoneInDouble2D) {
    expect_no_allocation<double, 2>();
}

/// Without reserve() the first step allocates, which shows that the count counts, and a second
/// equal one does not.
TEST(Allocation, OnlyWhileMemoryGrows) {
    const auto fluid = ball<float, 3>(5, 0.2);
    SurfaceTension<float, 3> tension(options_for<3>());
    const auto step = [&] {
        tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    };
    EXPECT_GT(allocations_in(step), 0);
    EXPECT_EQ(allocations_in(step), 0);
}

} // namespace
} // namespace meniscus
