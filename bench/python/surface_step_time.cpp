// surface_step_time FILE: the median time of a surface-tension step over a snapshot in C++, for
// python_speed.py to hold its own against. The same options, lists and threads.
#include <meniscus/bindings/step/surface_step.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/neighbor_search.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

int main(int argument_count, char** arguments) {
    using namespace meniscus;
    if (argument_count != 2)
        return 2;
    const Snapshot snapshot = read_snapshot(arguments[1]);
    const NeighborLists lists = find_neighbors(snapshot.positions, snapshot.support_radius.value());
    StepParticles particles;
    particles.count = snapshot.size();
    particles.positions = snapshot.positions.data();
    particles.stride = 3;
    particles.support_radius = *snapshot.support_radius;
    particles.offsets = lists.offsets.data();
    particles.neighbors = lists.neighbors.data();
    const auto surface = surface_step({}, {snapshot.dimension, true, 0});
    std::vector<double> seconds;
    for (int repetition = 0; repetition < 9; ++repetition) {
        const auto start = std::chrono::steady_clock::now();
        surface->step(particles);
        seconds.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::nth_element(seconds.begin(), seconds.begin() + 4, seconds.end());
    std::printf("%.6f\n", seconds[4]);
}
