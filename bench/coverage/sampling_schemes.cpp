// What the sampling schemes are worth: how evenly each spreads its directions, and how far lambda
// estimated with them lies from its exact value, by number of directions, on the sphere and on the
// circle.
#include "coverage_cases.hpp"
#include "discrepancy.hpp"
#include "support/statistics.hpp"
#include "support/tables.hpp"

#include <meniscus/labeler/monte_carlo/coverage.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr std::size_t sample_counts[] = {10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000};
/// The slope of a line through the logarithms is taken from here on.
constexpr std::size_t slope_from = 100;
constexpr std::uint64_t seeds = 4;
constexpr std::size_t cases_per_file = 100;
/// Beyond, what takes time with the square of the number of directions is left out.
constexpr std::size_t max_squared = 10000;

/// On the circle the second base means nothing.
const std::vector<std::string>& scheme_names(int dimension) {
    static const std::vector<std::string> on_circle = {
        "random", "table", "halton", "halton-3-2", "halton-5-2", "halton-7-2", "blue-noise"};
    static const std::vector<std::string> on_sphere = {"random",     "table",      "halton",
                                                       "halton-3-2", "halton-2-5", "halton-3-5",
                                                       "halton-2-7", "halton-5-7", "blue-noise"};
    return dimension == 2 ? on_circle : on_sphere;
}

/// One scheme with one number of directions.
struct Result {
    std::string scheme;
    int dimension = 3;
    std::size_t samples = 0;
    double discrepancy = 0;      ///< largest: star on the circle, caps on the sphere
    double mean_discrepancy = 0; ///< root mean square over caps; 0: not calculated
    double error = 0;            ///< of lambda, root mean square
    double max_error = 0;
};

/// Mean over the seeds.
void measure_discrepancy(const SamplingScheme& scheme, Result& result) {
    std::vector<Direction> directions(result.samples);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        scheme.fill(result.dimension, seed, 0, directions);
        if (result.dimension == 2)
            result.discrepancy += star_discrepancy(directions) / seeds;
        else
            result.discrepancy += cap_discrepancy(directions) / seeds;
        if (result.dimension == 3 && result.samples <= max_squared)
            result.mean_discrepancy += mean_cap_discrepancy(directions) / seeds;
    }
}

/// Estimated less exact lambda of each case.
std::vector<double> errors_of_lambda(const SamplingScheme& scheme, int dimension,
                                     std::size_t samples, std::uint64_t seed,
                                     const std::vector<CoverageCase>& cases) {
    std::vector<Direction> shared(samples);
    scheme.fill(dimension, seed, 0, shared);
    const DirectionBlocks table = compact_blocks(std::move(shared));
    std::vector<double> errors(cases.size());
#pragma omp parallel
    {
        Caps caps;
        caps.radius_ratio = case_radius_ratio;
        std::vector<Direction> own(samples);
        DirectionBlocks own_blocks;
#pragma omp for schedule(dynamic, 16)
        for (std::size_t c = 0; c < cases.size(); ++c) {
            if (scheme.per_particle) {
                scheme.fill(dimension, seed, c, own);
                plain_blocks(own, own_blocks);
            }
            caps.displacements = cases[c].displacements;
            const auto uncovered = static_cast<double>(
                count_uncovered(scheme.per_particle ? own_blocks : table, caps));
            errors[c] = uncovered / static_cast<double>(samples) - cases[c].uncovered_fraction;
        }
    }
    return errors;
}

/// Over all cases and seeds.
void measure_error(const SamplingScheme& scheme, const std::vector<CoverageCase>& cases,
                   Result& result) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed)
        for (const double error :
             errors_of_lambda(scheme, result.dimension, result.samples, seed, cases)) {
            sum += error * error;
            result.max_error = std::max(result.max_error, std::abs(error));
        }
    result.error = std::sqrt(sum / static_cast<double>(seeds * cases.size()));
}

std::vector<Result> measure(int dimension, const std::vector<CoverageCase>& cases) {
    std::vector<Result> results;
    for (const std::string& name : scheme_names(dimension))
        for (const std::size_t samples : sample_counts) {
            Result result{name, dimension, samples};
            const SamplingScheme scheme = sampling_scheme(name);
            measure_discrepancy(scheme, result);
            measure_error(scheme, cases, result);
            results.push_back(result);
        }
    return results;
}

using Quantity = double Result::*;

/// A column for each number of directions, the smallest of it bold, and the slope of the
/// logarithms.
Table table_by_samples(const char* name, const std::string& title,
                       const std::vector<Result>& results, Quantity quantity) {
    std::string columns = "scheme";
    for (const std::size_t samples : sample_counts)
        columns += " | " + std::to_string(samples) + " {:.1e}";
    Table table = titled_table(name, title, columns + " | slope {:.2f}");
    for (std::size_t k = 1; k <= std::size(sample_counts); ++k)
        table.columns[k].bold_min = true;
    Slope slope;
    for (const Result& result : results) {
        const double value = result.*quantity;
        if (result.samples == sample_counts[0]) {
            table.add({result.scheme});
            slope = {};
        }
        table.rows.back().emplace_back(value > 0 ? Cell(value) : Cell(""));
        if (result.samples >= slope_from && value > 0)
            slope.add(std::log(static_cast<double>(result.samples)), std::log(value));
        if (result.samples == *std::rbegin(sample_counts))
            table.rows.back().emplace_back(slope.value());
    }
    return table;
}

Tables sampling_schemes_tables(const TableInput& input) {
    const auto disc_cases = cases_of_a_disc();
    const auto file_cases = cases_of_files(input.files, cases_per_file);
    const auto circle = measure(2, disc_cases);
    const auto sphere = measure(3, file_cases);
    Tables tables = {
        table_by_samples("error_3d", "3D: error of lambda, root mean square", sphere,
                         &Result::error),
        table_by_samples("max_error_3d", "3D: error of lambda, largest", sphere,
                         &Result::max_error),
        table_by_samples("discrepancy_3d", "3D: cap discrepancy, largest", sphere,
                         &Result::discrepancy),
        table_by_samples("mean_discrepancy_3d", "3D: cap discrepancy, root mean square", sphere,
                         &Result::mean_discrepancy),
        table_by_samples("error_2d", "2D: error of lambda, root mean square", circle,
                         &Result::error),
        table_by_samples("max_error_2d", "2D: error of lambda, largest", circle,
                         &Result::max_error),
        table_by_samples("discrepancy_2d", "2D: star discrepancy", circle, &Result::discrepancy)};
    tables[0].before =
        fmt::format(
            "{} particles in 3D, {} in 2D; {} seeds. Columns: directions a particle; slope: of the "
            "logarithms from {} directions on; bold: the smallest of a column.\n",
            file_cases.size(), disc_cases.size(), seeds, slope_from) +
        tables[0].before;
    return tables;
}

} // namespace

TableGroup sampling_tables() {
    return {"Labels and classification",
            {{"sampling-schemes", "SNAPSHOT...", 1, "evenness and errors of sampling schemes",
              sampling_schemes_tables}}};
}

} // namespace meniscus
