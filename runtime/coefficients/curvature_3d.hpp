// clang-format off
// The map from how normals turn to mean curvature (curvature_map.hpp). Written by
// `meniscus export`; do not edit.
//
// Trained by calibrate on 2393 filled clouds of seed 1, 486709 particles.
// There the mean error of h kappa (the largest of all groups) and its deviation are:
//   paraboloid, h/R 0 to 0.2: off by at most 0.012, +- 0.029
//   outside of paraboloid, h/R 0.02 to 0.05: off by at most 0.012, +- 0.027
//   sphere, h/R 0.1 to 0.6: off by at most 0.038, +- 0.024
//   outside of sphere, h/R 0.1 to 0.6: off by at most 0.047, +- 0.031
//   cylinder, h/R 0.2 to 0.6: off by at most 0.026, +- 0.026
//   outside of cylinder, h/R 0.2 to 0.6: off by at most 0.028, +- 0.031
//   ellipsoid, h/R 0.4: off by at most 0.016, +- 0.044
//   outside of ellipsoid, h/R 0.4: off by at most 0.022, +- 0.042
//   torus, h/R 0.5: off by at most 0.02, +- 0.028
//   outside of torus, h/R 0.5: off by at most 0.017, +- 0.032
#ifndef MENISCUS_COEFFICIENTS_0AA669745B4834AD
#define MENISCUS_COEFFICIENTS_0AA669745B4834AD

namespace meniscus {

struct Curvature3D {
    static constexpr int dimension = 3;
    /// Of 1, the turning of normals, its square, and the closed form
    static constexpr double coefficients[] = {0.0, 1.05981, -0.230221, 0.0};
    /// Turning in training; beyond, straight on
    static constexpr double min = -0.543853;
    /// Turning in training; beyond, straight on
    static constexpr double max = 0.717936;
    /// Over the surface particles around
    static constexpr bool averaged = true;
    /// r2 / r1 in training
    static constexpr double radius_ratio = 0.8;
    /// Exposure at which a particle weighs 1, over that on a flat surface, in training
    static constexpr double fade = 0.3333333333333333;
    /// Share of the neighbors in smoothing, in training
    static constexpr double tau = 0.5;
    /// Smoothing passes of the normals, in training
    static constexpr int normal_passes = 1;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 1.8;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.7;
};

} // namespace meniscus

#endif
