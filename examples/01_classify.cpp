// Which particles are candidates of the surface, found in the density loop that a solver has
// anyway: three additions and a comparison for each neighbor. Here on a cube of 12^3 particles,
// whose outer layer must be candidates and whose middle must not.
#include <meniscus/runtime/coefficients/surface_3d.hpp>
#include <meniscus/runtime/features/classifier.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

constexpr int edge = 12;
constexpr int count = edge * edge * edge;
constexpr double spacing = 0.5;
constexpr double h = 1; // support radius

/// How many particles i lies away from the nearest side.
int depth(int i) {
    const auto along = [](int place) { return std::min(place, edge - 1 - place); };
    return std::min({along(i % edge), along(i / edge % edge), along(i / edge / edge)});
}

int main() {
    using Coefficients = meniscus::Surface3D; // or your own, of `meniscus export`
    std::vector<std::array<double, 3>> x(count);
    for (int i = 0; i < count; ++i) {
        const std::array<int, 3> place = {i % edge, i / edge % edge, i / edge / edge};
        x[i] = {spacing * place[0], spacing * place[1], spacing * place[2]};
    }

    const auto line = meniscus::surface_line<Coefficients, double>(h / spacing);
    const auto range = meniscus::neighbor_range<double>(h, Coefficients::radius_ratio);
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        meniscus::FeatureSum<double, 3> sum;
        for (const auto& neighbor : x) { // a solver has lists
            const std::array<double, 3> step = {neighbor[0] - x[i][0], neighbor[1] - x[i][1],
                                                neighbor[2] - x[i][2]};
            const double squared = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
            // ... your density ...
            sum.add_equal_mass(step, squared, range);
        }
        const bool candidate = meniscus::is_surface(sum, line, h);
        wrong += (depth(i) == 0 && !candidate) || (depth(i) >= 2 && candidate) ? 1 : 0;
    }
    std::printf("%d particles on the wrong side\n", wrong);
    return wrong == 0 ? 0 : 1;
}
