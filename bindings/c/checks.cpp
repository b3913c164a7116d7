#include "checks.hpp"

#include <meniscus/runtime/neighbors/position_resolution.hpp>
#include <meniscus/runtime/surface/option_table.hpp>

#include <algorithm>
#include <limits>

namespace meniscus {
namespace {

[[noreturn]] void fail_at(const char* member, std::size_t i, const std::string& what) {
    throw std::invalid_argument("particles." + std::string(member) + "[" + std::to_string(i) +
                                "] " + what);
}

template <class Real>
void check_vectors(const char* member, const void* values, std::size_t count, std::size_t stride,
                   std::size_t dimension) {
    const auto* real = static_cast<const Real*>(values);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t axis = 0; axis < dimension; ++axis)
            if (!std::isfinite(real[i * stride + axis]))
                fail_at(member, i, "is not finite");
}

template <class Real>
void check_positive(const char* member, const void* values, std::size_t count) {
    const auto* real = static_cast<const Real*>(values);
    for (std::size_t i = 0; real != nullptr && i < count; ++i)
        if (!is_positive(static_cast<double>(real[i])))
            fail_at(member, i, "is not positive and finite");
}

template <class Real>
void check_radii(const void* values, std::size_t count) {
    check_positive<Real>("support_radii", values, count);
    const auto* real = static_cast<const Real*>(values);
    for (std::size_t i = 0; real != nullptr && i < count; ++i)
        if (!is_usable_radius<Real>(static_cast<double>(real[i])))
            fail_at("support_radii", i,
                    "has a square beyond the range of the number type; is it in m?");
    if (real == nullptr || count == 0)
        return;
    const auto [min, max] = std::minmax_element(real, real + count);
    if (static_cast<double>(*max) / static_cast<double>(*min) > max_radius_contrast)
        fail_at("support_radii", static_cast<std::size_t>(max - real),
                "is more than 1000000 times the smallest; are all in m?");
}

/// Throws where a sum of masses over neighbors may leave the range of Real, or has lost its digits.
template <class Real>
void check_masses(const void* values, std::size_t count) {
    check_positive<Real>("masses", values, count);
    const auto* masses = static_cast<const Real*>(values);
    constexpr Real smallest = std::numeric_limits<Real>::min();
    const Real largest = std::numeric_limits<Real>::max() / static_cast<Real>(count + 1);
    for (std::size_t i = 0; masses != nullptr && i < count; ++i)
        if (masses[i] < smallest || masses[i] > largest)
            fail_at("masses", i,
                    "is so small or large that sums over neighbors leave the range of the number "
                    "type; is it in kg?");
}

/// Throws where Real cannot tell a position from its neighbors'.
template <class Real>
void check_distances(const meniscus_particles& particles, std::size_t stride,
                     std::size_t dimension) {
    const auto* positions = static_cast<const Real*>(particles.positions);
    const auto* radii = static_cast<const Real*>(particles.support_radii);
    for (std::size_t i = 0; i < particles.count; ++i) {
        const double radius =
            radii != nullptr ? static_cast<double>(radii[i]) : particles.support_radius;
        if (position_step(positions + i * stride, static_cast<int>(dimension), radius,
                          std::numeric_limits<Real>::digits) >= coarsest_position_step)
            fail_at("positions", i,
                    "lies so far from the origin that the number type cannot tell it from "
                    "neighbors at its support radius");
    }
}

/// Rows are measured before they are read: offsets of another width than the host says look like
/// rows that begin or end far beyond the array.
template <class Offset>
void check_rows(const char* member, const void* offsets, const std::uint32_t* neighbors,
                std::size_t count, std::size_t others) {
    const auto* row = static_cast<const Offset*>(offsets);
    constexpr const char* width = sizeof(Offset) == 8
                                      ? "; are they of 32 bits where offset_bits says 64?"
                                      : "; are they of 64 bits where offset_bits says 32?";
    if (row[0] != 0)
        fail_at(member, 0, "is " + std::to_string(row[0]) + ", expected 0" + width);
    for (std::size_t i = 0; i < count; ++i) {
        if (row[i + 1] < row[i])
            fail_at(member, i + 1, std::string("is smaller than the one before") + width);
        if (row[i + 1] - row[i] > others)
            fail_at(member, i + 1,
                    "ends a row of " + std::to_string(row[i + 1] - row[i]) +
                        " neighbors, more than there are particles" + width);
        for (Offset n = row[i]; n < row[i + 1]; ++n)
            if (neighbors[n] >= others)
                fail_at(member, i, "begins neighbors of which one does not exist");
    }
}

void check_rows(const char* member, int bits, const void* offsets, const std::uint32_t* neighbors,
                std::size_t count, std::size_t others) {
    if (bits == 64)
        check_rows<std::uint64_t>(member, offsets, neighbors, count, others);
    else
        check_rows<std::uint32_t>(member, offsets, neighbors, count, others);
}

void check_angles(const char* member, const float* angles, std::size_t count) {
    for (std::size_t b = 0; angles != nullptr && b < count; ++b)
        if (!is_in_range(option_ranges::contact_angle, static_cast<double>(angles[b])))
            fail_at(member, b, "must be between 10 and 170 degrees");
}

template <class Real>
void check_walls(const meniscus_particles& particles, std::size_t dimension) {
    const auto* distances = static_cast<const Real*>(particles.wall_distances);
    const auto* normals = static_cast<const Real*>(particles.wall_normals);
    const auto* radii = static_cast<const Real*>(particles.support_radii);
    for (std::size_t n = 0; n < particles.count * particles.wall_count; ++n) {
        if (std::isnan(distances[n]))
            fail_at("wall_distances", n, "is not a number");
        const Real radius = radii != nullptr ? radii[n / particles.wall_count]
                                             : static_cast<Real>(particles.support_radius);
        if (distances[n] >= radius)
            continue;
        double squared = 0;
        for (std::size_t axis = 0; axis < dimension; ++axis) {
            const auto part = static_cast<double>(normals[n * dimension + axis]);
            squared += part * part;
        }
        if (!(squared > 0.9 && squared < 1.1))
            fail_at("wall_normals", n, "is not of length 1, and its wall is within reach");
    }
    check_angles("wall_contact_angles", particles.wall_contact_angles, particles.wall_count);
}

template <class Real>
void check_contents(const meniscus_particles& particles, std::size_t dimension) {
    const std::size_t count = particles.count;
    const std::size_t stride = particles.stride != 0 ? particles.stride : dimension;
    check_vectors<Real>("positions", particles.positions, count, stride, dimension);
    check_radii<Real>(particles.support_radii, count);
    check_masses<Real>(particles.masses, count);
    check_distances<Real>(particles, stride, dimension);
    check_rows("offsets", particles.offset_bits, particles.offsets, particles.neighbors, count,
               count);
    check_walls<Real>(particles, dimension);
    if (particles.boundary_positions == nullptr)
        return;
    check_vectors<Real>("boundary_positions", particles.boundary_positions,
                        particles.boundary_count, stride, dimension);
    check_positive<Real>("boundary_weights", particles.boundary_weights, particles.boundary_count);
    check_angles("boundary_contact_angles", particles.boundary_contact_angles,
                 particles.boundary_count);
    check_rows("boundary_offsets", particles.offset_bits, particles.boundary_offsets,
               particles.boundary_neighbors, count, particles.boundary_count);
}

} // namespace

std::size_t checked_stride(const char* name, std::size_t stride, std::size_t dimension,
                           std::size_t count) {
    if (stride == 0)
        return dimension;
    if (stride < dimension)
        throw std::invalid_argument(std::string(name) + " is less than the dimension");
    const auto most = static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max());
    if (stride > most / sizeof(double) / std::max(count, std::size_t{1}))
        throw std::invalid_argument(std::string(name) + " is so large that no array can be");
    return stride;
}

void check_particles(const meniscus_particles* particles, const ArrayKind& kind) {
    check_struct(particles, "particles");
    const auto& [size, count, positions, stride, masses, radius, radii, ids, offsets, neighbors,
                 offset_bits, boundary_count, boundary, boundary_offsets, boundary_neighbors,
                 boundary_weights, boundary_contact_angles, candidates, wall_count, wall_distances,
                 wall_normals, wall_contact_angles] = *particles;
    demand(count <= std::size_t{std::numeric_limits<std::int32_t>::max()},
           "particles.count must be below 2^31");
    if (count == 0)
        return;
    demand(positions != nullptr, "particles.positions is NULL");
    checked_stride("particles.stride", stride, kind.dimension,
                   boundary != nullptr ? std::max(count, boundary_count) : count);
    demand(radii != nullptr || (kind.is_double ? is_usable_radius<double>(radius)
                                               : is_usable_radius<float>(radius)),
           "particles.support_radius must be positive and finite, and its square within the range "
           "of the number type, where support_radii is NULL");
    demand(offset_bits == 32 || offset_bits == 64, "particles.offset_bits must be 32 or 64");
    demand(offsets != nullptr, "particles.offsets is NULL");
    const auto is_empty = [&, bits = offset_bits, count = count](const void* some) {
        return bits == 64 ? static_cast<const std::uint64_t*>(some)[count] == 0
                          : static_cast<const std::uint32_t*>(some)[count] == 0;
    };
    demand(neighbors != nullptr || is_empty(offsets), "particles.neighbors is NULL");
    demand(wall_count <= max_walls, "particles.wall_count is more than 1024");
    demand(wall_count == 0 || wall_distances != nullptr, "particles.wall_distances is NULL");
    demand(wall_count == 0 || wall_normals != nullptr, "particles.wall_normals is NULL");
    if (boundary == nullptr)
        return;
    demand(boundary_offsets != nullptr, "particles.boundary_offsets is NULL");
    demand(boundary_neighbors != nullptr || is_empty(boundary_offsets),
           "particles.boundary_neighbors is NULL");
}

void check_contents(const meniscus_particles& particles, const ArrayKind& kind) {
    if (particles.count == 0)
        return;
    if (kind.is_double)
        check_contents<double>(particles, kind.dimension);
    else
        check_contents<float>(particles, kind.dimension);
}

StepParticles step_particles(const meniscus_particles& from) {
    StepParticles to;
    to.count = from.count;
    to.positions = from.positions;
    to.stride = from.stride;
    to.masses = from.masses;
    to.support_radius = from.support_radius;
    to.support_radii = from.support_radii;
    to.ids = from.ids;
    to.offsets = from.offsets;
    to.neighbors = from.neighbors;
    to.wide_offsets = from.offset_bits == 64;
    to.boundary_positions = from.boundary_positions;
    to.boundary_count = from.boundary_count;
    to.boundary_offsets = from.boundary_offsets;
    to.boundary_neighbors = from.boundary_neighbors;
    to.boundary_weights = from.boundary_weights;
    to.boundary_contact_angles = from.boundary_contact_angles;
    to.wall_count = from.wall_count;
    to.wall_distances = from.wall_distances;
    to.wall_normals = from.wall_normals;
    to.wall_contact_angles = from.wall_contact_angles;
    to.candidates = from.candidates;
    return to;
}

} // namespace meniscus
