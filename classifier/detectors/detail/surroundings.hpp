// What a detector sums over: the neighbors of a particle, fluid and boundary, each with its volume.
#pragma once

#include <meniscus/classifier/detectors/cones.hpp>
#include <meniscus/classifier/model/classify_snapshot.hpp>

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/math/cubic_spline.hpp>
#include <meniscus/runtime/neighbors/parallel_loop.hpp>

#include <cmath>

namespace meniscus {

enum class Kernel {
    cubic_spline, ///< Monaghan 1992
    wendland,     ///< C2, Wendland 1995
};

/// -W'(q) / q of the kernel of radius 1, q in [0, 1); not negative.
template <int Dimension>
double kernel_slope(Kernel kernel, double q) {
    if (kernel == Kernel::wendland) {
        constexpr double scale = Dimension == 3 ? 21 / (2 * pi) : 7 / pi;
        return 20 * scale * (1 - q) * (1 - q) * (1 - q);
    }
    const CubicSplinePieces<double, double> pieces(q);
    return q > 0 ? -pieces.slope(cubic_spline_scale<Dimension>) / q : 0;
}

/// Of the fluid's particles, in m^dimension.
struct FluidVolumes {
    double at_rest = 0;
    std::vector<double> each; ///< m / rho; empty where a snapshot does not have both

    [[nodiscard]] double of(std::size_t i) const { return each.empty() ? at_rest : each[i]; }
};

/// Throws InputError where the density of a valid particle is not positive and finite.
inline FluidVolumes fluid_volumes(const Snapshot& snapshot, const Neighborhoods& neighborhoods) {
    FluidVolumes volumes;
    const double spacing = neighborhoods.radii.max / neighborhoods.spacing_ratio;
    volumes.at_rest = snapshot.dimension == 3 ? spacing * spacing * spacing : spacing * spacing;
    if (neighborhoods.masses.empty() || find_array(snapshot, "density") == nullptr)
        return volumes;
    volumes.each = scalar_values(snapshot, "density");
    for (std::size_t i = 0; i < volumes.each.size(); ++i) {
        double& value = volumes.each[i];
        if (neighborhoods.valid[i] != 0 && !(value > 0 && std::isfinite(value)))
            throw InputError("particle " + std::to_string(i) + " has density " +
                             number_text(value) + ", expected a positive number");
        value = neighborhoods.masses[i] / value;
    }
    return volumes;
}

template <int Dimension>
struct Surroundings {
    const Snapshot& snapshot;
    const Neighborhoods& neighborhoods;
    const FluidVolumes& volumes;
    Kernel kernel;
    int threads;

    using Step = Vector<double, Dimension>;

    /// sum_j V_j grad W_ij (x_j - x_i)^T, the renormalization matrix, whose trace is the divergence
    /// of position; and sum_j V_j grad W_ij, the gradient of the constant 1.
    struct Gradients {
        Eigen::Matrix<double, Dimension, Dimension> matrix;
        Step of_one;
    };

    [[nodiscard]] double smoothing_length() const { return neighborhoods.radii.max / 2; }

    /// Calls work(i) for each valid particle.
    template <class Work>
    void each(const Work& work) const {
        const OpenMpLoop loop{threads > 0 ? threads : omp_get_max_threads()};
        loop(snapshot.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
            for (std::size_t i = begin; i < end; ++i)
                if (neighborhoods.valid[i] != 0)
                    work(i);
        });
    }

    /// Calls visit(j, x_j - x_i, V_j) for the fluid around i.
    template <class Visit>
    void visit_fluid(std::size_t i, const Visit& visit) const {
        const NeighborLists& lists = neighborhoods.lists;
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const std::size_t j = lists.neighbors[n];
            visit(j, step(snapshot.positions[j], i), volumes.of(j));
        }
    }

    /// Calls visit(x_j - x_i, V_j) for fluid and boundary around i.
    template <class Visit>
    void visit(std::size_t i, const Visit& visit) const {
        visit_fluid(
            i, [&](std::size_t /*j*/, const Step& step, double volume) { visit(step, volume); });
        const NeighborLists& lists = neighborhoods.boundary_lists;
        if (lists.offsets.empty())
            return;
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const std::size_t b = lists.neighbors[n];
            const double share =
                neighborhoods.boundary_weights.of(b, neighborhoods.radii.max, Dimension);
            visit(step(snapshot.boundary[b], i), share * volumes.at_rest);
        }
    }

    /// V_j grad_i W_ij for a neighbor at that step: towards it.
    [[nodiscard]] Step gradient(const Step& step, double volume) const {
        const double h = neighborhoods.radii.max;
        const double q = std::fmin(step.norm() / h, 1.0);
        const double share = volume / (Dimension == 3 ? h * h * h : h * h);
        return share * kernel_slope<Dimension>(kernel, q) / (h * h) * step;
    }

    [[nodiscard]] Gradients gradients(std::size_t i) const {
        Gradients sums;
        sums.matrix.setZero();
        sums.of_one.setZero();
        visit(i, [&](const Step& step, double volume) {
            const Step along = gradient(step, volume);
            sums.matrix += along * step.transpose();
            sums.of_one += along;
        });
        return sums;
    }

    /// The volume of the neighbors in that of a full support.
    [[nodiscard]] double filled_share(std::size_t i) const {
        const double h = neighborhoods.radii.max;
        const double support = Dimension == 3 ? 4 * pi / 3 * h * h * h : pi * h * h;
        double filled = 0;
        visit(i, [&](const Step& /*step*/, double /*volume*/) { filled += volumes.at_rest; });
        return filled / support;
    }

    /// Whether a neighbor lies in the cone along `outward`. A vector that vanishes or is not finite
    /// cannot show that a particle is covered, nor do others in its place.
    template <class Cone>
    [[nodiscard]] bool is_covered(std::size_t i, const Step& outward, const Cone& cone) const {
        const double length = outward.norm();
        if (!(length > 0))
            return false;
        const Step normal = outward / length;
        bool covered = false;
        visit(i, [&](const Step& step, double /*volume*/) {
            covered = covered || (step.squaredNorm() > 0 && cone(step, normal));
        });
        return covered;
    }

private:
    [[nodiscard]] Step step(const std::array<double, 3>& to, std::size_t i) const {
        Step step;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            step[static_cast<int>(axis)] = to[axis] - snapshot.positions[i][axis];
        return step;
    }
};

} // namespace meniscus
