#include "normal_schemes.hpp"
#include "normal_tables.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr auto& sample_counts = circle_sample_counts;
constexpr std::size_t rows = sample_counts.size();
constexpr std::size_t columns = circle_passes;
constexpr double tau = 0.5;

using Errors = std::array<std::array<MeanError, columns>, rows>;

/// Errors over all runs, or over one.
struct CircleErrors {
    Errors random, outward, exact; ///< of `exact` the first row

    void add(const CircleErrors& other) {
        for (Errors CircleErrors::*part :
             {&CircleErrors::random, &CircleErrors::outward, &CircleErrors::exact})
            for (std::size_t row = 0; row < rows; ++row)
                for (std::size_t column = 0; column < columns; ++column)
                    (this->*part)[row][column].add((other.*part)[row][column]);
    }
};

/// After no smoothing pass, one and two.
std::array<MeanError, columns> errors_of(const NormalCase& some, const SampleDirections& directions,
                                         const ExposureOptions& options) {
    SurfaceParticles<double, 2> list;
    std::vector<std::array<double, 2>> before;
    std::array<MeanError, columns> errors;
    expose<2>(some, directions, options, list);
    for (std::size_t pass = 0; pass < columns; ++pass) {
        if (pass > 0)
            smooth_normals<double, 2>(tau, SerialLoop{}, list, before);
        errors[pass] = distance_error<2>(some, list);
    }
    return errors;
}

/// One cloud, and one set of directions for each number of samples.
CircleErrors errors_of_run(double radius, std::uint64_t run) {
    const NormalCase some = circle_case(radius, run);
    ExposureOptions as_published;
    as_published.verification = Verification::drop;
    ExposureOptions exact;
    exact.method = CoverageMethod::exact;
    SampleDirections directions;
    CircleErrors errors;
    for (std::size_t row = 0; row < rows; ++row) {
        fill_from_scheme("random", 2, sample_counts[row], run, directions);
        errors.random[row] = errors_of(some, directions, as_published);
        fill_outward_directions<2>(sample_counts[row], run, directions);
        errors.outward[row] = errors_of(some, directions, {});
    }
    errors.exact[0] = errors_of(some, directions, exact);
    return errors;
}

CircleErrors errors_of_runs(double radius, std::size_t runs) {
    std::vector<CircleErrors> of_run(runs);
#pragma omp parallel for schedule(dynamic)
    for (std::size_t run = 0; run < runs; ++run)
        of_run[run] = errors_of_run(radius, run);
    CircleErrors all;
    for (const CircleErrors& one : of_run)
        all.add(one);
    return all;
}

/// Slope of the least-squares line through log(error) over log(samples), without smoothing.
template <class Error>
double slope(const Error& error) {
    double x_sum = 0, y_sum = 0, xx_sum = 0, xy_sum = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        const double x = std::log(static_cast<double>(sample_counts[row]));
        const double y = std::log(error(row));
        x_sum += x, y_sum += y, xx_sum += x * x, xy_sum += x * y;
    }
    return (rows * xy_sum - x_sum * y_sum) / (rows * xx_sum - x_sum * x_sum);
}

void print_table(double radius, std::size_t runs) {
    const CircleErrors errors = errors_of_runs(radius, runs);
    fmt::print("\n**Circle of radius {:g} h, {} runs**\n\n"
               "| samples | preprint: 0 passes | 1 | 2 | random: 0 | 1 | 2 | outward: 0 | 1 | 2 |\n"
               "|---|---|---|---|---|---|---|---|---|---|\n",
               radius, runs);
    for (std::size_t row = 0; row < rows; ++row) {
        fmt::print("| {} |", sample_counts[row]);
        for (const double figure : preprint_circle_errors[row])
            fmt::print(" {:.3f} |", figure);
        for (const Errors* part : {&errors.random, &errors.outward})
            for (const MeanError& error : (*part)[row])
                fmt::print(" {:.4f} |", error.mean());
        fmt::print("\n");
    }
    const auto& exact = errors.exact[0];
    fmt::print("| exact | | | | | | | {:.5f} | {:.4f} | {:.4f} |\n", exact[0].mean(),
               exact[1].mean(), exact[2].mean());
    fmt::print("| exponent | {:.2f} | | | {:.2f} | | | {:.2f} | | |\n",
               slope([](std::size_t row) { return preprint_circle_errors[row][0]; }),
               slope([&](std::size_t row) { return errors.random[row][0].mean(); }),
               slope([&](std::size_t row) { return errors.outward[row][0].mean(); }));
}

} // namespace

void print_circle_tables() {
    constexpr std::size_t runs = 100;
    for (const double radius : {1.0, 4.0})
        print_table(radius, runs);
}

} // namespace meniscus
