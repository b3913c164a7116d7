// Sandim et al. 2016, Boundary detection in particle-based fluids: what can be seen from places
// outside the fluid is its surface. Seen by hidden-point removal (Katz et al. 2007): particles
// around a viewpoint are flipped inside out, and those on the convex hull of the flipped ones and
// the viewpoint are visible. The hulls are independent of each other.
//
// A particle is to be surface where a ball of radius rho touches it that holds no other. Viewpoints
// are, as in the authors' program (github.com/marcos-sandim/boundary-detection), on a grid of cells
// of 2 rho, the centers of empty cells beside others, and in cells that have no empty one beside
// them the places rho off a particle, away from the mean of what lies within 2 rho, around which
// 0.95 rho are empty. A viewpoint looks at all within 4 rho.
//
// Chosen here, where that program says that the smoothing length is a good rho in general: the
// support radius, since in its example of a vortex rho is about 2.7 spacings; and half of it.
// Flipped distances are d^(1 - gamma), with gamma 1.3 as in both of its examples.
//
// Their program fails where all that a viewpoint sees lies in one plane with it. Here all of that
// is visible: there is nothing that could hide it. Of particles in one place one is visible.
#include "detector.hpp"

#include <meniscus/runtime/neighbors/parallel_loop.hpp>

#include <libqhullcpp/Qhull.h>
#include <libqhullcpp/QhullError.h>
#include <libqhullcpp/QhullVertex.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <omp.h>

namespace meniscus {
namespace {

constexpr double flip_exponent = 1.3;
/// The farthest particle's distance is this part of 1 before it is flipped.
constexpr double farthest_distance = 1 / 1.1;

using Place = std::array<double, 3>;
using CellIndex = std::array<std::int64_t, 3>;

/// The cells of edge 2 rho that particles lie in, and the empty ones beside them; both sorted.
struct SightCells {
    double edge;
    std::vector<CellIndex> full;
    std::vector<CellIndex> empty;

    [[nodiscard]] CellIndex of(const Place& place) const {
        CellIndex cell;
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell[axis] = static_cast<std::int64_t>(std::floor(place[axis] / edge));
        return cell;
    }

    [[nodiscard]] Place center(const CellIndex& cell) const {
        Place place;
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] = (static_cast<double>(cell[axis]) + 0.5) * edge;
        return place;
    }
};

template <class Visit>
void visit_cells_beside(const CellIndex& cell, int dimension, Visit&& visit) {
    const int depth = dimension == 3 ? 1 : 0;
    for (int z = -depth; z <= depth; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (x != 0 || y != 0 || z != 0)
                    visit(CellIndex{cell[0] + x, cell[1] + y, cell[2] + z});
}

void sort_unique(std::vector<CellIndex>& cells) {
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

SightCells sight_cells(const Positions& positions, int dimension, double edge) {
    SightCells cells{edge, {}, {}};
    for (const Place& position : positions)
        cells.full.push_back(cells.of(position));
    sort_unique(cells.full);
    std::vector<CellIndex> beside;
    for (const CellIndex& cell : cells.full)
        visit_cells_beside(cell, dimension, [&](const CellIndex& near) { beside.push_back(near); });
    sort_unique(beside);
    std::set_difference(beside.begin(), beside.end(), cells.full.begin(), cells.full.end(),
                        std::back_inserter(cells.empty));
    return cells;
}

/// What a thread needs for a viewpoint.
struct Sight {
    FoundNeighbors found;
    std::vector<double> flipped; ///< `dimension` values a particle, the viewpoint last
};

/// The detection, with the memory that it keeps.
template <class Real>
struct Visibility {
    const FluidState<Real>& state;
    double rho;
    int threads;
    Positions positions;
    std::vector<Place> viewpoints;
    std::vector<Sight> sights;                       ///< one a thread
    std::vector<std::vector<std::uint32_t>> visible; ///< found by each thread

    void operator()(std::vector<std::uint8_t>& surface);

private:
    void copy_positions();
    [[nodiscard]] bool find_viewpoint(const NeighborGrid& grid, const Place& position, Sight& sight,
                                      Place& viewpoint) const;
    void place_viewpoints(const NeighborGrid& grid);
    void look(const NeighborGrid& grid, const Place& viewpoint, Sight& sight,
              std::vector<std::uint32_t>& seen) const;
};

template <class Real>
void Visibility<Real>::copy_positions() {
    const auto dimension = static_cast<std::size_t>(state.dimension);
    positions.assign(state.size(), Place{});
    for (std::size_t i = 0; i < state.size(); ++i)
        for (std::size_t axis = 0; axis < dimension; ++axis)
            positions[i][axis] = static_cast<double>(state.positions[dimension * i + axis]);
}

/// Whether there is room for a viewpoint near a particle in a cell without empty ones beside it.
template <class Real>
bool Visibility<Real>::find_viewpoint(const NeighborGrid& grid, const Place& position, Sight& sight,
                                      Place& viewpoint) const {
    grid.find_around(position, 2 * rho, sight.found);
    Place sum{};
    for (const Place& step : sight.found.displacements)
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum[axis] -= step[axis];
    const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    if (!(length > 0))
        return false;
    for (std::size_t axis = 0; axis < 3; ++axis)
        viewpoint[axis] = position[axis] + rho / length * sum[axis];
    grid.find_around(viewpoint, 0.95 * rho, sight.found);
    return sight.found.size() == 0;
}

template <class Real>
void Visibility<Real>::place_viewpoints(const NeighborGrid& grid) {
    const SightCells cells = sight_cells(positions, state.dimension, 2 * rho);
    viewpoints.clear();
    for (const CellIndex& cell : cells.empty) {
        viewpoints.push_back(cells.center(cell));
        if (state.dimension == 2)
            viewpoints.back()[2] = 0;
    }
    std::vector<CellIndex> open; // full cells beside an empty one
    for (const CellIndex& cell : cells.empty)
        visit_cells_beside(cell, state.dimension,
                           [&](const CellIndex& near) { open.push_back(near); });
    sort_unique(open);
    std::vector<std::vector<Place>> found(static_cast<std::size_t>(threads));
    OpenMpLoop{threads}(state.size(), [&](std::size_t begin, std::size_t end, int worker) {
        const auto w = static_cast<std::size_t>(worker);
        Place viewpoint;
        for (std::size_t i = begin; i < end; ++i)
            if (!std::binary_search(open.begin(), open.end(), cells.of(positions[i])) &&
                find_viewpoint(grid, positions[i], sights[w], viewpoint))
                found[w].push_back(viewpoint);
    });
    for (const auto& places : found)
        viewpoints.insert(viewpoints.end(), places.begin(), places.end());
}

/// Appends the names of the points that are vertices of their convex hull; all names where the
/// points lie in one plane, on one line or in one place. The last of the points has no name.
void append_hull(const std::vector<double>& points, int dimension,
                 const std::vector<std::uint32_t>& names, std::vector<std::uint32_t>& seen) {
    try {
        orgQhull::Qhull hull;
        hull.disableOutputStream();
        hull.runQhull("", dimension, static_cast<int>(names.size()) + 1, points.data(), "Qt");
        for (const auto& vertex : hull.vertexList()) {
            const auto point = static_cast<std::size_t>(vertex.point().id());
            if (point < names.size())
                seen.push_back(names[point]);
        }
    } catch (const orgQhull::QhullError&) {
        seen.insert(seen.end(), names.begin(), names.end());
    }
}

template <class Real>
void Visibility<Real>::look(const NeighborGrid& grid, const Place& viewpoint, Sight& sight,
                            std::vector<std::uint32_t>& seen) const {
    const auto dimension = static_cast<std::size_t>(state.dimension);
    grid.find_around(viewpoint, 4 * rho, sight.found);
    const auto& near = sight.found.particles;
    if (near.size() <= dimension) {
        seen.insert(seen.end(), near.begin(), near.end());
        return;
    }
    double farthest = 0;
    for (const Place& step : sight.found.displacements)
        farthest = std::max(farthest, std::hypot(step[0], step[1], step[2]));
    const double scale = farthest_distance / farthest;
    sight.flipped.clear();
    for (const Place& step : sight.found.displacements) {
        const double distance = scale * std::hypot(step[0], step[1], step[2]);
        const double factor = scale * std::pow(distance, -flip_exponent);
        for (std::size_t axis = 0; axis < dimension; ++axis)
            sight.flipped.push_back(factor * step[axis]);
    }
    sight.flipped.insert(sight.flipped.end(), dimension, 0.0);
    append_hull(sight.flipped, state.dimension, near, seen);
}

template <class Real>
void Visibility<Real>::operator()(std::vector<std::uint8_t>& surface) {
    surface.assign(state.size(), 0);
    if (state.size() == 0)
        return;
    copy_positions();
    const NeighborGrid grid(positions, rho, {}, threads);
    sights.resize(static_cast<std::size_t>(threads));
    visible.resize(static_cast<std::size_t>(threads));
    for (auto& seen : visible)
        seen.clear();
    place_viewpoints(grid);
    // One viewpoint at a time, since each takes long and there may be few.
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (const Place& viewpoint : viewpoints) {
        const auto worker = static_cast<std::size_t>(omp_get_thread_num());
        look(grid, viewpoint, sights[worker], visible[worker]);
    }
    for (const auto& seen : visible)
        for (const std::uint32_t particle : seen)
            surface[particle] = 1;
}

template <class Real>
Detector<Real> visibility_detector(const std::string& name, double rho_in_radii) {
    Detector<Real> detector;
    detector.name = name;
    detector.group = "visibility";
    detector.source = "Sandim et al. 2016";
    detector.prepare = [rho_in_radii](const FluidState<Real>& state, int threads) -> Detection {
        const double rho = rho_in_radii * static_cast<double>(state.support_radius);
        auto visibility = std::make_shared<Visibility<Real>>(
            Visibility<Real>{state, rho, threads, {}, {}, {}, {}});
        return [visibility](std::vector<std::uint8_t>& surface) { (*visibility)(surface); };
    };
    detector.is_slow = true;
    return detector;
}

} // namespace

template <class Real>
void add_visibility_detectors(int /*dimension*/, std::vector<Detector<Real>>& all) {
    all.push_back(visibility_detector<Real>("hidden-point removal, rho = h", 1));
    all.push_back(visibility_detector<Real>("hidden-point removal, rho = h / 2", 0.5));
}

template void add_visibility_detectors(int, std::vector<Detector<float>>&);
template void add_visibility_detectors(int, std::vector<Detector<double>>&);

} // namespace meniscus
