#include "coverage.hpp"

#include "detail/coverage_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace meniscus {
namespace {

double dot(const Direction& a, const Direction& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Splits the directions at the median of their widest coordinate until a part fits one block.
void sort_into_blocks(Direction* begin, Direction* end) {
    const auto count = static_cast<std::size_t>(end - begin);
    if (count <= DirectionBlocks::block_size)
        return;
    Direction low = *begin;
    Direction high = *begin;
    for (const Direction* direction = begin; direction != end; ++direction)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], (*direction)[axis]);
            high[axis] = std::max(high[axis], (*direction)[axis]);
        }
    int widest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (high[axis] - low[axis] > high[widest] - low[widest])
            widest = axis;
    const std::size_t blocks =
        (count + DirectionBlocks::block_size - 1) / DirectionBlocks::block_size;
    Direction* middle = begin + (blocks / 2) * DirectionBlocks::block_size;
    std::nth_element(begin, middle, end, [widest](const Direction& a, const Direction& b) {
        // All coordinates take part, so that the order is the same everywhere.
        return a[widest] != b[widest] ? a[widest] < b[widest] : a < b;
    });
    sort_into_blocks(begin, middle);
    sort_into_blocks(middle, end);
}

void fill_float_lanes(DirectionBlocks& blocks) {
    const std::size_t size = DirectionBlocks::block_size;
    const std::size_t padded = (blocks.size() + size - 1) / size * size;
    blocks.x.assign(padded, 0);
    blocks.y.assign(padded, 0);
    blocks.z.assign(padded, 0);
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        blocks.x[k] = static_cast<float>(blocks.directions[k][0]);
        blocks.y[k] = static_cast<float>(blocks.directions[k][1]);
        blocks.z[k] = static_cast<float>(blocks.directions[k][2]);
    }
}

/// Product with a block's center above which the block lies inside the cap, and that up to which it
/// lies outside, for a cap of angular radius theta and blocks of angular radius r: |x| times
/// cos(theta - r) and cos(theta + r).
void set_block_limits(Caps& caps, std::size_t place, double distance, double threshold,
                      const DirectionBlocks& blocks) {
    constexpr float never = std::numeric_limits<float>::infinity();
    const double cos_theta = threshold / distance;
    const double sin_theta = std::sqrt(std::max(0.0, 1 - cos_theta * cos_theta));
    const double along = cos_theta * blocks.cos_radius;
    const double across = sin_theta * blocks.sin_radius;
    const bool block_fits = cos_theta < blocks.cos_radius;
    const bool reaches_around = cos_theta <= -blocks.cos_radius;
    caps.inner[place] =
        block_fits ? static_cast<float>(distance * (along + across) + kernel_float_error) : never;
    caps.outer[place] = reaches_around
                            ? -never
                            : static_cast<float>(distance * (along - across) - kernel_float_error);
}

/// Sorts the caps, the largest first, and works out what the kernel compares with. Caps that cover
/// nothing are left out.
void prepare(Caps& caps, const DirectionBlocks& blocks) {
    const double constant = 1 - caps.radius_ratio * caps.radius_ratio;
    const auto cosine = [&](std::uint32_t n) {
        const double square = dot(caps.displacements[n], caps.displacements[n]);
        return (square + constant) / (2 * std::sqrt(square));
    };
    caps.sorted.clear();
    caps.threshold_double.clear();
    caps.order.clear();
    caps.cosine.clear();
    for (std::uint32_t n = 0; n < caps.displacements.size(); ++n) {
        caps.cosine.push_back(cosine(n));
        if (caps.cosine.back() < 1) // also false where the distance is 0
            caps.order.push_back(n);
    }
    std::sort(caps.order.begin(), caps.order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return caps.cosine[a] != caps.cosine[b] ? caps.cosine[a] < caps.cosine[b] : a < b;
    });
    const std::size_t padded = (caps.order.size() + kernel_lanes - 1) / kernel_lanes * kernel_lanes;
    constexpr float never = std::numeric_limits<float>::infinity();
    for (auto* coordinate : {&caps.x, &caps.y, &caps.z})
        coordinate->assign(padded, 0);
    for (auto* limit : {&caps.threshold, &caps.inner, &caps.outer})
        limit->assign(padded, never);
    for (std::size_t place = 0; place < caps.order.size(); ++place) {
        const Direction& displacement = caps.displacements[caps.order[place]];
        const double square = dot(displacement, displacement);
        const double threshold = (square + constant) / 2;
        caps.sorted.push_back(displacement);
        caps.threshold_double.push_back(threshold);
        caps.x[place] = static_cast<float>(displacement[0]);
        caps.y[place] = static_cast<float>(displacement[1]);
        caps.z[place] = static_cast<float>(displacement[2]);
        caps.threshold[place] = static_cast<float>(threshold);
        set_block_limits(caps, place, std::sqrt(square), threshold, blocks);
    }
}

} // namespace

DirectionBlocks compact_blocks(std::vector<Direction> directions) {
    DirectionBlocks blocks;
    blocks.directions = std::move(directions);
    sort_into_blocks(blocks.directions.data(), blocks.directions.data() + blocks.size());
    fill_float_lanes(blocks);
    blocks.cos_radius = 1;
    for (std::size_t begin = 0; begin < blocks.size(); begin += DirectionBlocks::block_size) {
        const std::size_t end = std::min(begin + DirectionBlocks::block_size, blocks.size());
        Direction center{};
        for (std::size_t k = begin; k < end; ++k)
            for (int axis = 0; axis < 3; ++axis)
                center[axis] += blocks.directions[k][axis];
        const double length = std::sqrt(dot(center, center));
        if (length > 1e-6)
            for (double& coordinate : center)
                coordinate /= length;
        else
            center = blocks.directions[begin];
        blocks.centers.push_back(center);
        for (std::size_t k = begin; k < end; ++k)
            blocks.cos_radius = std::min(blocks.cos_radius, dot(center, blocks.directions[k]));
    }
    blocks.cos_radius = std::max(-1.0, blocks.cos_radius - 1e-9);
    blocks.sin_radius = std::sqrt(1 - blocks.cos_radius * blocks.cos_radius);
    return blocks;
}

void plain_blocks(const std::vector<Direction>& directions, DirectionBlocks& blocks) {
    blocks.directions = directions;
    fill_float_lanes(blocks);
    blocks.centers.assign(blocks.x.size() / DirectionBlocks::block_size, Direction{1, 0, 0});
    blocks.cos_radius = -1; // as wide as the sphere
    blocks.sin_radius = 0;
}

std::size_t count_uncovered(const DirectionBlocks& blocks, Caps& caps, InstructionSet widest) {
    thread_local std::vector<std::uint32_t> near_places;
    prepare(caps, blocks);
    near_places.resize(caps.x.size());
    return with_instruction_set(widest, [&](auto set) {
        return count_uncovered_by_kernel(set, blocks, caps, near_places.data());
    });
}

std::size_t count_uncovered_reference(const std::vector<Direction>& directions,
                                      const std::vector<Direction>& displacements,
                                      double radius_ratio) {
    std::size_t uncovered = 0;
    for (const Direction& p : directions) {
        bool covered = false;
        for (const Direction& x : displacements) {
            const Direction difference{p[0] - x[0], p[1] - x[1], p[2] - x[2]};
            if (dot(difference, difference) < radius_ratio * radius_ratio) {
                covered = true;
                break;
            }
        }
        uncovered += covered ? 0 : 1;
    }
    return uncovered;
}

} // namespace meniscus
