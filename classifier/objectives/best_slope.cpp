#include "detail/best_slope.hpp"

#include <meniscus/data/ranks/packing.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace meniscus {
namespace {

// Slopes of 2^-40 to 2^24; what lies beyond is in the first bin or the last.
constexpr int min_exponent = -40;
constexpr int max_exponent = 24;

// Between events closer than this, rounding decides which particles are told apart.
constexpr double narrowest = 1e-10;

constexpr std::uint64_t max_sorted = std::uint64_t{1} << 28; ///< events, 16 bytes each

/// Digits of a mantissa that bins tell apart, so that there are fewer bins than particles, and few
/// particles in one.
int digits_for(std::uint64_t particles) {
    int digits = 2;
    while (digits < 12 && std::uint64_t{1} << (digits + 14) < particles)
        ++digits;
    return digits;
}

/// What the events of each bin add up to. A bin is an exponent and the first digits of a mantissa,
/// so that bins are in the order of slopes whatever the rounding.
struct Bins {
    int digits;
    std::size_t count = std::size_t{max_exponent - min_exponent} << digits;
    std::vector<std::uint64_t> begun = std::vector<std::uint64_t>(count);  ///< weight
    std::vector<std::uint64_t> ceased = std::vector<std::uint64_t>(count); ///< weight
    std::vector<std::uint64_t> events = std::vector<std::uint64_t>(count);
    std::vector<double> first = std::vector<double>(count, std::numeric_limits<double>::infinity());
    std::vector<double> last = std::vector<double>(count, 0);

    explicit Bins(int its_digits) : digits(its_digits) {}

    [[nodiscard]] std::size_t bin_of(double k) const {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &k, sizeof bits);
        const auto place = static_cast<std::int64_t>(bits >> (52 - digits)) -
                           (std::int64_t{1023 + min_exponent} << digits);
        return static_cast<std::size_t>(
            std::clamp<std::int64_t>(place, 0, static_cast<std::int64_t>(count) - 1));
    }

    void add(const SlopeEvent& event) {
        const std::size_t bin = bin_of(event.k);
        const auto weight = static_cast<std::uint64_t>(std::abs(event.weight));
        (event.weight > 0 ? begun : ceased)[bin] += weight;
        ++events[bin];
        first[bin] = std::min(first[bin], event.k);
        last[bin] = std::max(last[bin], event.k);
    }

    void add_up(Ranks& ranks) {
        for (auto* counts : {&begun, &ceased, &events})
            ranks.sum(*counts);
        ranks.min(first);
        ranks.max(last);
    }

    [[nodiscard]] std::int64_t begun_in(std::size_t bin) const {
        return static_cast<std::int64_t>(begun[bin]);
    }
    [[nodiscard]] std::int64_t change(std::size_t bin) const {
        return begun_in(bin) - static_cast<std::int64_t>(ceased[bin]);
    }
};

/// Goes through intervals of slopes in ascending order and keeps the best.
class Sweep {
public:
    Sweep(std::int64_t weight_at_zero, double slope_unit)
        : weight(weight_at_zero), unit(slope_unit) {}

    SlopeChoice best;
    std::int64_t weight; ///< from the last event on

    /// The interval up to `k`, at which the weight changes.
    void go_to(double k, std::int64_t change) {
        const double end = std::atan(k / unit);
        const double width = end - begin;
        if (width > narrowest &&
            (weight > best.weight || (weight == best.weight && width > best.width)))
            best = {weight, begin, width};
        begin = end;
        weight += change;
    }

    /// Passes over what lies between slopes of a bin that cannot hold the best.
    void pass_over(const Bins& bins, std::size_t bin) {
        go_to(bins.first[bin], 0);
        begin = std::atan(bins.last[bin] / unit);
        weight += bins.change(bin);
    }

private:
    double unit;
    double begin = 0; ///< angle of the last event
};

/// The bins that may hold a weight as large as the best one between bins.
std::vector<std::size_t> bins_to_sort(const Bins& bins, std::int64_t weight_at_zero,
                                      double max_slope, double unit) {
    Sweep between(weight_at_zero, unit);
    for (std::size_t bin = 0; bin < bins.count; ++bin)
        if (bins.events[bin] > 0)
            between.pass_over(bins, bin);
    between.go_to(max_slope, 0);
    std::vector<std::size_t> chosen;
    std::int64_t weight = weight_at_zero;
    std::uint64_t events = 0;
    for (std::size_t bin = 0; bin < bins.count; ++bin) {
        if (bins.events[bin] > 1 && weight + bins.begun_in(bin) >= between.best.weight) {
            chosen.push_back(bin);
            events += bins.events[bin];
        }
        weight += bins.change(bin);
    }
    if (events > max_sorted)
        throw FailureError("training: " + std::to_string(events) +
                           " particles lie so close to the line that they would have to be sorted "
                           "in memory, more than " +
                           std::to_string(max_sorted) + "; train on fewer files");
    return chosen;
}

/// The events of all ranks that fall into chosen bins, sorted.
std::vector<SlopeEvent> events_in(const std::vector<std::size_t>& chosen, const Bins& bins,
                                  const VisitEvents& visit_events, Ranks& ranks) {
    std::vector<char> is_chosen(bins.count);
    for (const std::size_t bin : chosen)
        is_chosen[bin] = 1;
    std::vector<SlopeEvent> events;
    visit_events([&](const SlopeEvent& event) {
        if (is_chosen[bins.bin_of(event.k)] != 0)
            events.push_back(event);
    });
    if (ranks.size() > 1) {
        std::string bytes(reinterpret_cast<const char*>(events.data()),
                          events.size() * sizeof(SlopeEvent));
        events.clear();
        for (const std::string& some : gather(ranks, bytes)) {
            const std::size_t before = events.size();
            events.resize(before + some.size() / sizeof(SlopeEvent));
            if (!some.empty())
                std::memcpy(static_cast<void*>(&events[before]), some.data(), some.size());
        }
    }
    std::sort(events.begin(), events.end(),
              [](const SlopeEvent& a, const SlopeEvent& b) { return a.k < b.k; });
    return events;
}

} // namespace

SlopeChoice best_slope(const VisitEvents& visit_events, std::uint64_t particles, double max_slope,
                       double slope_unit, Ranks& ranks) {
    Bins bins(digits_for(particles));
    std::vector<std::uint64_t> at_zero = {static_cast<std::uint64_t>(
        visit_events([&](const SlopeEvent& event) { bins.add(event); }))};
    ranks.sum(at_zero);
    bins.add_up(ranks);
    const auto weight_at_zero = static_cast<std::int64_t>(at_zero[0]);
    const auto chosen = bins_to_sort(bins, weight_at_zero, max_slope, slope_unit);
    const auto events = events_in(chosen, bins, visit_events, ranks);
    Sweep sweep(weight_at_zero, slope_unit);
    auto next_chosen = chosen.begin();
    auto event = events.begin();
    for (std::size_t bin = 0; bin < bins.count; ++bin) {
        if (bins.events[bin] == 0)
            continue;
        if (next_chosen == chosen.end() || *next_chosen != bin) {
            sweep.pass_over(bins, bin);
            continue;
        }
        ++next_chosen;
        for (; event != events.end() && bins.bin_of(event->k) == bin; ++event)
            sweep.go_to(event->k, event->weight);
    }
    sweep.go_to(max_slope, 0);
    return sweep.best;
}

} // namespace meniscus
