// Normals on the circle of the 2019 preprint (Table 1), with its figures beside ours.
#include "normal_schemes.hpp"
#include "support/tables.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr auto& sample_counts = circle_sample_counts;
constexpr std::size_t rows = sample_counts.size();
constexpr std::size_t columns = circle_passes;
constexpr double tau = 0.5;

using Errors = std::array<std::array<Spread, columns>, rows>;

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
std::array<Spread, columns> errors_of(const NormalCase& some, const SampleDirections& directions,
                                      const SurfaceTensionOptions& options) {
    SurfaceParticles<double, 2> list;
    std::vector<std::array<double, 2>> before;
    std::array<Spread, columns> errors;
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
    SurfaceTensionOptions as_published;
    as_published.verification = Verification::drop;
    SurfaceTensionOptions exact;
    exact.coverage = CoverageMethod::exact;
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

/// Of log(error) over log(samples), without smoothing.
template <class Error>
double exponent(const Error& error) {
    Slope slope;
    for (std::size_t row = 0; row < rows; ++row)
        slope.add(std::log(static_cast<double>(sample_counts[row])), std::log(error(row)));
    return slope.value();
}

Table table_of_circle(double radius, std::size_t runs) {
    const CircleErrors errors = errors_of_runs(radius, runs);
    Table table = titled_table(
        fmt::format("circle_{:g}", radius),
        fmt::format("Circle of radius {:g} h, {} runs", radius, runs),
        "samples | preprint: 0 passes {:.3f} | 1 {:.3f} | 2 {:.3f} | random: 0 {:.4f} | 1 {:.4f} | "
        "2 {:.4f} | outward: 0 {:.4f} | 1 {:.4f} | 2 {:.4f}");
    for (std::size_t row = 0; row < rows; ++row) {
        table.add({sample_counts[row]});
        for (const double figure : preprint_circle_errors[row])
            table.rows.back().emplace_back(figure);
        for (const Errors* part : {&errors.random, &errors.outward})
            for (const Spread& error : (*part)[row])
                table.rows.back().emplace_back(error.mean());
    }
    const auto& exact = errors.exact[0];
    table.add({"exact", "", "", "", "", "", "", fmt::format("{:.5f}", exact[0].mean()),
               exact[1].mean(), exact[2].mean()});
    const auto text = [](double slope) { return fmt::format("{:.2f}", slope); };
    table.add(
        {"exponent", text(exponent([](std::size_t row) { return preprint_circle_errors[row][0]; })),
         "", "", text(exponent([&](std::size_t row) { return errors.random[row][0].mean(); })), "",
         "", text(exponent([&](std::size_t row) { return errors.outward[row][0].mean(); })), "",
         ""});
    return table;
}

Tables circles(const TableInput&) {
    constexpr std::size_t runs = 100;
    return {table_of_circle(1, runs), table_of_circle(4, runs)};
}

} // namespace

TableGroup normal_circle_tables() {
    return {"Normals",
            {{"normals-circle", "", 0, "on a circle, beside the 2019 preprint", circles}}};
}

} // namespace meniscus
