/* Surface tension in an SPH step for solvers in C, and in other languages by the way that they have
 * of calling C. What the C++ headers (meniscus/runtime/surface/surface_tension.hpp) do in one call
 * a step, behind an opaque handle:
 *
 *     meniscus_options options;
 *     meniscus_options_init(&options, sizeof options);
 *     options.surface_tension = 0.072;
 *     meniscus_surface* surface;
 *     meniscus_create(&surface, &options, 3, MENISCUS_DOUBLE);
 *     ... each step:
 *     meniscus_step(surface, &particles);
 *     meniscus_add_accelerations(surface, masses, 0, accelerations, 3);
 *     ... in the end:
 *     meniscus_destroy(surface);
 *
 * All functions that return int return a meniscus_status; what is wrong stands in
 * meniscus_last_error(). A handle serves one caller at a time, different handles any number; it
 * spreads its work over threads of OpenMP: where they share cores with others, set
 * OMP_WAIT_POLICY=passive before the process starts, since libgomp's threads spin while they wait.
 * meniscus_create() fails where they cannot be started; where that comes later, libgomp ends the
 * process. In a child that was forked after a step had used them a handle works on the calling
 * thread alone; hosts whose own OpenMP threads ran before they forked set `threads` to 1 in the
 * child. Hosts may trap floating-point exceptions: what is calculated here raises none in them, and
 * leaves traps and flags as they were. The library picks the widest vector instructions that the
 * machine has (baseline, AVX2 or AVX-512), which changes no bit of a result, and neither does the
 * number of threads. Units are SI: lengths in m, masses in kg, forces in N (in two dimensions N per
 * m of depth). Indices count from 0. */
#ifndef MENISCUS_H
#define MENISCUS_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define MENISCUS_API __attribute__((visibility("default")))
#else
#define MENISCUS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What functions return. */
enum meniscus_status {
    MENISCUS_OK = 0,
    MENISCUS_BAD_ARGUMENT = 1,  /* nothing was changed */
    MENISCUS_OUT_OF_MEMORY = 2, /* the handle can only be destroyed now */
    MENISCUS_FAILURE = 3        /* anything else that went wrong on this machine; likewise */
};

/* The number type of all arrays of reals that a handle takes and gives. */
enum meniscus_precision { MENISCUS_FLOAT = 0, MENISCUS_DOUBLE = 1 };

/* How much of a candidate's sphere is uncovered: from samples, or in closed form (slower). */
enum meniscus_coverage { MENISCUS_SAMPLED = 0, MENISCUS_EXACT = 1 };

/* What becomes of a candidate that no sample finds uncovered: the exact test decides, so that no
 * surface particle is lost; or it counts as covered, as in the 2020 paper. */
enum meniscus_verification { MENISCUS_VERIFY = 0, MENISCUS_DROP = 1 };

/* Curvature from the uncovered fraction alone (2020 paper, eqs. 14 and 17), or from how normals
 * turn along the surface, by a calibrated map. */
enum meniscus_curvature { MENISCUS_CLOSED_CURVATURE = 0, MENISCUS_MAPPED_CURVATURE = 1 };

/* The 2020 paper's force, whose sigma is a parameter to be tuned, or the calibrated one, whose
 * sigma in N/m means what it says. */
enum meniscus_force { MENISCUS_PAPER_FORCE = 0, MENISCUS_CALIBRATED_FORCE = 1 };

/* What becomes of a particle. */
enum meniscus_class {
    MENISCUS_INTERIOR = 0, /* by the line */
    MENISCUS_COVERED = 1,  /* let through by the line, but covered */
    MENISCUS_AT_SURFACE = 2
};

/* A second line for the candidates of the first, in any two features, by the names that an exported
 * header has: they stay where y <= k x + d, or >= where surface lies above. */
typedef struct meniscus_second_line {
    const char* features[2]; /* x and y */
    double k, d;             /* -1e6 to 1e6 */
    int surface_above;       /* not 0: >= */
} meniscus_second_line;

/* A map of curvature, as `struct CurvatureCoefficients` of an exported header has it. */
typedef struct meniscus_curvature_map {
    double coefficients[4];
    double min, max; /* range of training */
    int averaged;    /* not 0: over the surface particles around */
} meniscus_curvature_map;

/* What a scene needs. Set by meniscus_options_init or meniscus_options_paper, then changed. Names,
 * ranges and defaults are those of the C++ headers (meniscus/runtime/surface/option_table.hpp), of
 * `meniscus classify` and of scenes. */
typedef struct meniscus_options {
    size_t size;             /* of this struct, which tells versions apart; set by the two */
    double k, d;             /* line of the classifier: candidates have y <= k x + d; -1e6 to 1e6;
                                both NaN, as the two set them: the classifier that ships for the
                                dimension, with its second line and boundary weight */
    double boundary_weight;  /* share of its volume by which a boundary particle counts in the
                                features of the lines, 0 to 10; 0: it only covers */
    double radius_ratio;     /* r2 / r1 that the line was trained with, above 0, below 1 */
    size_t samples;          /* a particle, 4 to 16384; see meniscus_set_samples */
    uint64_t seed;           /* of the samples */
    double fade;             /* exposure, over that on a flat surface, at which a particle weighs
                                1; 0: always */
    double tau;              /* share of the neighbors in smoothing (eq. 6), 0 to 1 */
    double covariance_share; /* of normals from positions (eq. 7), 0 to 1 */
    double surface_tension;  /* sigma in N/m */
    double spacing_ratio;    /* support radius over the spacing of particles at rest, the root of
                                their volume m / rho_0 (meniscus_spacing_ratio), 0.1 to 1000; picks
                                the classifier that ships */
    double contact_angle;    /* at which the surface meets a wall when both are at rest, in degrees,
                                measured in the fluid, 10 to 170 */
    double ambient_pressure; /* of the air, in (D - 1) sigma / h, 0 to 10: for hosts that clip
                                negative pressures, and where all particles have one
                                support radius */
    const meniscus_second_line* second_line;     /* NULL: none, unless k and d are NaN */
    const meniscus_curvature_map* curvature_map; /* NULL: the one that ships for the dimension */
    int coverage;                                /* meniscus_coverage */
    int verification;                            /* meniscus_verification */
    int curvature;                               /* meniscus_curvature */
    int force;                                   /* meniscus_force */
    int normal_passes;                           /* of smoothing, 0 to 1000 */
    int curvature_passes;                        /* of smoothing, 0 to 1000 */
    int threads;                                 /* 0 to 1024; 0: all that OpenMP offers */
} meniscus_options;

/* The particles of one step, all of one phase or with lists that hold neighbors of the same phase
 * alone. Start from zeros (`meniscus_particles p = {0}`) and set `size` to sizeof(p). `real` stands
 * for float or double, as the handle was created. Only `count`, `positions`, a radius and the lists
 * are required. Lists are compressed rows: the neighbors of i are neighbors[offsets[i]] to
 * neighbors[offsets[i + 1] - 1], symmetric (i among those of j where j is among those of i). They
 * may hold i itself and particles beyond its support radius. */
typedef struct meniscus_particles {
    size_t size;               /* of this struct in the calling program */
    size_t count;              /* particles, below 2^31 */
    const void* positions;     /* real, `stride` values a particle, coordinates first, m */
    size_t stride;             /* 0: as many as there are dimensions */
    const void* masses;        /* real, kg; NULL where all are equal */
    double support_radius;     /* h in m, where support_radii is NULL */
    const void* support_radii; /* real, one a particle, m; NULL: all have support_radius */
    const uint32_t* ids; /* a number of its own for each particle, where the host sorts them */
    const void* offsets; /* count + 1 of uint32_t or uint64_t, ascending from 0 */
    const uint32_t* neighbors;
    int offset_bits; /* 32 or 64, of `offsets` and `boundary_offsets` */
    /* Boundary particles cover; they count in the features of the lines by options.boundary_weight;
     * and a connected component of fluid that has one within h is at a wall. */
    size_t boundary_count;
    const void* boundary_positions;     /* real, `stride` values each; NULL: no boundary */
    const void* boundary_offsets;       /* count + 1, as `offsets` */
    const uint32_t* boundary_neighbors; /* boundary particles around each fluid particle */
    const void* boundary_weights; /* real, one a boundary particle: how many fluid particles it
                                     stands for, psi_b / m with the boundary volumes of Akinci
                                     et al. (2012). NULL: 1, which is safe and leaves more
                                     candidates at walls */
    const float* boundary_contact_angles; /* one a boundary particle, degrees; NULL: that of the
                                             options for all */
    /* The host's own classification in its density loop: not 0 for what the first line lets
     * through. NULL: that line decides here. */
    const uint8_t* candidates;
    /* Walls that are not particles but signed distance fields, volume maps or meshes: each fluid
     * particle is told of wall_count of them. Such a wall is a plane for a particle, and counts as
     * a layer of boundary particles half a spacing behind it would. */
    size_t wall_count;          /* up to 1024; 0: none */
    const void* wall_distances; /* real, wall_count a particle, m: of its center from each wall,
                                   negative inside; from the support radius on (infinity, too) a
                                   wall does nothing */
    const void* wall_normals;   /* real, wall_count vectors of `dimension` values a particle: unit
                                   vectors out of each wall; of walls out of reach, anything */
    const float* wall_contact_angles; /* wall_count, degrees; NULL: that of the options for all */
} meniscus_particles;

/* What the last step found, in slots: one for each particle that the line let through, in the order
 * of particles. Pointers hold until the next call that changes the handle; all but slot_of have
 * `slots` entries. Particles without a slot are interior. */
typedef struct meniscus_results {
    size_t size; /* of this struct in the calling program; set before the call */
    size_t slots;
    size_t count;                   /* particles of the step */
    const uint32_t* particle;       /* of each slot */
    const int32_t* slot_of;         /* of each particle; -1: interior */
    const uint8_t* surface_class;   /* MENISCUS_COVERED or MENISCUS_AT_SURFACE */
    const void* uncovered_fraction; /* real, lambda, 0 to 1 */
    const void* normal;    /* real, `dimension` values each, out of the fluid; 0: covered */
    const void* curvature; /* real, mean curvature kappa in 1/m, positive for a drop */
    const void* force;     /* real, `dimension` values each, N */
} meniscus_results;

/* Surface tension of one fluid, with the memory that it needs. */
typedef struct meniscus_surface meniscus_surface;

/* The version of the library, as "0.1.0". */
MENISCUS_API const char* meniscus_version(void);

/* What the last call of this thread that did not return MENISCUS_OK had to say, in one line; ""
 * before there was one. Holds until the next such call. */
MENISCUS_API const char* meniscus_last_error(void);

/* Sets all options: the project's own choices, or those of the 2020 paper. `size` is sizeof
 * *options. Bad: NULL, another size than in the header that the library was built with. */
MENISCUS_API int meniscus_options_init(meniscus_options* options, size_t size);
MENISCUS_API int meniscus_options_paper(meniscus_options* options, size_t size);

/* Creates a handle in *surface for 2 or 3 dimensions and a meniscus_precision. Bad: NULL, an option
 * out of its range (the message names both); *surface is NULL then. */
MENISCUS_API int meniscus_create(meniscus_surface** surface, const meniscus_options* options,
                                 int dimension, int precision);

/* Frees the handle. NULL is allowed. */
MENISCUS_API void meniscus_destroy(meniscus_surface* surface);

/* Room for so many particles with so many neighbors each: steps with no more allocate nothing.
 * Without it memory grows with the first steps, and stays smaller. MENISCUS_OUT_OF_MEMORY where
 * that is more than there can be. */
MENISCUS_API int meniscus_reserve(meniscus_surface* surface, size_t particles, size_t neighbors);

/* Samples a particle from now on, 4 to 16384. */
MENISCUS_API int meniscus_set_samples(meniscus_surface* surface, size_t samples);

/* The same for a time step in s and a sampling density C_SD in 1/s (2020 paper, section 3.4.3):
 * their product, at least `minimum`, at most 16384. */
MENISCUS_API int meniscus_set_samples_for_time_step(meniscus_surface* surface, double time_step,
                                                    double sampling_density, size_t minimum);

/* Another first line from now on; the second, where there is one, stays. Bad: out of the range of k
 * and d. */
MENISCUS_API int meniscus_set_line(meniscus_surface* surface, double k, double d);

/* Other options of the same names from now on, for solvers whose parameters change while they run.
 * Bad: out of the range of the option, which the message names. */
MENISCUS_API int meniscus_set_surface_tension(meniscus_surface* surface, double surface_tension);
MENISCUS_API int meniscus_set_contact_angle(meniscus_surface* surface, double contact_angle);
MENISCUS_API int meniscus_set_fade(meniscus_surface* surface, double fade);
MENISCUS_API int meniscus_set_smoothing(meniscus_surface* surface, int normal_passes,
                                        int curvature_passes);

/* Sets *spacing_ratio to the option of that name, for a support radius in m and the volume
 * m / rho_0 of a particle at rest in m^3 (in two dimensions m^2). That is not the distance at which
 * particles are placed where a particle has another volume than a cell of that lattice: with the
 * 0.8 (2 r)^3 of SPlisHSPlasH and h = 4 r it is 2.15. Bad: NULL, a number that is not positive and
 * finite, a dimension that is neither 2 nor 3. */
MENISCUS_API int meniscus_spacing_ratio(double support_radius, double volume, int dimension,
                                        double* spacing_ratio);

/* Sets *time_step to the longest step in s at which capillary waves stay stable (Brackbill et al.
 * 1992), sqrt(density spacing^3 / (2 pi surface_tension)), for the density in kg/m^3 and the
 * spacing of particles in m; to infinity where surface_tension is 0. Bad: NULL, a negative
 * surface_tension, another that is not positive, one that is not finite. */
MENISCUS_API int meniscus_capillary_time_step(double surface_tension, double density,
                                              double spacing, double* time_step);

/* Finds the surface and all that meniscus_results tells of it. Finite input never gives NaN. Bad:
 * NULL where something is required, radii that are not positive, whose squares the number type does
 * not hold or of which one is more than 1e6 times another, a surface_tension whose forces it does
 * not hold, offset_bits, a stride below the dimension. What costs a pass over all lists is not
 * checked: meniscus_check does. */
MENISCUS_API int meniscus_step(meniscus_surface* surface, const meniscus_particles* particles);

/* Looks at everything that a step reads: positions that are finite and not so far from the origin
 * that the number type cannot tell neighbors apart, masses and radii that it can calculate with,
 * offsets that ascend from 0 and are as wide as offset_bits says, neighbors that exist, each pair
 * in both lists and once, lists that reach as far as the support radius and not much farther, and
 * as many neighbors as the options' spacing_ratio says. For while a solver is written; takes about
 * as long as a step. The message names the first particle that is wrong. How long arrays are it
 * cannot know. */
MENISCUS_API int meniscus_check(const meniscus_surface* surface,
                                const meniscus_particles* particles);

/* Removes net force and net torque of each connected component of fluid that touches no wall. After
 * a step, with the same particles. Positions must not be wrapped at periodic ends. */
MENISCUS_API int meniscus_balance_momentum(meniscus_surface* surface,
                                           const meniscus_particles* particles);

/* Sets *results to what the last step found; nothing before the first. */
MENISCUS_API int meniscus_get_results(const meniscus_surface* surface, meniscus_results* results);

/* Writes the results into arrays over all particles of the step, zeros for interior ones. Any may
 * be NULL. `normal` and `force` have `stride` values a particle (0: as many as there are
 * dimensions), of which the first are set; reals as the handle was created. */
MENISCUS_API int meniscus_scatter(const meniscus_surface* surface, uint8_t* surface_class,
                                  void* uncovered_fraction, void* normal, void* curvature,
                                  void* force, size_t stride);

/* Adds force over mass (m/s^2) to the accelerations, `stride` values a particle (0: as many as
 * there are dimensions). `masses` (real, kg, one a particle) or, where it is NULL, `mass` for all.
 * Bad: NULL accelerations, a mass of a surface particle that is not positive and finite or so small
 * that the number type does not hold the acceleration. */
MENISCUS_API int meniscus_add_accelerations(const meniscus_surface* surface, const void* masses,
                                            double mass, void* accelerations, size_t stride);

#ifdef __cplusplus
}
#endif

#endif
