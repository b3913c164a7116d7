// A small stand-in for what a surface-tension method of SPlisHSPlasH 2.16 sees of that program:
// names, signatures and loop macros as its headers document them, written anew and with no more
// behind them than the plugin's tests need. USE_DOUBLE picks the number type, as there.
#pragma once

#include <Eigen/Dense>

#ifdef USE_DOUBLE
typedef double Real;
#define RealParameter DoubleParameter
#else
typedef float Real;
#define RealParameter FloatParameter
#endif

using Vector3r = Eigen::Matrix<Real, 3, 1>;

#define FORCE_INLINE inline
