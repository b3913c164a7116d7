// The method of plugins/splishsplash/ on a droplet, against SurfaceTension called directly over
// lists of our own.
#include <SPlisHSPlasH/Simulation.h>
#include <SurfaceTension_Meniscus.h>
#include <Utilities/Logger.h>

#include <meniscus/runtime/surface/surface_tension.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace SPH {
namespace {

constexpr Real particle_radius = Real(0.025);
constexpr Real support_radius = 4 * particle_radius;
constexpr Real density = 1000;

/// A simulation with a fluid, and boundary particles where there are some.
class Splishsplash : public testing::Test {
protected:
    void SetUp() override {
        sim.radius = support_radius;
        sim.plane = false;
        sim.handling = BoundaryHandlingMethods::Akinci2012;
        sim.boundaries.clear();
        if (sim.getSurfaceTensionMethods().empty())
            sim.registerNonpressureForces();
    }

    /// Particles on a lattice within `edge` spacings of the origin, above z = 0 where there is to
    /// be a wall below.
    void fill(int edge, bool above_wall) {
        const Real spacing = 2 * particle_radius;
        const int depth = sim.plane ? 0 : edge;
        for (int z = -depth; z <= depth; ++z)
            for (int y = -edge; y <= edge; ++y)
                for (int x = -edge; x <= edge; ++x)
                    if (x * x + y * y + z * z <= edge * edge && (!above_wall || z >= 0))
                        fluid.x.push_back(spacing * Vector3r(Real(x), Real(y), Real(z)));
        const std::size_t count = fluid.x.size();
        fluid.a.assign(count, Vector3r(1, 2, 3));
        fluid.ids.resize(count);
        std::iota(fluid.ids.rbegin(), fluid.ids.rend(), 0U);
        fluid.volume = Real(0.8) * spacing * spacing * (sim.plane ? Real(1) : spacing);
        fluid.mass = fluid.volume * density;
        sim.neighbors = {neighbors(fluid.x)};
    }

    void add_wall(int edge) {
        const Real spacing = 2 * particle_radius;
        for (int y = -edge; y <= edge; ++y)
            for (int x = -edge; x <= edge; ++x) {
                wall.x.push_back(spacing * Vector3r(Real(x), Real(y), -1));
                wall.volumes.push_back(Real(1.5) * fluid.volume);
            }
        sim.boundaries = {&wall};
        sim.neighbors.push_back(neighbors(wall.x));
    }

    [[nodiscard]] std::vector<std::vector<unsigned int>>
    neighbors(const std::vector<Vector3r>& of) const {
        std::vector<std::vector<unsigned int>> lists(fluid.x.size());
        for (std::size_t i = 0; i < fluid.x.size(); ++i)
            for (std::size_t j = 0; j < of.size(); ++j)
                if ((&of != &fluid.x || j != i) && (of[j] - fluid.x[i]).norm() < support_radius)
                    lists[i].push_back(static_cast<unsigned int>(j));
        return lists;
    }

    /// The method as the program makes it, by its name.
    std::unique_ptr<SurfaceTension_Meniscus> make() {
        for (const auto& method : sim.getSurfaceTensionMethods())
            if (method.m_name == "Meniscus") {
                std::unique_ptr<NonPressureForceBase> made(method.m_creator(&fluid));
                made->init();
                return std::unique_ptr<SurfaceTension_Meniscus>(
                    dynamic_cast<SurfaceTension_Meniscus*>(made.release()));
            }
        return nullptr;
    }

    [[nodiscard]] Real field(const std::string& name, unsigned int i) const {
        for (const FieldDescription& one : fluid.fields)
            if (one.name == name)
                return *static_cast<Real*>(one.getFct(i));
        ADD_FAILURE() << "no field " << name;
        return 0;
    }

    Simulation& sim = *Simulation::getCurrent();
    FluidModel fluid;
    BoundaryModel_Akinci2012 wall;
};

/// Compressed rows.
struct Lists {
    std::vector<std::size_t> offsets = {0};
    std::vector<std::uint32_t> neighbors;

    explicit Lists(const std::vector<std::vector<unsigned int>>& rows) {
        for (const auto& row : rows) {
            neighbors.insert(neighbors.end(), row.begin(), row.end());
            offsets.push_back(neighbors.size());
        }
    }
};

template <int Dimension>
meniscus::CsrNeighborhood<Real, Dimension, 3> csr(const FluidModel& fluid, const Lists& lists) {
    return {fluid.x[0].data(), nullptr, lists.offsets.data(), lists.neighbors.data()};
}

meniscus::SurfaceTensionOptions options_of(int dimension) {
    meniscus::SurfaceTensionOptions options;
    // Four particle radii over the edge of a cube (square) of 0.8 of a diameter's.
    options.spacing_ratio = 2 / std::pow(0.8, 1.0 / dimension);
    return options;
}

constexpr double tolerance = sizeof(Real) == 4 ? 1e-5 : 1e-12;

/// Accelerations that the method adds to those that are there, and the fields, are the direct ones.
template <int Dimension, class Fields>
void expect_same(const FluidModel& fluid, const meniscus::SurfaceTension<Real, Dimension>& direct,
                 const Fields& field) {
    const auto& surface = direct.surface();
    Real most = 0;
    for (std::size_t slot = 0; slot < surface.size(); ++slot)
        for (int axis = 0; axis < Dimension; ++axis)
            most = std::max(most, std::fabs(surface.force[slot][axis]) / fluid.mass);
    ASSERT_GT(most, 0);
    for (unsigned int i = 0; i < fluid.x.size(); ++i) {
        const int slot = surface.slot_of[i];
        for (int axis = 0; axis < 3; ++axis) {
            const Real force = slot >= 0 && axis < Dimension ? surface.force[slot][axis] : 0;
            EXPECT_NEAR(fluid.a[i][axis], Real(axis + 1) + force / fluid.mass, tolerance * most);
        }
        const bool is_surface =
            slot >= 0 && surface.surface_class[slot] == meniscus::SurfaceClass::surface;
        EXPECT_EQ(field("surface class", i), slot < 0 ? 0 : is_surface ? 2 : 1);
        EXPECT_NEAR(field("uncovered fraction", i), slot < 0 ? 0 : surface.uncovered_fraction[slot],
                    tolerance);
        EXPECT_NEAR(field("mean curvature", i), slot < 0 ? 0 : surface.curvature[slot],
                    tolerance / support_radius);
        EXPECT_NEAR(field("surface normal", i), slot < 0 ? 0 : surface.normal[slot][0], tolerance);
    }
}

TEST_F(Splishsplash, ADropletAsDirectly) {
    fill(5, false);
    const auto method = make();
    ASSERT_TRUE(method);
    EXPECT_EQ(method->getMethodName(), "Meniscus");
    method->setValue<Real>(SurfaceTension_Meniscus::SURFACE_TENSION_COEFFICIENT, Real(0.5));
    method->step();

    meniscus::SurfaceTensionOptions options = options_of(3);
    options.surface_tension = double(Real(0.5));
    meniscus::SurfaceTension<Real, 3> direct(options);
    const Lists lists(sim.neighbors[0]);
    const auto view = csr<3>(fluid, lists);
    const meniscus::UniformRadius<Real> radius{support_radius};
    direct.step(view, meniscus::NoBoundary{}, fluid.x.size(), radius, fluid.ids.data(),
                meniscus::SerialLoop{});
    direct.balance_momentum<3>(view, meniscus::NoBoundary{}, radius, view.positions,
                               meniscus::SerialLoop{});
    expect_same(fluid, direct, [&](const char* name, unsigned int i) { return field(name, i); });
    EXPECT_EQ(Utilities::log().str(), "");
}

TEST_F(Splishsplash, InThePlane) {
    sim.plane = true;
    fill(8, false);
    const auto method = make();
    method->setValue<bool>(SurfaceTension_Meniscus::BALANCE_MOMENTUM, false);
    method->step();
    meniscus::SurfaceTension<Real, 2> direct(options_of(2));
    const Lists lists(sim.neighbors[0]);
    direct.step(csr<2>(fluid, lists), meniscus::NoBoundary{}, fluid.x.size(),
                meniscus::UniformRadius<Real>{support_radius}, fluid.ids.data(),
                meniscus::SerialLoop{});
    expect_same(fluid, direct, [&](const char* name, unsigned int i) { return field(name, i); });
}

/// The wall's particles around those of the fluid, from our lists.
struct Wall {
    const FluidModel& fluid;
    const BoundaryModel_Akinci2012& wall;
    const std::vector<std::vector<unsigned int>>& lists;

    template <class Visit>
    void operator()(std::size_t i, const Visit& visit) const {
        for (const unsigned int b : lists[i])
            visit(b, Vector3r(wall.x[b] - fluid.x[i]), wall.volumes[b] / fluid.volume);
    }
};

TEST_F(Splishsplash, AWallWithAContactAngle) {
    fill(5, true);
    add_wall(8);
    const auto method = make();
    method->setValue<Real>(SurfaceTension_Meniscus::CONTACT_ANGLE, Real(60));
    method->step();
    meniscus::SurfaceTensionOptions options = options_of(3);
    options.contact_angle = 60;
    meniscus::SurfaceTension<Real, 3> direct(options);
    const Lists lists(sim.neighbors[0]);
    const auto view = csr<3>(fluid, lists);
    const meniscus::BoundaryView<Wall> boundary{{fluid, wall, sim.neighbors[1]}};
    const meniscus::UniformRadius<Real> radius{support_radius};
    direct.step(view, boundary, fluid.x.size(), radius, fluid.ids.data(), meniscus::SerialLoop{});
    direct.balance_momentum<3>(view, boundary, radius, view.positions, meniscus::SerialLoop{});
    expect_same(fluid, direct, [&](const char* name, unsigned int i) { return field(name, i); });
    for (unsigned int i = 0; i < fluid.x.size(); ++i)
        if (fluid.x[i].norm() < particle_radius) {
            EXPECT_EQ(field("surface class", i), 0) << "at the wall is not at the surface";
        }
}

TEST_F(Splishsplash, SaysWhereWallsCannotBeSeen) {
    fill(3, true);
    add_wall(5);
    sim.handling = BoundaryHandlingMethods::Bender2019;
    const auto method = make();
    method->step();
    method->step();
    const std::string text = Utilities::log().str();
    EXPECT_NE(text.find("Akinci"), std::string::npos) << text;
    EXPECT_EQ(text.find("Akinci"), text.rfind("Akinci")) << "said once";
    Utilities::log().str("");
}

TEST_F(Splishsplash, ParametersKeepToTheirRanges) {
    fill(2, false);
    const auto method = make();
    ASSERT_EQ(method->numParameters(), 4U);
    EXPECT_EQ(method->getParameter(0)->name, "surfaceTension");
    EXPECT_EQ(method->getParameter(0)->group, "Fluid Model|Surface tension");
    const auto set_and_get = [&](int parameter, auto value) {
        method->setValue<decltype(value)>(parameter, value);
        return method->getValue<decltype(value)>(parameter);
    };
    EXPECT_EQ(set_and_get(SurfaceTension_Meniscus::SURFACE_TENSION_COEFFICIENT, Real(-1)), 0);
    EXPECT_EQ(set_and_get(SurfaceTension_Meniscus::CONTACT_ANGLE, Real(0)), 10);
    EXPECT_EQ(set_and_get(SurfaceTension_Meniscus::CONTACT_ANGLE, Real(180)), 170);
    EXPECT_EQ(set_and_get(SurfaceTension_Meniscus::SAMPLES, 1U), 4U);
    EXPECT_EQ(set_and_get(SurfaceTension_Meniscus::SAMPLES, 1U << 20), 16384U);
    method->step();
}

TEST_F(Splishsplash, FieldsFollowSortsAndGoWithTheMethod) {
    fill(4, false);
    auto method = make();
    method->step();
    const unsigned int count = fluid.numParticles();
    std::vector<Real> before;
    for (unsigned int i = 0; i < count; ++i)
        before.push_back(field("uncovered fraction", i));
    std::vector<unsigned int> order(count);
    std::iota(order.rbegin(), order.rend(), 0U);
    sim.search.points.order = order;
    method->performNeighborhoodSearchSort();
    for (unsigned int i = 0; i < count; ++i)
        EXPECT_EQ(field("uncovered fraction", i), before[order[i]]);
    method->reset();
    EXPECT_EQ(field("uncovered fraction", 0), 0);
    method.reset();
    EXPECT_TRUE(fluid.fields.empty());
}

TEST_F(Splishsplash, NoParticlesNoWork) {
    const auto method = make();
    method->step();
    method->performNeighborhoodSearchSort();
}

} // namespace
} // namespace SPH
