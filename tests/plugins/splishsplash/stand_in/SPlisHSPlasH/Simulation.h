// Stand-in: one fluid in point set 0, any number of boundaries after it.
#pragma once

#include "BoundaryModel_Akinci2012.h"
#include "FluidModel.h"
#include "NonPressureForceBase.h"

#include <functional>
#include <string>
#include <vector>

#define forall_fluid_neighbors_in_same_phase(code)                                                 \
    for (unsigned int j = 0; j < sim->numberOfNeighbors(fluidModelIndex, fluidModelIndex, i);      \
         j++) {                                                                                    \
        const unsigned int neighborIndex =                                                         \
            sim->getNeighbor(fluidModelIndex, fluidModelIndex, i, j);                              \
        const Vector3r& xj = model->getPosition(neighborIndex);                                    \
        code                                                                                       \
    }

#define forall_boundary_neighbors(code)                                                            \
    for (unsigned int pid = nFluids; pid < sim->numberOfPointSets(); pid++) {                      \
        BoundaryModel_Akinci2012* bm_neighbor =                                                    \
            static_cast<BoundaryModel_Akinci2012*>(sim->getBoundaryModelFromPointSet(pid));        \
        for (unsigned int j = 0; j < sim->numberOfNeighbors(fluidModelIndex, pid, i); j++) {       \
            const unsigned int neighborIndex = sim->getNeighbor(fluidModelIndex, pid, i, j);       \
            const Vector3r& xj = bm_neighbor->getPosition(neighborIndex);                          \
            code                                                                                   \
        }                                                                                          \
    }

namespace SPH {

enum class BoundaryHandlingMethods { Akinci2012 = 0, Koschier2017, Bender2019, Gissler2019 };

/// Neighbors of the fluid's particles in one point set, and the order that a sort has made.
class PointSet {
public:
    template <class T>
    void sort_field(T* values) const {
        std::vector<T> before(values, values + order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            values[i] = before[order[i]];
    }
    std::vector<unsigned int> order;
};

class NeighborhoodSearch {
public:
    PointSet& point_set(const unsigned int) { return points; }
    PointSet points;
};

class Simulation : public GenParam::ParameterObject {
public:
    struct NonPressureForceMethod {
        std::string m_name;
        std::function<NonPressureForceBase*(FluidModel*)> m_creator;
        int m_id;
    };

    static Simulation* getCurrent() {
        static Simulation current;
        return &current;
    }
    void addSurfaceTensionMethod(const std::string& name,
                                 const std::function<NonPressureForceBase*(FluidModel*)>& creator) {
        methods.push_back({name, creator, -1});
    }
    std::vector<NonPressureForceMethod>& getSurfaceTensionMethods() { return methods; }
    void registerNonpressureForces();

    bool is2DSimulation() { return plane; }
    Real getSupportRadius() const { return radius; }
    BoundaryHandlingMethods getBoundaryHandlingMethod() const { return handling; }
    NeighborhoodSearch* getNeighborhoodSearch() { return &search; }
    const unsigned int numberOfFluidModels() const { return 1; }
    const unsigned int numberOfBoundaryModels() const {
        return static_cast<unsigned int>(boundaries.size());
    }
    BoundaryModel* getBoundaryModelFromPointSet(const unsigned int set) {
        return boundaries[set - 1];
    }
    unsigned int numberOfPointSets() const { return 1 + numberOfBoundaryModels(); }
    unsigned int numberOfNeighbors(const unsigned int, const unsigned int set,
                                   const unsigned int i) const {
        return static_cast<unsigned int>(neighbors[set][i].size());
    }
    unsigned int getNeighbor(const unsigned int, const unsigned int set, const unsigned int i,
                             const unsigned int k) const {
        return neighbors[set][i][k];
    }

    bool plane = false;
    Real radius = 0;
    BoundaryHandlingMethods handling = BoundaryHandlingMethods::Akinci2012;
    std::vector<BoundaryModel*> boundaries;
    /// Of each point set, around each particle of the fluid.
    std::vector<std::vector<std::vector<unsigned int>>> neighbors;
    NeighborhoodSearch search;

private:
    std::vector<NonPressureForceMethod> methods;
};

} // namespace SPH
