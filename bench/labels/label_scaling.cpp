// Time and memory of exact labels from a hundred thousand to ten million particles. Copies of one
// snapshot stand side by side, out of reach of each other, so that all sizes have the same share of
// surface particles. Each size runs in a process of its own, whose peak memory the system tells.
#include "support/memory.hpp"
#include "support/tables.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace meniscus {
namespace {

Snapshot copies_of(const Positions& positions, double support_radius, std::size_t particles) {
    double width = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] =
            std::minmax_element(positions.begin(), positions.end(),
                                [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
        width = std::max(width, (*high)[axis] - (*low)[axis]);
    }
    const double step = width + 2 * support_radius;
    const std::size_t copies = (particles + positions.size() - 1) / positions.size();
    Snapshot all;
    all.positions.reserve(copies * positions.size());
    for (std::size_t c = 0; c < copies; ++c)
        for (auto position : positions) {
            position[0] += step * static_cast<double>(c % 8);
            position[1] += step * static_cast<double>(c / 8 % 8);
            position[2] += step * static_cast<double>(c / 64);
            all.positions.push_back(position);
        }
    return all;
}

/// Particles, microseconds and bytes a particle. Memory is what the runs add to the peak, and the
/// positions.
using Figures3 = std::array<double, 3>;

Figures3 measure_copies(const Snapshot& one, std::size_t particles, int threads) {
    const double h = *one.support_radius;
    const Snapshot all = copies_of(one.positions, h, particles);
    const double before = peak_bytes();
    LabelOptions options;
    options.threads = threads;
    const auto time = measure({{[&] { label_particles(all, h, options); }}}, {3, 1e-6})[0];
    const auto own = static_cast<double>(all.positions.size() * sizeof(all.positions[0]));
    const auto count = static_cast<double>(all.size());
    return {count, time.median / count * 1e6, (peak_bytes() - before + own) / count};
}

/// The figures of a process of its own.
Figures3 measured_apart(const Snapshot& one, std::size_t particles, int threads) {
    Figures3 figures{};
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
        throw FailureError("label-scaling: no pipe can be opened");
    const pid_t child = fork();
    if (child == 0) {
        figures = measure_copies(one, particles, threads);
        const bool is_told = write(ends[1], figures.data(), sizeof figures) == sizeof figures;
        _exit(is_told ? 0 : 1);
    }
    close(ends[1]);
    const bool is_heard = read(ends[0], figures.data(), sizeof figures) == sizeof figures;
    close(ends[0]);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0 || !is_heard)
        throw FailureError("label-scaling: measuring failed; is there memory enough?");
    return figures;
}

Tables label_scaling(const TableInput& input) {
    const Snapshot snapshot = read_snapshot_in_3d(input.files[0]);
    Table table = table_of(
        "label-scaling",
        fmt::format(
            "particles | microseconds a particle, {} thread{} {{:.3f}} | bytes a particle {{:.0f}}",
            input.threads, input.threads == 1 ? "" : "s"));
    for (const std::size_t particles : {100'000, 1'000'000, 10'000'000}) {
        const auto [count, time, bytes] = measured_apart(snapshot, particles, input.threads);
        table.add({count, time, bytes});
    }
    return {table};
}

} // namespace

TableGroup label_scaling_tables() {
    return {"Labels and classification",
            {{"label-scaling", "SNAPSHOT", 1, "time and memory up to ten million particles",
              label_scaling}}};
}

} // namespace meniscus
