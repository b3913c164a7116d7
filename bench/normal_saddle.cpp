#include "normal_schemes.hpp"
#include "normal_tables.hpp"

#include <meniscus/data/snapshot_files.hpp>

#include <algorithm>
#include <array>
#include <ctime>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace meniscus {
namespace {

constexpr std::array<std::size_t, 5> sample_counts = {30, 60, 120, 240, 360};
constexpr std::size_t clouds = 8;
constexpr int most_passes = 2;
constexpr double usual_radius = 2; // h in spacings

using List = SurfaceParticles<double, 3>;

const std::vector<NormalCase>& saddles(double radius_in_spacings) {
    static std::vector<std::pair<double, std::vector<NormalCase>>> made;
    for (const auto& [radius, cases] : made)
        if (radius == radius_in_spacings)
            return cases;
    std::vector<NormalCase> cases;
    for (std::size_t seed = 0; seed < clouds; ++seed)
        cases.push_back(saddle_case(radius_in_spacings, seed));
    return made.emplace_back(radius_in_spacings, std::move(cases)).second;
}

std::size_t measured_count(const std::vector<NormalCase>& cases) {
    std::size_t count = 0;
    for (const NormalCase& some : cases)
        count += static_cast<std::size_t>(
            std::count(some.measured.begin(), some.measured.end(), std::uint8_t{1}));
    return count;
}

/// How normals become smoother after they are sampled.
struct Smoothing {
    double tau = 0.5;
    double covariance_share = 0;
};

using PassErrors = std::array<double, most_passes + 1>;

/// Mean angle in degrees after no smoothing pass, one and two, over all clouds.
PassErrors errors_of(const NormalScheme& scheme, std::size_t samples, double radius_in_spacings,
                     const Smoothing& smoothing = {}) {
    std::array<MeanError, most_passes + 1> errors;
    List list;
    std::vector<List::Vector> before;
    SampleDirections directions;
    const auto& cases = saddles(radius_in_spacings);
    for (std::size_t seed = 0; seed < cases.size(); ++seed) {
        scheme.fill(samples, seed, directions);
        scheme.expose(cases[seed], seed, directions, list);
        if (smoothing.covariance_share > 0)
            mix_in_covariance_normals<double, 3>(smoothing.covariance_share, SerialLoop{}, list);
        for (int pass = 0; pass <= most_passes; ++pass) {
            if (pass > 0)
                smooth_normals<double, 3>(smoothing.tau, SerialLoop{}, list, before);
            errors[pass].add(angular_error<3>(cases[seed], list));
        }
    }
    return {errors[0].mean(), errors[1].mean(), errors[2].mean()};
}

void print_header(const std::string& first) {
    fmt::print("| {} |", first);
    std::string rule = "|---|";
    for (const std::size_t samples : sample_counts) {
        fmt::print(" {} |", samples);
        rule += "---|";
    }
    fmt::print("\n{}\n", rule);
}

/// In seconds of processor time, which a busy machine disturbs least: the median of repetitions,
/// those of all works taken in turn.
std::vector<double> median_times(const std::vector<std::function<void()>>& works) {
    constexpr std::size_t repetitions = 15;
    std::vector<std::vector<double>> times(works.size());
    for (std::size_t repetition = 0; repetition < repetitions; ++repetition)
        for (std::size_t work = 0; work < works.size(); ++work) {
            const std::clock_t begin = std::clock();
            works[work]();
            times[work].push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
    std::vector<double> medians;
    for (auto& of_work : times) {
        std::nth_element(of_work.begin(), of_work.begin() + repetitions / 2, of_work.end());
        medians.push_back(of_work[repetitions / 2]);
    }
    return medians;
}

/// A scheme with a number of samples; directions ready.
struct Timed {
    const NormalScheme& scheme;
    std::size_t samples;
    SampleDirections directions;
    double nanoseconds = 0; ///< a surface particle
};

/// One for each scheme and number of samples; one alone for the exact scheme.
std::vector<Timed> all_timed() {
    std::vector<Timed> all;
    for (const NormalScheme& scheme : normal_schemes())
        for (const std::size_t samples : sample_counts) {
            if (scheme.method == CoverageMethod::exact && samples != sample_counts[0])
                continue;
            all.push_back({scheme, samples, {}});
            scheme.fill(samples, 0, all.back().directions);
        }
    return all;
}

/// Of the steps that follow sampling, in nanoseconds a surface particle.
struct TimesAfter {
    double smoothing, covariance;
};

TimesAfter measure_times(const NormalCase& some, std::vector<Timed>& all) {
    List list;
    List exposed;
    std::vector<List::Vector> before;
    normal_scheme("exact").expose(some, 0, all[0].directions, exposed);
    List smoothed = exposed;
    List mixed = exposed;
    std::vector<std::function<void()>> works;
    works.reserve(all.size() + 2);
    for (Timed& timed : all)
        works.emplace_back([&] { timed.scheme.expose(some, 0, timed.directions, list); });
    works.emplace_back([&] { smooth_normals<double, 3>(0.5, SerialLoop{}, smoothed, before); });
    works.emplace_back([&] { mix_in_covariance_normals<double, 3>(0.5, SerialLoop{}, mixed); });
    const auto times = median_times(works);
    const auto surface = static_cast<double>(std::count(
        exposed.surface_class.begin(), exposed.surface_class.end(), SurfaceClass::surface));
    const double scale = 1e9 / surface;
    for (std::size_t n = 0; n < all.size(); ++n)
        all[n].nanoseconds = times[n] * scale;
    return {times[all.size()] * scale, times[all.size() + 1] * scale};
}

void write_json(const std::vector<Timed>& all, const TimesAfter& after,
                const std::filesystem::path& file) {
    auto rows = nlohmann::json::array();
    for (const Timed& timed : all) {
        const auto errors = errors_of(timed.scheme, timed.samples, usual_radius);
        for (int passes = 0; passes <= most_passes; ++passes)
            rows.push_back({{"scheme", timed.scheme.name},
                            {"samples", timed.samples},
                            {"passes", passes},
                            {"nanoseconds", timed.nanoseconds + passes * after.smoothing},
                            {"degrees", errors[passes]}});
    }
    write_whole(file, rows.dump(1) + "\n");
}

void print_tau_table() {
    constexpr std::array<double, 5> shares = {0, 0.25, 0.5, 0.75, 1};
    fmt::print("\n**By tau: degrees after one / two passes, h = {:g} spacings**\n\n"
               "| normals | tau 0 | 0.25 | 0.5 | 0.75 | 1 |\n|---|---|---|---|---|---|\n",
               usual_radius);
    for (const auto& [name, samples] :
         {std::pair("random", 60), {"random", 240}, {"outward", 60}, {"outward", 240}}) {
        fmt::print("| {} {} |", name, samples);
        for (const double tau : shares) {
            const auto errors = errors_of(normal_scheme(name), samples, usual_radius, {tau, 0});
            fmt::print(" {:.2f} / {:.2f} |", errors[1], errors[2]);
        }
        fmt::print("\n");
    }
    fmt::print("| exact |");
    for (const double tau : shares) {
        const auto errors = errors_of(normal_scheme("exact"), 0, usual_radius, {tau, 0});
        fmt::print(" {:.2f} / {:.2f} |", errors[1], errors[2]);
    }
    fmt::print("\n");
}

void print_covariance_table() {
    fmt::print("\n**By share of normals from positions: degrees without / with one pass of tau "
               "0.5, h = {:g} spacings**\n\n| normals | share 0 | 0.5 | 1 |\n|---|---|---|---|\n",
               usual_radius);
    for (const auto& [name, samples] :
         {std::pair("random", 60), {"outward", 60}, {"outward", 240}, {"exact", 0}}) {
        fmt::print("| {}{} |", name, samples > 0 ? fmt::format(" {}", samples) : "");
        for (const double share : {0.0, 0.5, 1.0}) {
            const auto errors = errors_of(normal_scheme(name), samples, usual_radius, {0.5, share});
            fmt::print(" {:.2f} / {:.2f} |", errors[0], errors[1]);
        }
        fmt::print("\n");
    }
}

} // namespace

void print_scheme_tables() {
    for (const double radius : {2.0, 2.5}) {
        fmt::print("\n**Saddle, h = {:g} spacings: degrees after 0 / 1 / 2 passes of tau 0.5, "
                   "{} particles**\n\n",
                   radius, measured_count(saddles(radius)));
        print_header("directions");
        for (const NormalScheme& scheme : normal_schemes()) {
            fmt::print("| {} |", scheme.name);
            for (const std::size_t samples : sample_counts) {
                if (scheme.method == CoverageMethod::exact && samples != sample_counts[0]) {
                    fmt::print(" |");
                    continue;
                }
                const auto errors = errors_of(scheme, samples, radius);
                fmt::print(" {:.2f} / {:.2f} / {:.2f} |", errors[0], errors[1], errors[2]);
            }
            fmt::print("\n");
        }
    }
}

void print_smoothing_tables() {
    print_tau_table();
    print_covariance_table();
}

void print_time_table(const std::filesystem::path& json) {
    check_can_be_written(json);
    auto all = all_timed();
    const TimesAfter after = measure_times(saddles(usual_radius)[0], all);
    fmt::print("\n**Nanoseconds a surface particle, one thread, h = {:g} spacings**\n\n",
               usual_radius);
    print_header("directions");
    for (const Timed& timed : all) {
        if (timed.samples == sample_counts[0])
            fmt::print("{}| {} |", &timed == all.data() ? "" : "\n", timed.scheme.name);
        fmt::print(" {:.0f} |", timed.nanoseconds);
    }
    fmt::print(" | | | |\n\nA smoothing pass takes {:.0f} ns, the normals from positions {:.0f}.\n",
               after.smoothing, after.covariance);
    write_json(all, after, json);
}

} // namespace meniscus
