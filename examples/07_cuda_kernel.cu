// Surface tension of the paper in a kernel, one thread a particle: features and line in the sums of
// a density loop, then samples, cells, normal and force for the candidates. Compile as
//     nvcc -std=c++17 --expt-relaxed-constexpr -fmad=false -I INCLUDE -c 07_cuda_kernel.cu
#include <meniscus/runtime/coefficients/surface_3d.hpp>
#include <meniscus/runtime/features/classifier.hpp>
#include <meniscus/runtime/features/line_features.hpp>
#include <meniscus/runtime/surface/one_particle.hpp>

using Line = meniscus::Surface3D;

/// Neighbors in compressed rows; everything in the GPU's memory.
struct Fluid {
    const float* positions; // 3 a particle, m
    const float* masses;    // kg
    const unsigned* offsets;
    const unsigned* neighbors;
    unsigned count;
    float support_radius, spacing; // m
    float surface_tension;         // N/m
};

/// force: 3 a particle, N; state: 0 interior, 1 surface, 2 covered, 3 undecided or too many
/// neighbors.
__global__ void add_surface_tension(Fluid fluid, meniscus::DirectionSets directions,
                                    meniscus::CellSet coarse, meniscus::CellSet fine, double scale,
                                    float* force, unsigned char* state) {
    const unsigned i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= fluid.count)
        return;
    const meniscus::UniformRadius<float> radius{fluid.support_radius};
    const auto range = meniscus::range_of(radius, Line::radius_ratio);
    meniscus::LineSum<Line, float, 3> sum;
    meniscus::ParticleCaps<float, 96> caps;
    const auto near = meniscus::neighbor_range<float>(1, Line::radius_ratio);
    for (unsigned k = fluid.offsets[i]; k < fluid.offsets[i + 1]; ++k) {
        const unsigned j = fluid.neighbors[k];
        float step[3];
        float in_radii[3];
        for (int axis = 0; axis < 3; ++axis) {
            step[axis] = fluid.positions[3 * j + axis] - fluid.positions[3 * i + axis];
            in_radii[axis] = step[axis] * radius.inverse;
        }
        sum.add(step, fluid.masses[j], i, j, radius, range);
        caps.add<3>(in_radii, near, Line::radius_ratio);
    }
    state[i] = 0;
    for (int axis = 0; axis < 3; ++axis)
        force[3 * i + axis] = 0;
    if (!meniscus::is_surface(sum, scale))
        return;
    const auto part = meniscus::sampled_part<3>(directions, i, caps);
    if (caps.is_full) {
        state[i] = 3;
        return;
    }
    if (!part.is_certain) {
        state[i] = meniscus::is_held(coarse, caps) || meniscus::is_held(fine, caps) ? 2 : 3;
        return;
    }
    state[i] = 1;
    const auto found = meniscus::one_particle<float, 3>(part, Line::radius_ratio, 0);
    meniscus::set_paper_force<float, 3>(found, fluid.surface_tension, fluid.support_radius,
                                        fluid.spacing, force + 3 * i);
}
