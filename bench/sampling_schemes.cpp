// What the sampling schemes are worth: how evenly each spreads its directions, and how far lambda
// estimated with them lies from its exact value, by number of directions, on the sphere and on the
// circle. Prints the tables of docs/sampling_schemes.md in Markdown and writes the same numbers as
// JSON for scripts/plot_sampling_schemes.py.
// Usage: sampling_schemes OUTPUT.json SNAPSHOT...
#include "coverage_cases.hpp"
#include "discrepancy.hpp"

#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/labeler/coverage.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace meniscus {
namespace {

constexpr std::size_t sample_counts[] = {10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000};
/// The slope of a line through the logarithms is taken from here on.
constexpr std::size_t slope_from = 100;
constexpr std::uint64_t seeds = 4;
constexpr std::size_t cases_per_file = 100;
/// Beyond, what takes time with the square of the number of directions is left out.
constexpr std::size_t largest_squared = 10000;

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
    double largest_error = 0;
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
        if (result.dimension == 3 && result.samples <= largest_squared)
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
            result.largest_error = std::max(result.largest_error, std::abs(error));
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

/// Slope of the least-squares line through log(quantity) over log(samples).
double slope(const std::vector<Result>& results, const std::string& scheme, Quantity quantity) {
    double count = 0, x_sum = 0, y_sum = 0, xx_sum = 0, xy_sum = 0;
    for (const Result& result : results) {
        if (result.scheme != scheme || result.samples < slope_from || result.*quantity == 0)
            continue;
        const double x = std::log(static_cast<double>(result.samples));
        const double y = std::log(result.*quantity);
        count += 1;
        x_sum += x;
        y_sum += y;
        xx_sum += x * x;
        xy_sum += x * y;
    }
    return (count * xy_sum - x_sum * y_sum) / (count * xx_sum - x_sum * x_sum);
}

/// The smallest of a column, which is printed bold.
double best_of(const std::vector<Result>& results, std::size_t samples, Quantity quantity) {
    double best = 2;
    for (const Result& result : results)
        if (result.samples == samples)
            best = std::min(best, result.*quantity);
    return best;
}

void print_table(const std::string& title, const std::vector<Result>& results, Quantity quantity) {
    fmt::print("\n**{}**\n\n| scheme |", title);
    std::string rule = "|---|";
    for (const std::size_t samples : sample_counts) {
        fmt::print(" {} |", samples);
        rule += "---|";
    }
    fmt::print(" slope |\n{}---|", rule);
    for (const Result& result : results) {
        const double value = result.*quantity;
        if (result.samples == sample_counts[0])
            fmt::print("\n| {} |", result.scheme);
        if (value == 0)
            fmt::print(" |");
        else if (value == best_of(results, result.samples, quantity))
            fmt::print(" **{:.1e}** |", value);
        else
            fmt::print(" {:.1e} |", value);
        if (result.samples == *std::rbegin(sample_counts))
            fmt::print(" {:.2f} |", slope(results, result.scheme, quantity));
    }
    fmt::print("\n");
}

void print_tables(const std::vector<Result>& circle, std::size_t circle_cases,
                  const std::vector<Result>& sphere, std::size_t sphere_cases) {
    fmt::print("{} particles in 3D, {} in 2D; {} seeds. Columns: directions a particle; slope: of "
               "the logarithms from {} directions on; bold: the smallest of a column.\n",
               sphere_cases, circle_cases, seeds, slope_from);
    print_table("3D: error of lambda, root mean square", sphere, &Result::error);
    print_table("3D: error of lambda, largest", sphere, &Result::largest_error);
    print_table("3D: cap discrepancy, largest", sphere, &Result::discrepancy);
    print_table("3D: cap discrepancy, root mean square", sphere, &Result::mean_discrepancy);
    print_table("2D: error of lambda, root mean square", circle, &Result::error);
    print_table("2D: error of lambda, largest", circle, &Result::largest_error);
    print_table("2D: star discrepancy", circle, &Result::discrepancy);
}

void write_json(const std::vector<Result>& results, const std::string& file) {
    auto rows = nlohmann::json::array();
    for (const Result& result : results)
        rows.push_back({{"scheme", result.scheme},
                        {"dimension", result.dimension},
                        {"samples", result.samples},
                        {"discrepancy", result.discrepancy},
                        {"mean_discrepancy", result.mean_discrepancy},
                        {"error", result.error},
                        {"largest_error", result.largest_error}});
    write_whole(file, rows.dump(1) + "\n");
}

int run(int argument_count, char** arguments) {
    if (argument_count < 3)
        throw std::runtime_error("usage: sampling_schemes OUTPUT.json SNAPSHOT...");
    check_can_be_written(arguments[1]);
    const auto disc_cases = cases_of_a_disc();
    const auto file_cases =
        cases_of_files({arguments + 2, arguments + argument_count}, cases_per_file);
    const auto circle = measure(2, disc_cases);
    const auto sphere = measure(3, file_cases);
    print_tables(circle, disc_cases.size(), sphere, file_cases.size());
    auto all = circle;
    all.insert(all.end(), sphere.begin(), sphere.end());
    write_json(all, arguments[1]);
    return 0;
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        return meniscus::run(argument_count, arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "sampling_schemes: %s\n", error.what());
        return 1;
    }
}
