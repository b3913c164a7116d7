// Normals on a saddle as in the 2020 article: errors and times by sampling scheme, number of
// samples and smoothing, and by the share of normals from positions.
#include "normal_schemes.hpp"
#include "support/tables.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>

namespace meniscus {
namespace {

constexpr std::array<std::size_t, 5> sample_counts = {30, 60, 120, 240, 360};
constexpr std::size_t clouds = 8;
constexpr int max_passes = 2;
constexpr double usual_radius = 2; // h in spacings

using List = SurfaceParticles<double, 3>;

const std::vector<NormalCase>& saddles(double radius_in_spacings) {
    static std::map<double, std::vector<NormalCase>> made;
    auto& cases = made[radius_in_spacings];
    for (std::size_t seed = cases.size(); seed < clouds; ++seed)
        cases.push_back(saddle_case(radius_in_spacings, seed));
    return cases;
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

using PassErrors = std::array<double, max_passes + 1>;

/// Mean angle in degrees after no smoothing pass, one and two, over all clouds.
PassErrors errors_of(const NormalScheme& scheme, std::size_t samples, double radius_in_spacings,
                     const Smoothing& smoothing = {}) {
    std::array<Spread, max_passes + 1> errors;
    List list;
    std::vector<List::Vector> before;
    SampleDirections directions;
    const auto& cases = saddles(radius_in_spacings);
    for (std::size_t seed = 0; seed < cases.size(); ++seed) {
        scheme.fill(samples, seed, directions);
        scheme.expose(cases[seed], seed, directions, list);
        if (smoothing.covariance_share > 0)
            mix_in_covariance_normals<double, 3>(smoothing.covariance_share, SerialLoop{}, list);
        for (int pass = 0; pass <= max_passes; ++pass) {
            if (pass > 0)
                smooth_normals<double, 3>(smoothing.tau, SerialLoop{}, list, before);
            errors[pass].add(angular_error<3>(cases[seed], list));
        }
    }
    return {errors[0].mean(), errors[1].mean(), errors[2].mean()};
}

bool is_exact(const NormalScheme& scheme) {
    return scheme.method == CoverageMethod::exact;
}

/// A row a scheme; without directions only in the first column.
template <class CellFor>
void add_schemes(const CellFor& cell_for, Table& table) {
    for (const NormalScheme& scheme : normal_schemes()) {
        table.add({scheme.name});
        for (const std::size_t samples : sample_counts)
            table.rows.back().push_back(is_exact(scheme) && samples != sample_counts[0]
                                            ? Cell("")
                                            : cell_for(scheme, samples));
    }
}

std::string sample_columns(const std::string& format) {
    std::string columns = "directions";
    for (const std::size_t samples : sample_counts)
        columns += " | " + std::to_string(samples) + " " + format;
    return columns;
}

Tables scheme_tables(const TableInput&) {
    Tables tables;
    for (const double radius : {2.0, 2.5}) {
        tables.push_back(titled_table(
            fmt::format("schemes_{:g}", radius),
            fmt::format("Saddle, h = {:g} spacings: degrees after 0 / 1 / 2 passes of tau 0.5, {} "
                        "particles",
                        radius, measured_count(saddles(radius))),
            sample_columns("{:.2f}")));
        add_schemes(
            [&](const NormalScheme& scheme, std::size_t samples) {
                const auto errors = errors_of(scheme, samples, radius);
                return Cell(Figures(errors.begin(), errors.end()));
            },
            tables.back());
    }
    return tables;
}

/// A scheme with a number of samples; directions ready.
struct TimedScheme {
    const NormalScheme* scheme;
    std::size_t samples;
    SampleDirections directions;
};

/// One for each scheme and number of samples; one alone for the exact scheme.
std::vector<TimedScheme> all_timed() {
    std::vector<TimedScheme> all;
    for (const NormalScheme& scheme : normal_schemes())
        for (const std::size_t samples : sample_counts) {
            if (is_exact(scheme) && samples != sample_counts[0])
                continue;
            all.push_back({&scheme, samples, {}});
            scheme.fill(samples, 0, all.back().directions);
        }
    return all;
}

Tables time_tables(const TableInput& input) {
    const NormalCase& some = saddles(usual_radius)[0];
    auto all = all_timed();
    List list;
    List exposed;
    std::vector<List::Vector> before;
    normal_scheme("exact").expose(some, 0, all[0].directions, exposed);
    List smoothed = exposed;
    List mixed = exposed;
    std::vector<Timed> timed;
    for (TimedScheme& one : all)
        timed.push_back({[&] { one.scheme->expose(some, 0, one.directions, list); }});
    timed.push_back({[&] { smooth_normals<double, 3>(0.5, SerialLoop{}, smoothed, before); }});
    timed.push_back({[&] { mix_in_covariance_normals<double, 3>(0.5, SerialLoop{}, mixed); }});
    const auto times = measure(timed, input.timing);
    const auto surface = static_cast<std::size_t>(std::count(
        exposed.surface_class.begin(), exposed.surface_class.end(), SurfaceClass::surface));
    const auto time_of = [&](std::size_t k) {
        return per_particle(times[k], 1e-9, surface).median;
    };
    Table table = titled_table(
        "times",
        fmt::format("Nanoseconds a surface particle, one thread, h = {:g} spacings", usual_radius),
        sample_columns("{:.0f}"));
    std::size_t next = 0;
    add_schemes([&](const NormalScheme&, std::size_t) { return Cell(time_of(next++)); }, table);
    table.add({"a smoothing pass", time_of(next), "", "", "", ""});
    table.add({"normals from positions", time_of(next + 1), "", "", "", ""});
    return {table};
}

/// A scheme of the smoothing tables; 0 samples: exact.
struct Smoothed {
    const char* scheme;
    std::size_t samples;

    [[nodiscard]] std::string name() const {
        return samples > 0 ? fmt::format("{} {}", scheme, samples) : scheme;
    }
    [[nodiscard]] PassErrors errors(const Smoothing& smoothing) const {
        return errors_of(normal_scheme(scheme), samples, usual_radius, smoothing);
    }
};

Table tau_table() {
    Table table = titled_table(
        "tau",
        fmt::format("By tau: degrees after one / two passes, h = {:g} spacings", usual_radius),
        "normals | tau 0 {:.2f} | 0.25 {:.2f} | 0.5 {:.2f} | 0.75 {:.2f} | 1 {:.2f}");
    for (const Smoothed& one :
         {Smoothed{"random", 60}, Smoothed{"random", 240}, Smoothed{"outward", 60},
          Smoothed{"outward", 240}, Smoothed{"exact", 0}}) {
        table.add({one.name()});
        for (const double tau : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const auto errors = one.errors({tau, 0});
            table.rows.back().emplace_back(Figures{errors[1], errors[2]});
        }
    }
    return table;
}

Table covariance_table() {
    Table table = titled_table(
        "covariance",
        fmt::format("By share of normals from positions: degrees without / with one pass of tau "
                    "0.5, h = {:g} spacings",
                    usual_radius),
        "normals | share 0 {:.2f} | 0.5 {:.2f} | 1 {:.2f}");
    for (const Smoothed& one : {Smoothed{"random", 60}, Smoothed{"outward", 60},
                                Smoothed{"outward", 240}, Smoothed{"exact", 0}}) {
        table.add({one.name()});
        for (const double share : {0.0, 0.5, 1.0}) {
            const auto errors = one.errors({0.5, share});
            table.rows.back().emplace_back(Figures{errors[0], errors[1]});
        }
    }
    return table;
}

Tables smoothing_tables(const TableInput&) {
    return {tau_table(), covariance_table()};
}

} // namespace

TableGroup normal_saddle_tables() {
    return {"Normals",
            {{"normals-schemes", "", 0, "on a saddle, by scheme and samples", scheme_tables},
             {"normals-smoothing", "", 0, "on a saddle, by smoothing", smoothing_tables},
             {"normals-time", "", 0, "time of the schemes and of smoothing", time_tables}}};
}

} // namespace meniscus
