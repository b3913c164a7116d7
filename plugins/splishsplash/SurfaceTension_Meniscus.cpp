#include "SurfaceTension_Meniscus.h"

#include <SPlisHSPlasH/BoundaryModel_Akinci2012.h>
#include <SPlisHSPlasH/Simulation.h>
#include <Utilities/Logger.h>

#include <meniscus/runtime/surface/surface_tension.hpp>

#include <cmath>

using namespace SPH;
using namespace GenParam;

std::string SurfaceTension_Meniscus::METHOD_NAME = "Meniscus";
int SurfaceTension_Meniscus::SURFACE_TENSION_COEFFICIENT = -1;
int SurfaceTension_Meniscus::CONTACT_ANGLE = -1;
int SurfaceTension_Meniscus::SAMPLES = -1;
int SurfaceTension_Meniscus::BALANCE_MOMENTUM = -1;

namespace {
// Members have the names that the program's loop macros ask for.

/// The program's own lists of neighbors of the same phase, as they are: a view (neighborhood.hpp).
struct FluidNeighbors {
    Simulation* sim;
    FluidModel* model;
    unsigned int fluidModelIndex;

    template <class Visit>
    void operator()(std::size_t particle, const Visit& visit) const {
        const unsigned int i = static_cast<unsigned int>(particle);
        const Vector3r& xi = model->getPosition(i);
        forall_fluid_neighbors_in_same_phase(
            visit(neighborIndex, Vector3r(xj - xi), model->getMass(neighborIndex));)
    }
};

/// The boundary particles of all rigid bodies around a fluid particle, each with its volume over
/// that of a fluid particle (boundary.hpp).
struct BoundaryNeighbors {
    Simulation* sim;
    FluidModel* model;
    unsigned int fluidModelIndex;
    unsigned int nFluids;
    Real fluidVolume;

    template <class Visit>
    void operator()(std::size_t particle, const Visit& visit) const {
        const unsigned int i = static_cast<unsigned int>(particle);
        const Vector3r& xi = model->getPosition(i);
        forall_boundary_neighbors(visit(neighborIndex, Vector3r(xj - xi),
                                        bm_neighbor->getVolume(neighborIndex) / fluidVolume);)
    }
};

#if defined(_OPENMP)
typedef meniscus::OpenMpLoop Loop;
#else
typedef meniscus::SerialLoop Loop;
#endif

bool isSame(const meniscus::SurfaceTensionOptions& a, const meniscus::SurfaceTensionOptions& b) {
    return a.surface_tension == b.surface_tension && a.contact_angle == b.contact_angle &&
           a.samples == b.samples && a.spacing_ratio == b.spacing_ratio;
}

/// A fluid model's field has the method's name in newer versions, and none in older ones.
template <class Description, class Get>
auto makeField(const char* name, FieldType type, const Get& get, int)
    -> decltype(Description{std::string(name), std::string(), type, get}) {
    return Description{std::string(name), SurfaceTension_Meniscus::METHOD_NAME, type, get};
}
template <class Description, class Get>
Description makeField(const char* name, FieldType type, const Get& get, long) {
    return Description{std::string(name), type, get};
}
template <class Get>
void addField(FluidModel* model, const char* name, FieldType type, const Get& get) {
    model->addField(makeField<FieldDescription>(name, type, get, 0));
}
} // namespace

struct SurfaceTension_Meniscus::Tension {
    meniscus::SurfaceTensionOptions options;
    std::unique_ptr<meniscus::SurfaceTension<Real, 2>> inPlane;
    std::unique_ptr<meniscus::SurfaceTension<Real, 3>> inSpace;
    bool hasWarned = false;

    /// The method of that dimension with the options, which may have changed since the last step.
    template <int Dimension>
    meniscus::SurfaceTension<Real, Dimension>&
    method(const meniscus::SurfaceTensionOptions& wanted) {
        std::unique_ptr<meniscus::SurfaceTension<Real, Dimension>>* kept;
        if constexpr (Dimension == 2)
            kept = &inPlane;
        else
            kept = &inSpace;
        if (!*kept || !isSame(options, wanted))
            kept->reset(new meniscus::SurfaceTension<Real, Dimension>(wanted));
        options = wanted;
        return **kept;
    }

    template <int Dimension>
    void step(SurfaceTension_Meniscus& self, const meniscus::SurfaceTensionOptions& wanted) {
        Simulation* sim = Simulation::getCurrent();
        FluidModel* model = self.m_model;
        auto& tension = method<Dimension>(wanted);
        const FluidNeighbors fluid{sim, model, model->getPointSetIndex()};
        const auto find = [&](const auto& boundary) {
            const meniscus::UniformRadius<Real> radius{sim->getSupportRadius()};
            const std::size_t count = model->numActiveParticles();
            const Loop loop;
            tension.step(fluid, boundary, count, radius, &model->getParticleId(0), loop);
            if (self.m_balanceMomentum)
                tension.template balance_momentum<3>(fluid, boundary, radius,
                                                     &model->getPosition(0)[0], loop);
        };
        const auto handling = sim->getBoundaryHandlingMethod();
        const bool isSampled = handling != BoundaryHandlingMethods::Koschier2017 &&
                               handling != BoundaryHandlingMethods::Bender2019;
        if (sim->numberOfBoundaryModels() == 0 || !isSampled)
            find(meniscus::NoBoundary{});
        else
            find(meniscus::BoundaryView<BoundaryNeighbors>{{sim, model, model->getPointSetIndex(),
                                                            sim->numberOfFluidModels(),
                                                            model->getVolume(0)}});
        if (!isSampled && !hasWarned) {
            LOG_WARN << "surface tension method " << METHOD_NAME
                     << ": fluid at walls counts as free "
                        "surface with this boundary handling method; choose Akinci et al. 2012";
            hasWarned = true;
        }
        write<Dimension>(self, tension.surface());
    }

    /// Adds the accelerations and sets the fields.
    template <int Dimension, class Surface>
    static void write(SurfaceTension_Meniscus& self, const Surface& surface) {
        FluidModel* model = self.m_model;
        self.clear();
        for (std::size_t slot = 0; slot < surface.size(); ++slot) {
            const unsigned int i = surface.particle[slot];
            const Real mass = model->getMass(i);
            Vector3r& acceleration = model->getAcceleration(i);
            for (int axis = 0; axis < Dimension; ++axis) {
                if (mass > 0)
                    acceleration[axis] += surface.force[slot][axis] / mass;
                self.m_normals[i][axis] = surface.normal[slot][axis];
            }
            self.m_class[i] =
                surface.surface_class[slot] == meniscus::SurfaceClass::surface ? Real(2) : Real(1);
            self.m_uncovered[i] = surface.uncovered_fraction[slot];
            self.m_curvature[i] = surface.curvature[slot];
        }
    }
};

SurfaceTension_Meniscus::SurfaceTension_Meniscus(FluidModel* model)
    : SurfaceTensionMethodBase(model), m_tension(new Tension) {
    const meniscus::SurfaceTensionOptions defaults;
    m_sigma = static_cast<Real>(defaults.surface_tension);
    m_contactAngle = static_cast<Real>(defaults.contact_angle);
    m_samples = static_cast<unsigned int>(defaults.samples);
    m_balanceMomentum = true;
    clear();

    addField(model, "surface class", FieldType::Scalar,
             [this](const unsigned int i) -> Real* { return &m_class[i]; });
    addField(model, "uncovered fraction", FieldType::Scalar,
             [this](const unsigned int i) -> Real* { return &m_uncovered[i]; });
    addField(model, "mean curvature", FieldType::Scalar,
             [this](const unsigned int i) -> Real* { return &m_curvature[i]; });
    addField(model, "surface normal", FieldType::Vector3,
             [this](const unsigned int i) -> Real* { return &m_normals[i][0]; });
}

SurfaceTension_Meniscus::~SurfaceTension_Meniscus(void) {
    for (const char* name :
         {"surface class", "uncovered fraction", "mean curvature", "surface normal"})
        m_model->removeFieldByName(name);
}

void SurfaceTension_Meniscus::clear() {
    const std::size_t count = m_model->numParticles();
    m_class.assign(count, Real(0));
    m_uncovered.assign(count, Real(0));
    m_curvature.assign(count, Real(0));
    m_normals.assign(count, Vector3r::Zero());
}

void SurfaceTension_Meniscus::initParameters() {
    // Not the parameters of a base for surface tension: they have other units.
    NonPressureForceBase::initParameters();
    const std::string group = "Fluid Model|Surface tension";

    SURFACE_TENSION_COEFFICIENT =
        createNumericParameter("surfaceTension", "Surface tension (N/m)", &m_sigma);
    setGroup(SURFACE_TENSION_COEFFICIENT, group);
    setDescription(SURFACE_TENSION_COEFFICIENT, "Sigma in N/m, 0.072 for water in air.");
    static_cast<RealParameter*>(getParameter(SURFACE_TENSION_COEFFICIENT))->setMinValue(0);

    CONTACT_ANGLE =
        createNumericParameter("contactAngle", "Contact angle (degrees)", &m_contactAngle);
    setGroup(CONTACT_ANGLE, group);
    setDescription(CONTACT_ANGLE, "Between boundary and surface, measured in the fluid.");
    RealParameter* angle = static_cast<RealParameter*>(getParameter(CONTACT_ANGLE));
    angle->setMinValue(static_cast<Real>(meniscus::option_ranges::contact_angle.min));
    angle->setMaxValue(static_cast<Real>(meniscus::option_ranges::contact_angle.max));

    SAMPLES = createNumericParameter("surfaceSamples", "Samples", &m_samples);
    setGroup(SAMPLES, group);
    setDescription(SAMPLES,
                   "Samples of a candidate's sphere; no number of them loses surface particles.");
    auto* samples = static_cast<NumericParameter<unsigned int>*>(getParameter(SAMPLES));
    samples->setMinValue(static_cast<unsigned int>(meniscus::option_ranges::samples.min));
    samples->setMaxValue(static_cast<unsigned int>(meniscus::option_ranges::samples.max));

    BALANCE_MOMENTUM =
        createBoolParameter("balanceMomentum", "Balance momentum", &m_balanceMomentum);
    setGroup(BALANCE_MOMENTUM, group);
    setDescription(BALANCE_MOMENTUM, "No net force and torque on fluid that touches no boundary.");
}

void SurfaceTension_Meniscus::step() {
    if (m_model->numActiveParticles() == 0)
        return;
    Simulation* sim = Simulation::getCurrent();
    const bool isInPlane = sim->is2DSimulation();
    // A particle at rest has 0.8 of the cube, in the plane of the square, of its diameter.
    const double volume = static_cast<double>(m_model->getVolume(0));
    const double spacing = isInPlane ? std::sqrt(volume) : std::cbrt(volume);
    meniscus::SurfaceTensionOptions options;
    options.surface_tension = static_cast<double>(m_sigma);
    options.contact_angle = static_cast<double>(m_contactAngle);
    options.samples = m_samples;
    options.spacing_ratio = static_cast<double>(sim->getSupportRadius()) / spacing;
    if (isInPlane)
        m_tension->step<2>(*this, options);
    else
        m_tension->step<3>(*this, options);
}

void SurfaceTension_Meniscus::reset() {
    clear();
}

void SurfaceTension_Meniscus::performNeighborhoodSearchSort() {
    if (m_model->numActiveParticles() == 0)
        return;
    auto const& points =
        Simulation::getCurrent()->getNeighborhoodSearch()->point_set(m_model->getPointSetIndex());
    points.sort_field(&m_class[0]);
    points.sort_field(&m_uncovered[0]);
    points.sort_field(&m_curvature[0]);
    points.sort_field(&m_normals[0]);
}
