// Time and memory of exact labels from a hundred thousand to ten million particles. Copies of one
// snapshot stand side by side, out of reach of each other, so that all sizes have the same share of
// surface particles. Each size runs in a process of its own, whose peak memory the system tells.
// Usage: label_scaling SNAPSHOT [--threads N]
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace meniscus {
namespace {

using Clock = std::chrono::steady_clock;

Snapshot copies_of(const Snapshot& snapshot, std::size_t particles) {
    double width = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] =
            std::minmax_element(snapshot.positions.begin(), snapshot.positions.end(),
                                [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
        width = std::max(width, (*high)[axis] - (*low)[axis]);
    }
    const double step = width + 2 * *snapshot.support_radius;
    const std::size_t copies = (particles + snapshot.size() - 1) / snapshot.size();
    Snapshot all;
    all.positions.reserve(copies * snapshot.size());
    for (std::size_t c = 0; c < copies; ++c)
        for (auto position : snapshot.positions) {
            position[0] += step * static_cast<double>(c % 8);
            position[1] += step * static_cast<double>(c / 8 % 8);
            position[2] += step * static_cast<double>(c / 64);
            all.positions.push_back(position);
        }
    return all;
}

double peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024;
}

/// One row of the table. Times are the best of three runs; memory is what the first run adds to the
/// peak, and the positions.
void measure(const Snapshot& snapshot, std::size_t particles, int threads) {
    const Snapshot all = copies_of(snapshot, particles);
    const double radius = *snapshot.support_radius;
    const auto count = static_cast<double>(all.size());
    const double before = peak_bytes();
    LabelOptions options;
    options.threads = threads;
    double seconds = 1e300;
    double added = 0;
    for (int run = 0; run < 3; ++run) {
        const auto begin = Clock::now();
        const Labels labels = label_particles(all, radius, options);
        seconds = std::min(seconds, std::chrono::duration<double>(Clock::now() - begin).count());
        if (run == 0)
            added = peak_bytes() - before;
    }
    const auto own = static_cast<double>(all.positions.size() * sizeof(all.positions[0]));
    fmt::print("| {} | {:.3f} | {:.0f} |\n", all.size(), seconds / count * 1e6,
               (added + own) / count);
}

void run(int argument_count, char** arguments) {
    if (argument_count != 2 && !(argument_count == 4 && !std::strcmp(arguments[2], "--threads")))
        throw std::runtime_error("usage: label_scaling SNAPSHOT [--threads N]");
    const int threads = argument_count == 4 ? std::stoi(arguments[3]) : 1;
    const Snapshot snapshot = read_snapshot(arguments[1]);
    if (!snapshot.support_radius || snapshot.size() == 0)
        throw std::runtime_error("the snapshot must store its support radius");
    fmt::print("| particles | microseconds a particle, {} thread{} | bytes a particle |\n"
               "|---|---|---|\n",
               threads, threads == 1 ? "" : "s");
    for (const std::size_t particles : {100'000, 1'000'000, 10'000'000}) {
        std::fflush(stdout);
        const pid_t child = fork();
        if (child == 0) {
            measure(snapshot, particles, threads);
            std::fflush(stdout);
            _exit(0);
        }
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0)
            throw std::runtime_error("measuring failed; is there memory enough?");
    }
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        meniscus::run(argument_count, arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "label_scaling: %s\n", error.what());
        return 1;
    }
}
