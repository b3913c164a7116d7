// The README's lines inside a solver: a free block of fluid is drawn together and does not drift.
#include "readme_includes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

using Vector = std::array<float, 3>;

constexpr float h = 1;
constexpr float mass = 0.125F;
constexpr float rest_density = 1;

void add_surface_tension(const float* positions, const std::size_t* offsets,
                         const std::uint32_t* neighbors, std::size_t count, Vector* acceleration) {
#include "readme_lines.hpp"
}

float distance_squared(const Vector& a, const Vector& b) {
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        sum += (b[axis] - a[axis]) * (b[axis] - a[axis]);
    return sum;
}

} // namespace

int main() {
    std::vector<Vector> positions;
    for (int i = 0; i < 729; ++i)
        positions.push_back({0.5F * static_cast<float>(i % 9), 0.5F * static_cast<float>(i / 9 % 9),
                             0.5F * static_cast<float>(i / 81)});
    std::vector<std::size_t> offsets{0};
    std::vector<std::uint32_t> neighbors;
    for (const Vector& center : positions) {
        for (std::uint32_t j = 0; j < positions.size(); ++j)
            if (distance_squared(center, positions[j]) < h * h)
                neighbors.push_back(j);
        offsets.push_back(neighbors.size());
    }
    std::vector<Vector> acceleration(positions.size(), Vector{});
    add_surface_tension(positions[0].data(), offsets.data(), neighbors.data(), positions.size(),
                        acceleration.data());
    const Vector& corner = acceleration[0];
    double net = 0;
    double sizes = 0;
    for (const Vector& of_particle : acceleration) {
        net += static_cast<double>(of_particle[0]);
        sizes += std::fabs(static_cast<double>(of_particle[0]));
    }
    const Vector& middle = acceleration[364];
    if (corner[0] > 0 && corner[1] > 0 && corner[2] > 0 && std::fabs(net) < 1e-6 * sizes &&
        middle == Vector{})
        return 0;
    std::puts("the README's lines do not do what it says");
    return 1;
}
