#include "label_in_slabs.hpp"

#include "detail/slab_plan.hpp"
#include "detail/slab_scratch.hpp"

#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/threads/threads.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <unistd.h>

namespace meniscus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

/// The work on one state, as one rank does its share.
class SlabWork {
public:
    SlabWork(const RowsOfState& state, const LabelOptions& options, const SlabOptions& slabs,
             Ranks& ranks)
        : state(state), options(options), slab_options(slabs), ranks(ranks),
          radius(state.frame.support_radius.value()),
          labels(slabs.scratch, options.features.size()) {
        for (const char* name : {"mass", "phase", "id"})
            if (find_array(state.frame, name) != nullptr &&
                (name != std::string("id") || options.method == LabelMethod::monte_carlo))
                arrays.emplace_back(name);
        set_budget();
    }

    LabelsInFile run() {
        look_at_positions();
        layout = grid_layout(radius, extent);
        if (extent.count > 0)
            plan();
        sort_into_slabs();
        measure_spacing();
        label_slabs();
        put_back();
        labels.slabs = plan_of_all.size();
        labels.bytes_exchanged = exchanged;
        return std::move(labels);
    }

private:
    const RowsOfState& state;
    const LabelOptions& options;
    const SlabOptions& slab_options;
    Ranks& ranks;
    double radius;
    std::vector<std::string> arrays; ///< that decide on labels
    std::uint64_t rows_at_once = 0;
    std::uint64_t budget = 0; ///< bytes for a slab
    ParticleExtent extent;
    GridLayout layout;
    int axis = 0;
    std::vector<Slab> plan_of_all;
    std::vector<SlabScratch> own_slabs; ///< of this rank: numbers rank, rank + ranks, ...
    LabelsInFile labels;
    std::uint64_t exchanged = 0;

    void set_budget() {
        constexpr std::uint64_t min_rows = 1 << 13;
        constexpr std::uint64_t max_rows = 1 << 20;
        const std::uint64_t used = resident_memory() + more_program +
                                   state.frame.boundary.size() * bytes_a_boundary_particle;
        std::vector<double> least = {
            slab_options.memory > used ? static_cast<double>(slab_options.memory - used) : 0};
        ranks.min(least); // all plan the same
        const auto left = static_cast<std::uint64_t>(least[0]);
        // A block of rows is there several times over: as it is read, sorted, sent and received.
        const std::uint64_t row = 10 * (32 + 8 * arrays.size());
        rows_at_once = std::clamp(left / 4 / row, min_rows, max_rows);
        budget = left - std::min(left, rows_at_once * row);
    }

    /// What the program comes to take itself while it works.
    static constexpr std::uint64_t more_program = std::uint64_t{10} << 20;

    static constexpr std::uint64_t bytes_a_boundary_particle = 24 + 24 + 8 + 4 + 8 + 8;

    /// Bytes a particle takes while its slab is labelled; docs/labels.md says how they add up.
    [[nodiscard]] SlabCost cost() const {
        const std::uint64_t values = arrays.size() * (8 + 8 + 8);
        const std::uint64_t label = 8 + 8 + 8 + 8 * options.features.size() + 3;
        return {24 + 24 + 8 + 8 + 4 + 8 + 2 + 8 + values + label, 8};
    }

    /// Calls visit(rows) with the blocks of this rank, which are every so many of all, and
    /// after_each() after each one, as often on every rank.
    template <class Visit, class AfterEach>
    void for_blocks(const Visit& visit, const AfterEach& after_each) {
        const auto size = static_cast<std::uint64_t>(ranks.size());
        const auto rank = static_cast<std::uint64_t>(ranks.rank());
        for (std::uint64_t round = 0; round * size * rows_at_once < state.size; ++round) {
            const std::uint64_t first = (round * size + rank) * rows_at_once;
            const std::uint64_t count =
                first < state.size ? std::min(rows_at_once, state.size - first) : 0;
            do_together(ranks, [&] {
                if (count > 0)
                    visit(first, count);
            });
            after_each();
        }
    }

    /// The valid particles' extent, once all of them are known to be of use.
    void look_at_positions() {
        PositionFaults faults;
        for_blocks(
            [&](std::uint64_t first, std::uint64_t count) {
                const Snapshot rows = state.read(first, count, arrays);
                const auto valid = usable_positions(rows, radius, faults);
                checked_masses(rows, valid);
                for (const char* name : {"phase", "id"})
                    integer_values(rows, name, valid);
                for (std::size_t i = 0; i < rows.size(); ++i)
                    if (valid[i] != 0)
                        extent.add(rows.positions[i]);
            },
            [] {});
        reduce(faults);
        if (!options.skip_invalid)
            refuse_faults(state.frame, faults);
        if (std::string doubt = doubt_of(state.frame, faults); !doubt.empty())
            labels.warnings.push_back(std::move(doubt));
    }

    void reduce(PositionFaults& faults) {
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

    /// Positions of valid particles, and what goes with them, block by block.
    template <class Visit, class AfterEach>
    void for_valid(const Visit& visit, const AfterEach& after_each,
                   const std::vector<std::string>& with) {
        PositionFaults known; // by now
        for_blocks(
            [&](std::uint64_t first, std::uint64_t count) {
                const Snapshot rows = state.read(first, count, with);
                const auto valid = usable_positions(rows, radius, known);
                visit(rows, valid);
            },
            after_each);
    }

    void plan() {
        LayerCounts counts(layout);
        axis = counts.axis;
        for_valid(
            [&](const Snapshot& rows, const std::vector<std::uint8_t>& valid) {
                for (std::size_t i = 0; i < rows.size(); ++i)
                    if (valid[i] != 0)
                        counts.add(rows.positions[i]);
            },
            [] {}, {});
        ranks.sum(counts.bins);
        plan_of_all = plan_slabs(counts, cost(), budget, ranks.size());
    }

    [[nodiscard]] int owner(std::size_t slab) const {
        return static_cast<int>(slab % static_cast<std::size_t>(ranks.size()));
    }

    /// The slab that a layer belongs to.
    [[nodiscard]] std::size_t slab_of(std::int64_t layer) const {
        const auto after =
            std::upper_bound(plan_of_all.begin(), plan_of_all.end(), layer,
                             [](std::int64_t one, const Slab& slab) { return one < slab.first; });
        return static_cast<std::size_t>(after - plan_of_all.begin()) - 1;
    }

    void sort_into_slabs() {
        for (std::size_t slab = 0; slab < plan_of_all.size(); ++slab)
            if (owner(slab) == ranks.rank())
                own_slabs.emplace_back(plan_of_all[slab], slab, arrays, slab_options.scratch);
        std::vector<std::string> records(plan_of_all.size());
        for_valid(
            [&](const Snapshot& rows, const std::vector<std::uint8_t>& valid) {
                const RecordWriter writer(rows, valid, arrays);
                for (std::size_t i = 0; i < rows.size(); ++i) {
                    if (valid[i] == 0)
                        continue;
                    const std::int64_t layer = layer_of(layout, rows.positions[i], axis);
                    const std::size_t own = slab_of(layer);
                    writer.add(i, layer, records[own]);
                    if (own > 0 && layer == plan_of_all[own].first)
                        writer.add(i, layer, records[own - 1]);
                    if (own + 1 < plan_of_all.size() && layer + 1 == plan_of_all[own].end)
                        writer.add(i, layer, records[own + 1]);
                }
            },
            [&] { hand_out(records); }, arrays);
    }

    /// Sends records to the ranks whose slabs they are for. In each round the ranks have blocks
    /// that follow on each other, so that slabs get their particles in the order of the file.
    void hand_out(std::vector<std::string>& records) {
        std::vector<std::string> for_rank(static_cast<std::size_t>(ranks.size()));
        for (std::size_t slab = 0; slab < records.size(); ++slab) {
            append_part(slab, records[slab], for_rank[static_cast<std::size_t>(owner(slab))]);
            records[slab].clear();
        }
        count_exchanged(for_rank);
        const auto received = ranks.exchange(std::move(for_rank));
        do_together(ranks, [&] {
            for (const std::string& parts : received)
                visit_parts(parts, [&](std::size_t slab, std::string_view bytes) {
                    own_slabs[slab / static_cast<std::size_t>(ranks.size())].append(bytes);
                });
        });
    }

    void count_exchanged(const std::vector<std::string>& for_rank) {
        for (std::size_t r = 0; r < for_rank.size(); ++r)
            if (r != static_cast<std::size_t>(ranks.rank()))
                exchanged += for_rank[r].size();
    }

    [[nodiscard]] Snapshot load(const SlabScratch& slab, StatePart& part) const {
        Snapshot particles = slab.load(part);
        particles.dimension = state.frame.dimension;
        particles.position_precision = state.frame.position_precision;
        particles.support_radius = radius;
        part.layout = layout;
        part.spacing_ratio = labels.spacing_ratio;
        return particles;
    }

    void measure_spacing() {
        if (const auto stored = stored_spacing_ratio(state.frame, radius)) {
            labels.spacing_ratio = *stored;
            return;
        }
        for (const bool without_crowds : {true, false}) {
            ScratchFile sums(slab_options.scratch);
            do_together(ranks, [&] { store_kernel_sums(without_crowds, sums); });
            std::vector<std::uint64_t> count = {sums.size() / sizeof(double)};
            ranks.sum(count);
            if (count[0] == 0)
                continue;
            const double quartile = nth_of_all(
                ranks, quartile_place(count[0]),
                [&](const std::function<void(double)>& visit) { visit_numbers(sums, visit); });
            labels.spacing_ratio = spacing_ratio_of_sum(quartile, state.frame, radius);
            return;
        }
    }

    /// Those of the particles of this rank's slabs, but for those that are no numbers.
    void store_kernel_sums(bool without_crowds, ScratchFile& sums) {
        for (const SlabScratch& slab : own_slabs) {
            StatePart part;
            const Snapshot particles = load(slab, part);
            const NeighborGrid grid(particles.positions, layout, {}, options.threads);
            auto all =
                kernel_sums(grid, radius, state.frame.dimension, options.threads, without_crowds);
            std::size_t kept = 0;
            for (std::size_t place = 0; place < all.size(); ++place)
                if (part.own[grid.particle(place)] != 0 && !std::isnan(all[place]))
                    all[kept++] = all[place];
            sums.append(all.data(), kept * sizeof(double));
        }
    }

    void label_slabs() {
        do_together(ranks, [&] {
            std::unique_ptr<PreparedBoundary> boundary;
            if (!state.frame.boundary.empty())
                boundary = std::make_unique<PreparedBoundary>(whole_boundary());
            std::uint64_t done = 0;
            for (SlabScratch& slab : own_slabs) {
                StatePart part;
                const Snapshot particles = load(slab, part);
                part.boundary = boundary.get();
                LabelOptions of_slab = options;
                of_slab.progress = [&](std::size_t more) {
                    if (options.progress)
                        options.progress(done + more);
                };
                const Labels found = label_part(particles, part, radius, of_slab);
                done += particles.size();
                if (slab.number() == 0)
                    doubt_support_radius(particles, part);
                slab.store(found, part);
                labels.halo += static_cast<std::uint64_t>(
                    std::count(part.own.begin(), part.own.end(), std::uint8_t{0}));
            }
        });
    }

    [[nodiscard]] PreparedBoundary whole_boundary() const {
        Snapshot with_first = state.frame;
        with_first.point_data.clear();
        if (state.size > 0)
            with_first.positions = state.read(0, 1, {}).positions;
        return prepared_boundary(with_first, radius, {}, labels.spacing_ratio, options);
    }

    /// By the first slab.
    void doubt_support_radius(const Snapshot& particles, const StatePart& part) {
        const std::vector<std::uint8_t> all(part.own.size(), 1);
        if (std::string doubt = doubtful_support_radius(particles, radius, all); !doubt.empty())
            labels.warnings.push_back(std::move(doubt));
    }

    /// Labels go to rank 0 in the order of the file.
    void put_back() {
        std::vector<SlabLabels> cursors;
        for (const SlabScratch& slab : own_slabs)
            cursors.emplace_back(slab, options.features.size());
        for (std::uint64_t first = 0; first < state.size; first += rows_at_once) {
            const std::uint64_t count = std::min(rows_at_once, state.size - first);
            std::vector<std::string> for_rank(static_cast<std::size_t>(ranks.size()));
            do_together(ranks, [&] {
                for (SlabLabels& cursor : cursors)
                    cursor.take(first + count, for_rank[0]);
            });
            count_exchanged(for_rank);
            const auto received = ranks.exchange(std::move(for_rank));
            do_together(ranks, [&] {
                if (ranks.rank() == 0)
                    labels.append(labels_of_rows(received, first, count, options.features.size()),
                                  slab_options.label_threshold);
            });
        }
    }
};

} // namespace

LabelsInFile::LabelsInFile(const std::filesystem::path& scratch, std::size_t features) {
    for (std::size_t column = 0; column < 4 + features; ++column)
        columns.emplace_back(scratch);
}

void LabelsInFile::append(const Labels& found, double label_threshold) {
    const std::size_t count = found.valid.size();
    const auto bytes = count * sizeof(double);
    columns[0].append(found.uncovered_fraction.data(), bytes);
    columns[1].append(found.mass_offset.data(), bytes);
    columns[2].append(found.neighbor_count.data(), bytes);
    columns[3].append(found.valid.data(), count);
    for (std::size_t f = 0; f < found.features.size(); ++f)
        columns[4 + f].append(found.features[f].data(), bytes);
    for (std::size_t i = 0; i < count; ++i) {
        valid += found.valid[i];
        surface += found.uncovered_fraction[i] > zero_uncovered_fraction ? 1 : 0;
        more += found.uncovered_fraction[i] > label_threshold ? 1 : 0;
        neighbors += found.valid[i] != 0 ? found.neighbor_count[i] : 0;
    }
}

Labels LabelsInFile::rows(std::uint64_t first, std::uint64_t count) const {
    Labels found;
    const auto read = [&](std::size_t column, std::vector<double>& values) {
        values.resize(count);
        columns[column].read(first * sizeof(double), values.data(), count * sizeof(double));
    };
    read(0, found.uncovered_fraction);
    read(1, found.mass_offset);
    read(2, found.neighbor_count);
    found.valid.resize(count);
    columns[3].read(first, found.valid.data(), count);
    found.features.resize(columns.size() - 4);
    for (std::size_t f = 0; f < found.features.size(); ++f)
        read(4 + f, found.features[f]);
    for (const double lambda : found.uncovered_fraction)
        found.surface.push_back(lambda > zero_uncovered_fraction ? 1 : 0);
    found.spacing_ratio = spacing_ratio;
    return found;
}

LabelsInFile label_in_slabs(const RowsOfState& state, const LabelOptions& options,
                            const SlabOptions& slabs, Ranks& ranks) {
    return SlabWork(state, options, slabs, ranks).run();
}

std::uint64_t memory_in_one_pass(const Snapshot& outline, const LabelOptions& options) {
    std::uint64_t row = 24 + 24 + 8 + 4 + 8 + 8 + 8 + 8 + 3 + 8 * options.features.size();
    for (const PointArray& array : outline.point_data)
        row += static_cast<std::uint64_t>(array.components) * 8;
    for (const char* name : {"mass", "phase", "id"})
        row += find_array(outline, name) != nullptr ? 16 : 0;
    return outline.particles_in_file * row + outline.boundary.size() * 76;
}

std::uint64_t resident_memory() {
    std::uint64_t all = 0;
    std::uint64_t resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::uint64_t peak_memory() {
    std::ifstream status("/proc/self/status");
    std::uint64_t kibibytes = 0;
    for (std::string word; status >> word;)
        if (word == "VmHWM:")
            status >> kibibytes;
    return kibibytes << 10;
}

} // namespace meniscus
