#include "state_in_slabs.hpp"

#include "detail/slab_plan.hpp"
#include "detail/slab_records.hpp"
#include "process_memory.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/scratch_streams.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t loaded_at_once = 1 << 20;

/// Calls visit with each of the numbers that a file holds.
void visit_numbers(const ScratchFile& file, const std::function<void(double)>& visit) {
    std::vector<double> some(std::size_t{1} << 16);
    for (std::uint64_t place = 0; place < file.size(); place += some.size() * sizeof(double)) {
        some.resize(std::min<std::uint64_t>(some.size(), (file.size() - place) / sizeof(double)));
        file.read(place, some.data(), some.size() * sizeof(double));
        for (const double number : some)
            visit(number);
    }
}

/// Faults and extent of parts become those of the whole.
void reduce(Ranks& ranks, PositionFaults& faults, ParticleExtent& extent) {
    std::vector<std::uint64_t> counts = {faults.particles, faults.not_finite.count,
                                         faults.too_far.count, extent.count};
    ranks.sum(counts);
    const auto first_of = [](const ParticlesAtFault& at_fault) {
        return at_fault.count > 0 ? static_cast<double>(at_fault.first) : infinity;
    };
    std::vector<double> lowest = {first_of(faults.not_finite), first_of(faults.too_far),
                                  extent.low[0], extent.low[1], extent.low[2]};
    ranks.min(lowest);
    std::vector<double> highest = {extent.high[0], extent.high[1], extent.high[2],
                                   faults.coarsest_step};
    ranks.max(highest);
    std::vector<double> coarsest = {
        faults.coarsest_step == highest[3] ? static_cast<double>(faults.coarsest) : infinity};
    ranks.min(coarsest);
    const auto number = [](double place) {
        return std::isfinite(place) ? static_cast<std::uint64_t>(place) : std::uint64_t{0};
    };
    faults.particles = counts[0];
    faults.not_finite = {counts[1], number(lowest[0])};
    faults.too_far = {counts[2], number(lowest[1])};
    extent.count = counts[3];
    for (std::size_t a = 0; a < 3; ++a) {
        extent.low[a] = lowest[2 + a];
        extent.high[a] = highest[a];
    }
    faults.coarsest_step = highest[3];
    faults.coarsest = number(coarsest[0]);
}

} // namespace

struct StateInSlabs::Work {
    const RowsOfState& state;
    SlabOptions options;
    Ranks& ranks;
    double radius;
    std::vector<std::string> arrays;
    std::uint64_t rows_at_once = 0;
    std::uint64_t budget = 0; ///< bytes for a slab
    ParticleExtent extent;
    GridLayout layout;
    int axis = 0;
    std::optional<ScratchFile> kept; ///< records of this rank's rows
    std::vector<Slab> plan;
    int halo_layers = 1;
    /// Of each slab of this rank, what each rank had for it, in their order: that of the file.
    std::optional<ScratchStreams> particles;
    std::uint64_t halo = 0;
    std::uint64_t sent = 0;

    Work(const RowsOfState& state, const std::vector<std::string>& wanted,
         const SlabOptions& options, Ranks& ranks)
        : state(state), options(options), ranks(ranks), radius(state.frame.support_radius.value()) {
        for (const std::string& name : wanted)
            if (find_array(state.frame, name) != nullptr)
                arrays.push_back(name);
        set_budget();
    }

    void set_budget() {
        constexpr std::uint64_t min_rows = 1 << 13;
        constexpr std::uint64_t max_rows = 1 << 20;
        const std::uint64_t used = resident_memory() + more_program +
                                   state.frame.boundary.size() * bytes_a_boundary_particle;
        std::vector<double> least = {
            options.memory > used ? static_cast<double>(options.memory - used) : 0};
        ranks.min(least); // all plan the same
        const auto left = static_cast<std::uint64_t>(least[0]);
        // A block of rows is there several times over: as it is read, sorted, sent and received;
        // but no slab at that time.
        const std::uint64_t row = 7 * (32 + 8 * arrays.size());
        rows_at_once = std::clamp(left / 2 / row, min_rows, max_rows);
        budget = left - std::min(left / 8, more_buffers);
    }

    /// What the program comes to take itself while it works.
    static constexpr std::uint64_t more_program = std::uint64_t{10} << 20;

    /// For what goes to files and other ranks while a slab is there.
    static constexpr std::uint64_t more_buffers = std::uint64_t{4} << 20;

    static constexpr std::uint64_t bytes_a_boundary_particle = 24 + 24 + 8 + 4 + 8 + 8;

    [[nodiscard]] std::size_t record_bytes() const { return 8 * (record_words + arrays.size()); }

    /// Calls visit(first, count) with the blocks of this rank's share of `count_of_all` things, and
    /// after_each() as often on every rank.
    template <class Visit, class AfterEach>
    void for_blocks(std::uint64_t begin, std::uint64_t end, std::uint64_t at_once,
                    const Visit& visit, const AfterEach& after_each) {
        std::vector<double> rounds = {
            std::ceil(static_cast<double>(end - begin) / static_cast<double>(at_once))};
        ranks.max(rounds);
        const auto most = static_cast<std::uint64_t>(rounds[0]);
        for (std::uint64_t round = 0; round < most; ++round) {
            do_together(ranks, [&] {
                if (begin < end)
                    visit(begin, std::min(at_once, end - begin));
            });
            begin = std::min(begin + at_once, end);
            after_each();
        }
    }

    /// The same with blocks of the records that were kept.
    template <class Visit, class AfterEach>
    void for_kept(const Visit& visit, const AfterEach& after_each) {
        const std::size_t record = record_bytes();
        std::string records;
        for_blocks(
            0, kept->size() / record, rows_at_once,
            [&](std::uint64_t first, std::uint64_t count) {
                records.resize(count * record);
                kept->read(first * record, records.data(), records.size());
                for (std::size_t at = 0; at < records.size(); at += record)
                    visit(std::string_view(records).substr(at, record));
            },
            after_each);
    }

    void plan_for(const SlabNeeds& needs) {
        LayerCounts counts(layout);
        axis = counts.axis;
        for_kept([&](std::string_view record) { counts.add(position_of(record)); }, [] {});
        ranks.sum(counts.bins);
        plan = plan_slabs(counts, needs, budget, ranks.size());
        halo_layers = needs.halo_layers;
    }

    /// Slabs that follow on each other belong to one rank, so that few particles go to another
    /// where the file is in the order of space.
    [[nodiscard]] std::size_t first_slab_of(int rank) const {
        return static_cast<std::size_t>(first_of_share(plan.size(), rank, ranks.size()));
    }

    [[nodiscard]] std::size_t own_slabs() const {
        return first_slab_of(ranks.rank() + 1) - first_slab_of(ranks.rank());
    }

    /// The slab that a layer belongs to.
    [[nodiscard]] std::size_t slab_of(std::int64_t layer) const {
        const auto after =
            std::upper_bound(plan.begin(), plan.end(), layer,
                             [](std::int64_t one, const Slab& slab) { return one < slab.first; });
        return static_cast<std::size_t>(after - plan.begin()) - 1;
    }

    /// Calls visit(slab) with each slab that a layer is in or beside.
    template <class Visit>
    void for_slabs_of(std::int64_t layer, const Visit& visit) const {
        const std::size_t own = slab_of(layer);
        visit(own);
        for (std::size_t s = own; s > 0 && layer < plan[s - 1].end + halo_layers; --s)
            visit(s - 1);
        for (std::size_t s = own + 1; s < plan.size() && layer >= plan[s].first - halo_layers; ++s)
            visit(s);
    }

    void hand_to_slabs() {
        const auto size = static_cast<std::size_t>(ranks.size());
        do_together(ranks, [&] {
            particles.reset(); // gives its place on the disk back
            particles.emplace(options.scratch, own_slabs() * size);
        });
        std::vector<std::string> records(plan.size());
        for_kept(
            [&](std::string_view record) {
                for_slabs_of(layer_of(layout, position_of(record), axis),
                             [&](std::size_t slab) { records[slab].append(record); });
            },
            [&] { hand_out(records); });
    }

    /// Sends records to the ranks whose slabs they are for.
    void hand_out(std::vector<std::string>& records) {
        std::vector<std::string> for_rank(static_cast<std::size_t>(ranks.size()));
        for (int rank = 0; rank < ranks.size(); ++rank)
            for (std::size_t slab = first_slab_of(rank); slab < first_slab_of(rank + 1); ++slab) {
                append_part(slab, records[slab], for_rank[static_cast<std::size_t>(rank)]);
                records[slab].clear();
            }
        for (int rank = 0; rank < ranks.size(); ++rank)
            if (rank != ranks.rank())
                sent += for_rank[static_cast<std::size_t>(rank)].size();
        const auto received = ranks.exchange(std::move(for_rank));
        const std::size_t first = first_slab_of(ranks.rank());
        do_together(ranks, [&] {
            for (std::size_t source = 0; source < received.size(); ++source)
                visit_parts(received[source], [&](std::size_t slab, std::string_view bytes) {
                    particles->append((slab - first) * received.size() + source, bytes);
                });
        });
    }

    /// A slab of this rank.
    [[nodiscard]] Snapshot load(std::size_t own, PartOfState& part) const {
        const Slab& layers = plan[first_slab_of(ranks.rank()) + own];
        const auto size = static_cast<std::size_t>(ranks.size());
        std::uint64_t bytes = 0;
        for (std::size_t source = 0; source < size; ++source)
            bytes += particles->size(own * size + source);
        Snapshot slab = empty_slab(arrays, bytes / record_bytes());
        slab.dimension = state.frame.dimension;
        slab.position_precision = state.frame.position_precision;
        slab.support_radius = radius;
        part.layout = layout;
        part.numbers.resize(slab.size());
        part.own.resize(slab.size());
        std::size_t i = 0;
        const auto add = [&](std::string_view records) {
            for (std::size_t at = 0; at < records.size(); at += record_bytes(), ++i) {
                read_record(records.data() + at, i, slab, part.numbers[i]);
                const std::int64_t layer = layer_of(layout, slab.positions[i], axis);
                part.own[i] = layer >= layers.first && layer < layers.end ? 1 : 0;
            }
        };
        for (std::size_t source = 0; source < size; ++source)
            particles->visit(own * size + source, record_bytes(), loaded_at_once, add);
        return slab;
    }
};

StateInSlabs::StateInSlabs(const RowsOfState& state, const std::vector<std::string>& arrays,
                           const SlabOptions& options, Ranks& ranks)
    : work(std::make_unique<Work>(state, arrays, options, ranks)) {}

StateInSlabs::~StateInSlabs() = default;

std::string StateInSlabs::read(bool skip_invalid,
                               const std::function<void(const Snapshot&)>& visit) {
    Work& w = *work;
    do_together(w.ranks, [&] { w.kept.emplace(w.options.scratch); });
    PositionFaults faults;
    const std::uint64_t size = w.state.size;
    w.for_blocks(
        first_of_share(size, w.ranks.rank(), w.ranks.size()),
        first_of_share(size, w.ranks.rank() + 1, w.ranks.size()), w.rows_at_once,
        [&](std::uint64_t first, std::uint64_t count) {
            const Snapshot rows = w.state.read(first, count, w.arrays);
            const auto valid = usable_positions(rows, w.radius, faults);
            const RecordWriter writer(rows, valid, w.arrays);
            std::string records;
            for (std::size_t i = 0; i < rows.size(); ++i)
                if (valid[i] != 0) {
                    w.extent.add(rows.positions[i]);
                    writer.add(i, records);
                }
            w.kept->append(records.data(), records.size());
            if (visit)
                visit(rows);
        },
        [] {});
    reduce(w.ranks, faults, w.extent);
    if (!skip_invalid)
        refuse_faults(w.state.frame, faults);
    w.layout = grid_layout(w.radius, w.extent);
    return doubt_of(w.state.frame, faults);
}

void StateInSlabs::sort(const SlabNeeds& needs) {
    work->plan.clear();
    if (work->extent.count > 0)
        work->plan_for(needs);
    work->hand_to_slabs();
}

void StateInSlabs::for_slabs(
    const std::function<void(const Snapshot& particles, PartOfState& part)>& visit) {
    Work& w = *work;
    w.halo = 0;
    do_together(w.ranks, [&] {
        for (std::size_t own = 0; own < w.own_slabs(); ++own) {
            PartOfState part;
            const Snapshot particles = w.load(own, part);
            part.is_first = w.first_slab_of(w.ranks.rank()) + own == 0;
            w.halo += static_cast<std::uint64_t>(
                std::count(part.own.begin(), part.own.end(), std::uint8_t{0}));
            visit(particles, part);
        }
    });
}

std::optional<double> StateInSlabs::ratio_of_sums(const ScratchFile& sums) const {
    std::vector<std::uint64_t> count = {sums.size() / sizeof(double)};
    work->ranks.sum(count);
    if (count[0] == 0)
        return {};
    const double quartile =
        nth_of_all(work->ranks, quartile_place(count[0]),
                   [&](const std::function<void(double)>& visit) { visit_numbers(sums, visit); });
    return spacing_ratio_of_sum(quartile, work->state.frame, work->radius);
}

double StateInSlabs::measured_spacing_ratio(int threads) {
    for (const bool without_crowds : {true, false}) {
        std::optional<ScratchFile> sums;
        do_together(work->ranks, [&] { sums.emplace(work->options.scratch); });
        for_slabs([&](const Snapshot& particles, PartOfState& part) {
            const NeighborGrid grid(particles.positions, part.layout, {}, threads);
            auto all =
                kernel_sums(grid, work->radius, particles.dimension, threads, without_crowds);
            std::size_t kept = 0;
            for (std::size_t place = 0; place < all.size(); ++place)
                if (part.own[grid.particle(place)] != 0 && !std::isnan(all[place]))
                    all[kept++] = all[place];
            sums->append(all.data(), kept * sizeof(double));
        });
        if (const auto ratio = ratio_of_sums(*sums))
            return *ratio;
    }
    return 1;
}

std::uint64_t StateInSlabs::slabs() const {
    return work->plan.size();
}

std::uint64_t StateInSlabs::halo() const {
    return work->halo;
}

std::uint64_t StateInSlabs::bytes_sent() const {
    return work->sent;
}

Ranks& StateInSlabs::ranks() const {
    return work->ranks;
}

const RowsOfState& StateInSlabs::state() const {
    return work->state;
}

std::uint64_t StateInSlabs::array_bytes() const {
    return work->arrays.size() * (8 + 8 + 8);
}

} // namespace meniscus
