// What studies measure of particles and of what changes over time.
#pragma once

#include <meniscus/sph/scene/scene.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace meniscus {

struct MeanAndDeviation {
    double mean = 0;
    double deviation = 0;
};

/// Of values, of which there is at least one.
MeanAndDeviation mean_and_deviation(const std::vector<double>& values);

Place center_of(const Positions& positions);

/// Of a pointwise value over the particles within `radius` of the center of all. NaN where none is.
MeanAndDeviation inside(const Positions& positions, const std::vector<double>& values,
                        double radius);

/// The slope of log(error) over log(length): the order with which errors vanish.
double convergence_order(const std::vector<double>& lengths, const std::vector<double>& errors);

/// How far a droplet swings in a mode: the mean over its particles of r^n P_n(cos theta), theta
/// from the x axis and r from the center of mass; in 2D of r^n cos(n theta). Modes from 2 to 4.
double mode_moment(const Positions& positions, int mode, int dimension);

/// The ball or disk around the origin stretched in a mode: each place x moves by
/// amplitude / (n R^(n - 2)) grad(r^n P_n) (in 2D r^n cos(n theta)), which keeps volumes to first
/// order and moves the surface by amplitude R P_n.
Positions in_mode(Positions positions, int mode, double amplitude, double radius, int dimension);

/// Period and damping of a swing about zero.
struct Swing {
    std::size_t zeros = 0;
    double period = 0; ///< over as many whole ones as there are; 0: fewer than three zeros
    double left = 0;   ///< of the largest value between zeros one period later; 0 likewise
};
Swing swing_of(const std::vector<double>& times, const std::vector<double>& values);

/// Maxima of a series that rise above the lower of the minima beside them by more than `share` of
/// the largest value; the first and last value are none.
int local_maxima(const std::vector<double>& values, double share);

/// The first time after which the values stay at or below `limit`; nothing where the last one is
/// above.
std::optional<double> stays_below(const std::vector<double>& times,
                                  const std::vector<double>& values, double limit);

/// Share of the particles whose nearest neighbor is closer than `distance`.
double share_closer(const Positions& positions, double distance);

} // namespace meniscus
