// Vectors of three doubles, for the few places that need products of them.
#pragma once

#include "../simd/instruction_set.hpp"

#include <array>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

using Vector3 = std::array<double, 3>;

MENISCUS_HOST_DEVICE inline double dot(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

MENISCUS_HOST_DEVICE inline Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

MENISCUS_HOST_DEVICE inline Vector3 scaled(double factor, const Vector3& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

MENISCUS_HOST_DEVICE inline Vector3 sum(const Vector3& a, const Vector3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

MENISCUS_HOST_DEVICE inline Vector3 difference(const Vector3& a, const Vector3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Two axes at right angles to a unit vector and to each other; (first, second, axis) is
/// right-handed (Duff et al. 2017, Building an orthonormal basis, revisited).
struct Frame {
    Vector3 first, second;

    MENISCUS_HOST_DEVICE explicit Frame(const Vector3& axis) {
        const double sign = axis[2] < 0 ? -1.0 : 1.0;
        const double a = -1 / (sign + axis[2]);
        const double b = axis[0] * axis[1] * a;
        first = {1 + sign * axis[0] * axis[0] * a, sign * b, -sign * axis[0]};
        second = {b, sign + axis[1] * axis[1] * a, -axis[1]};
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
