#include "detectors.hpp"

#include "detail/surroundings.hpp"

#include <meniscus/data/text/errors.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

/// What stands for one of the kinds: fills the responses of the valid particles.
template <int Dimension>
using Respond = void (*)(const DetectorKind&, const Surroundings<Dimension>&, std::vector<double>&);

template <int Dimension>
void divergences(const Surroundings<Dimension>& fluid, std::vector<double>& responses) {
    fluid.each([&](std::size_t i) { responses[i] = fluid.gradients(i).matrix.trace(); });
}

template <int Dimension>
void chrono(const DetectorKind& /*kind*/, const Surroundings<Dimension>& fluid,
            std::vector<double>& responses) {
    divergences(fluid, responses);
}

/// What lies within a smoothing length of a particle below the threshold is surface, too.
template <int Dimension>
void sphinxsys(const DetectorKind& /*kind*/, const Surroundings<Dimension>& fluid,
               std::vector<double>& responses) {
    std::vector<double> own(responses.size());
    divergences(fluid, own);
    const double length = fluid.smoothing_length();
    fluid.each([&](std::size_t i) {
        responses[i] = own[i];
        fluid.visit_fluid(i, [&](std::size_t j, const auto& step, double /*volume*/) {
            if (step.squaredNorm() < length * length)
                responses[i] = std::min(responses[i], own[j]);
        });
    });
}

/// Less than 0.4 of the neighbors of a full support, and a divergence below this: isolated.
template <int Dimension>
constexpr double isolated_below = Dimension == 3 ? 1.8 : 1.1;
constexpr double isolated_share = 0.4;

template <int Dimension>
void dualsphysics(const DetectorKind& kind, const Surroundings<Dimension>& fluid,
                  std::vector<double>& responses) {
    using Cone = std::conditional_t<Dimension == 3, Umbrella<double>, AxiswiseUmbrella<double>>;
    const Cone cone{fluid.smoothing_length()};
    fluid.each([&](std::size_t i) {
        const auto sums = fluid.gradients(i);
        const double divergence = sums.matrix.trace();
        const bool is_isolated =
            divergence < isolated_below<Dimension> && fluid.filled_share(i) < isolated_share;
        const bool is_open =
            is_isolated || !fluid.is_covered(i, sums.matrix.inverse() * -sums.of_one, cone);
        responses[i] = is_open ? divergence : kind.never();
    });
}

/// Up to this eigenvalue a particle is surface without a look along its normal.
constexpr double certain_surface = 0.2;

/// Eigenvalues first, then the normals and umbrellas of those between the two limits. The normal is
/// the renormalized gradient of the eigenvalue over the fluid: the boundary has none.
template <int Dimension>
void marrone(const DetectorKind& kind, const Surroundings<Dimension>& fluid,
             std::vector<double>& responses) {
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Dimension, Dimension>>;
    std::vector<double> eigenvalues(responses.size());
    fluid.each([&](std::size_t i) {
        Solver solver;
        solver.computeDirect(fluid.gradients(i).matrix, Eigen::EigenvaluesOnly);
        eigenvalues[i] = solver.eigenvalues()[0];
    });
    const Umbrella<double> cone{fluid.smoothing_length()};
    fluid.each([&](std::size_t i) {
        responses[i] = eigenvalues[i];
        if (eigenvalues[i] <= certain_surface)
            return;
        Vector<double, Dimension> rise = Vector<double, Dimension>::Zero();
        fluid.visit_fluid(i, [&](std::size_t j, const auto& step, double volume) {
            rise += (eigenvalues[j] - eigenvalues[i]) * fluid.gradient(step, volume);
        });
        if (fluid.is_covered(i, fluid.gradients(i).matrix.inverse() * -rise, cone))
            responses[i] = kind.never();
    });
}

/// The angle between the cover vector, sum_j (x_i - x_j) / |x_i - x_j|, and the nearest neighbor to
/// its direction. Few neighbors are surface without a look; where the vector vanishes they lie
/// evenly around and cover.
template <int Dimension>
void barecasco(const DetectorKind& kind, const Surroundings<Dimension>& fluid,
               std::vector<double>& responses) {
    constexpr int few = Dimension == 3 ? 15 : 4;
    fluid.each([&](std::size_t i) {
        int count = 0;
        Vector<double, Dimension> cover = Vector<double, Dimension>::Zero();
        fluid.visit(i, [&](const auto& step, double /*volume*/) {
            if (const double distance = step.norm(); distance > 0) {
                cover -= step / distance;
                ++count;
            }
        });
        responses[i] = kind.always();
        if (count <= few)
            return;
        const double length = cover.norm();
        double cosine = length > 0 ? -1 : 1;
        fluid.visit(i, [&](const auto& step, double /*volume*/) {
            if (const double product = step.norm() * length; product > 0)
                cosine = std::max(cosine, step.dot(cover) / product);
        });
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        responses[i] = arctangent(sine, cosine) * 180 / pi;
    });
}

struct Listed {
    DetectorKind kind;
    Kernel kernel;
    Respond<2> in_plane;
    Respond<3> in_space;
};

const std::vector<Listed>& listed() {
    const std::string divergence = "divergence of position";
    static const std::vector<Listed> all = {
        {{"dualsphysics", "divergence of position, then a look into a cone along the normal",
          "DualSPHysics 5.4, advanced shifting (JSphCpu_preloop.cpp)", divergence, 1.7, 2.75, 0, 10,
          true},
         Kernel::wendland,
         dualsphysics<2>,
         dualsphysics<3>},
        {{"sphinxsys", "divergence of position, and all within a smoothing length",
          "SPHinXsys, FreeSurfaceIndication", divergence, 0.75 * 2, 0.75 * 3, 0, 10, true},
         Kernel::wendland,
         sphinxsys<2>,
         sphinxsys<3>},
        {{"chrono", "divergence of position", "Chrono::FSI-SPH, free_surface_threshold", divergence,
          std::nullopt, 2, 0, 10, true},
         Kernel::cubic_spline,
         nullptr,
         chrono<3>},
        {{"marrone", "smallest eigenvalue, then a look into a cone along its gradient",
          "Marrone et al. 2010", "smallest eigenvalue of the renormalization matrix", 0.75, 0.75, 0,
          10, true},
         Kernel::wendland,
         marrone<2>,
         marrone<3>},
        {{"barecasco", "a look into a cone along the cover vector", "Barecasco et al. 2013",
          "angle to the nearest neighbor in front, degrees", 30, 30, 0, 180, false},
         Kernel::wendland, // which it does not use
         barecasco<2>,
         barecasco<3>}};
    return all;
}

const Listed& listed(const std::string& name) {
    for (const Listed& entry : listed())
        if (entry.kind.name == name)
            return entry;
    std::string names;
    for (const Listed& entry : listed())
        names += (names.empty() ? "" : ", ") + entry.kind.name;
    throw InputError("there is no detector '" + name + "'; there are " + names);
}

} // namespace

double DetectorKind::never() const {
    const double infinity = std::numeric_limits<double>::infinity();
    return surface_is_below ? infinity : -infinity;
}

double DetectorKind::default_threshold(int dimension) const {
    if (dimension == 3)
        return default_3d;
    if (!default_2d)
        throw InputError("the detector " + name + " is for three dimensions, as " + source +
                         " is; found a state in the plane");
    return *default_2d;
}

const std::vector<DetectorKind>& detector_kinds() {
    static const std::vector<DetectorKind> kinds = [] {
        std::vector<DetectorKind> made;
        for (const Listed& entry : listed())
            made.push_back(entry.kind);
        return made;
    }();
    return kinds;
}

const DetectorKind& detector_kind(const std::string& name) {
    return listed(name).kind;
}

std::vector<double> detector_responses(const DetectorKind& kind, const Snapshot& snapshot,
                                       const Neighborhoods& neighborhoods, int threads) {
    static_cast<void>(kind.default_threshold(snapshot.dimension)); // refuses
    if (neighborhoods.radii.vary())
        throw InputError("particles have support radii of their own, but the detector " +
                         kind.name + " is for one radius, as " + kind.source + " has it");
    const Listed& entry = listed(kind.name);
    const FluidVolumes volumes = fluid_volumes(snapshot, neighborhoods);
    std::vector<double> responses(snapshot.size());
    if (snapshot.dimension == 2)
        entry.in_plane(entry.kind, {snapshot, neighborhoods, volumes, entry.kernel, threads},
                       responses);
    else
        entry.in_space(entry.kind, {snapshot, neighborhoods, volumes, entry.kernel, threads},
                       responses);
    return responses;
}

} // namespace meniscus
