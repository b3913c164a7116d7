// A scene: all that `meniscus simulate` needs to know of a simulation, read from a JSON file
// (docs/scenes.md lists the keys). One file holds a small scene and, under "variants", what other
// sizes of it change. Lengths are in m, times in s, densities in kg/m^3, velocities in m/s,
// accelerations in m/s^2; in two dimensions z stays 0 and masses are per depth, kg/m.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/runtime/surface/surface_options.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace meniscus {

using Place = std::array<double, 3>;

/// Particles at first + spacing (i, j, k), with i, j, k below `count`.
struct LatticeShape {
    Place first{};
    std::array<int, 3> count{1, 1, 1};
};

/// A box, as fluid: the particles in the middle of the cells of size `spacing` that fit in, counted
/// from `low`; as a wall: its six (in 2D four) sides, but those that are open.
struct BoxShape {
    Place low{};
    Place high{};
    std::vector<std::string> open; ///< walls only: sides left out, of "-x", "+x", "-y", ...
};

/// A ball (in 2D a disk) or an ellipsoid, as fluid: the places of a lattice with a particle at the
/// center that lie inside; as a wall: its surface.
struct SphereShape {
    Place center{};
    Place half_axes{};
};

/// A closed or open surface of triangles from a Wavefront OBJ file, scaled, then moved. Walls only.
struct MeshShape {
    std::filesystem::path file; ///< in the JSON relative to the scene's file
    double scale = 1;
    Place translation{};
};

/// The particles of a snapshot file (positions and, where stored, velocities), moved. Fluid only.
struct SnapshotShape {
    std::filesystem::path file; ///< in the JSON relative to the scene's file
    Place translation{};
};

struct FluidBody {
    std::variant<LatticeShape, BoxShape, SphereShape, SnapshotShape> shape;
    Place velocity{};
};

using WallShape = std::variant<BoxShape, SphereShape, MeshShape>;

struct Wall {
    WallShape shape;
    /// In degrees; without it that of the surface tension (SurfaceTensionOptions).
    std::optional<double> contact_angle{};

    template <class Shape>
    Wall(Shape its_shape) : shape(std::move(its_shape)) {} // NOLINT: a shape is a wall
};

/// What becomes of particles that leave the domain.
enum class Leaving {
    few,    ///< they are removed, up to a hundredth of all; more end the run
    remove, ///< they are removed
    stop,   ///< the first one ends the run
};

enum class KernelKind {
    cubic_spline,
    mueller, ///< poly6 for densities and averages, spiky for gradients (Mueller et al. 2003)
};

/// What pressure solvers read (methods.hpp); each leaves some of it without a meaning.
struct PressureOptions {
    std::string solver = "dfsph";  ///< its name, of pressure_solvers()
    double density_error = 0.0005; ///< largest mean compression, relative to the rest density
    /// DFSPH: largest mean compression that the velocities would cause in one step, relative to the
    /// rest density; 0 leaves the divergence-free solve out.
    double divergence_error = 0.001;
    int min_iterations = 2;
    int max_iterations = 100;
    bool clip_negative = true; ///< no pressure pulls
    double sound_speed = 0;    ///< WCSPH, m/s
    double relaxation = 0.5;   ///< IISPH and DFSPH: omega of the Jacobi iterations
    bool accelerate = true;    ///< IISPH and DFSPH: iterations keep momentum; false: as published
};

/// Of the air, in (D - 1) sigma / h: what drops and necks need, and what menisci and fluid that
/// rises in a gap do. It is not more than that, since it makes surfaces stiffer: drops swing faster
/// with it (docs/studies.md).
constexpr double default_ambient_pressure(bool has_walls) {
    return has_walls ? 0.5 : 0.1;
}

/// The runtime's own choices, in the air.
inline SurfaceTensionOptions with_ambient_pressure(double pressure) {
    SurfaceTensionOptions options;
    options.ambient_pressure = pressure;
    return options;
}

struct TensionOptions {
    std::string model = "none"; ///< its name, of tension_models(); "none" leaves the forces out
    /// Sigma in N/m where the model has it (TensionModelRow::has_sigma), else its own coefficient.
    double coefficient = 0;
    bool restrict_to_surface = false; ///< rivals: forces on surface particles only
    double adhesion = 0;              ///< akinci_2013: beta of its attraction by walls; 0: none
    // The rest is for `meniscus`.
    bool balance_momentum = true; ///< takes net force and torque out of bodies that touch no wall
    /// Of contact lines with walls, over sqrt(rho sigma spacing), N s/m^2 (in 2D N s/m); 0: none. A
    /// line that slips freely rattles over the single particles of a wall.
    double contact_friction = 2;
    /// Of waves as short as the spacing (tension/ripples.hpp), 0 to 0.5; 0: none.
    double ripple_damping = 0.3;
    /// Of the classifier that `surface` is to have in place of the one that ships; whoever runs the
    /// scene reads it (app/scene_model.hpp). Empty: none.
    std::filesystem::path model_file;
    /// C_SD in 1/s: a particle has so many samples in a second of simulated time, N = t_s C_SD of
    /// the step before (2020 paper, section 3.4.3); 0: as many as `surface` says.
    double sampling_density = 0;
    int min_samples = 16; ///< the least N that the sampling density gives
    /// Of the runtime, which has surface_tension from the coefficient, spacing_ratio from the scene
    /// and, where k and d are NaN, the classifier that ships for the dimension. Pressures are
    /// clipped, so that there is air.
    SurfaceTensionOptions surface = with_ambient_pressure(default_ambient_pressure(false));
};

struct ViscosityOptions {
    double kinematic = 0;            ///< nu, m^2/s
    bool density_correction = false; ///< times K_ij = 2 rho_0 / (rho_i + rho_j) (Huber 2015, eq. 9)
    double xsph = 0;                 ///< share of the neighbors' velocity, 0 to 1
};

struct TimeStepOptions {
    std::optional<double> fixed; ///< s; without it the CFL condition sets the step
    double courant_factor = 1;   ///< of 0.4 spacing / largest speed
    double min = 1e-6;           ///< s
    double max = 5e-3;           ///< s; in a file that has none default_max_time_step()
};

/// Columns of a run's log that cost time, beside those that are always there (run/run_log.hpp).
struct LogOptions {
    bool forces = false; ///< sizes of the forces by surface tension and by pressure, in each step
    bool bodies = false; ///< connected bodies of fluid, and the shape of the largest
};

/// The longest step, s, of a scene that names none: 5 ms, and less where particles lie closer than
/// 1 cm, since a solver that starts far from rest needs steps of its own scale.
constexpr double default_max_time_step(double particle_spacing) {
    return particle_spacing < 0.01 ? 0.5 * particle_spacing : 5e-3;
}

struct Scene {
    std::string name;
    std::string variant; ///< empty: the small one
    int dimension = 3;
    Precision precision = Precision::float32; ///< that the step calculates in
    double particle_spacing = 0;
    double support_radius = 0; ///< h, at which kernels end
    double rest_density = 1000;
    double volume_share = 1; ///< mass of a particle over rest_density spacing^dimension
    double duration = 0;
    double frame_interval = 0;
    std::vector<FluidBody> fluid;
    std::vector<Wall> walls;
    Place gravity{};
    /// Where particles may be. Without it: the box around fluid and walls, larger by its longest
    /// side in all directions.
    std::optional<std::array<Place, 2>> domain;
    Leaving leaving = Leaving::few;
    KernelKind kernel = KernelKind::cubic_spline;
    PressureOptions pressure;
    ViscosityOptions viscosity;
    TensionOptions surface_tension;
    TimeStepOptions time_step;
    LogOptions log;
};

/// Of a particle at rest, m^3 (in 2D m^2).
double particle_volume(const Scene& scene);

/// Support radius over the spacing of particles at rest, the root of their volume.
double spacing_ratio(const Scene& scene);

/// Reads a scene, with the variant of that name merged in ("" for none), and then the changes, each
/// a "key=value" such as "pressure.solver=iisph": the value is JSON or, where that cannot be, a
/// text; null takes the key out. Throws InputError, naming file and key, where a key is unknown
/// (with the nearest valid spelling), missing, of the wrong type or out of range, where two
/// contradict each other, where the file has no such variant (with those that it has), and where a
/// change has no key.
Scene read_scene(const std::filesystem::path& file, const std::string& variant,
                 const std::vector<std::string>& changes = {});

/// The variants that a scene's file has, besides the small one.
std::vector<std::string> scene_variants(const std::filesystem::path& file);

/// The scene as canonical JSON of all its values: the same for two scenes that are the same. For
/// the provenance of frames, and to tell whether a checkpoint belongs to a scene.
std::string scene_text(const Scene& scene);

/// The first state of a scene.
struct SceneParticles {
    Positions positions;
    std::vector<Place> velocities; ///< one a particle
    Positions walls;               ///< wall particles
    /// One a wall particle, degrees; empty where no wall has one of its own.
    std::vector<float> wall_contact_angles{};
    double mass = 0; ///< of each fluid particle, kg
};

/// Fills the scene's shapes. Throws InputError where a file cannot be read, where a snapshot's
/// particles differ in mass or phase or lie so far out that its numbers do not hold their spacing,
/// where there is no fluid at all, where bodies overlap or fluid lies in a wall (naming particle
/// and both), or where there would be more than 5e8 particles; FailureError where memory is short.
SceneParticles fill_scene(const Scene& scene);

/// Throws InputError, naming the particle by `what` and `number`, for a place so far from the
/// origin that its coordinates (m) tell a millionth of a spacing no more: slow particles would
/// stand still.
void check_resolution(const Place& place, const Scene& scene, const char* what, std::size_t number);

/// The box where particles may be: the scene's own, or the one around its first state.
std::array<Place, 2> scene_domain(const Scene& scene, const SceneParticles& particles);

} // namespace meniscus
