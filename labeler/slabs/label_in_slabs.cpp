#include "label_in_slabs.hpp"

#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/ranks/packing.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace meniscus {
namespace {

/// What decides on labels; ids key random directions alone.
std::vector<std::string> arrays_for(const LabelOptions& options) {
    std::vector<std::string> arrays = {"mass", "phase"};
    if (options.method == LabelMethod::monte_carlo)
        arrays.emplace_back("id");
    return arrays;
}

/// docs/labels.md says how the bytes add up.
SlabNeeds needs_of(const LabelOptions& options, std::uint64_t array_bytes) {
    const std::uint64_t label = 8 + 8 + 8 + 8 * options.features.size() + 3;
    return {1, 24 + 24 + 8 + 8 + 4 + 8 + 2 + 8 + 8 + array_bytes + label, 8};
}

/// 1 for some particles between two planes, enough to tell how close they come to each other.
std::vector<std::uint8_t> some_side_by_side(const Snapshot& slab) {
    constexpr std::size_t enough = 50'000;
    std::vector<std::uint8_t> some(slab.size(), 1);
    if (slab.size() <= enough)
        return some;
    std::vector<double> places;
    for (const auto& position : slab.positions)
        places.push_back(position[0]);
    const auto last = places.begin() + enough;
    std::nth_element(places.begin(), last, places.end());
    for (std::size_t i = 0; i < slab.size(); ++i)
        some[i] = slab.positions[i][0] <= *last ? 1 : 0;
    return some;
}

/// What is said of the labels, of those of one slab after the other.
struct Counts {
    std::uint64_t valid = 0;
    std::uint64_t surface = 0;
    std::uint64_t more = 0;
    double neighbors = 0;
    std::string doubt; ///< of the support radius

    void add(const Labels& found, std::size_t i, double label_threshold) {
        ++valid;
        surface += found.uncovered_fraction[i] > zero_uncovered_fraction ? 1 : 0;
        more += found.uncovered_fraction[i] > label_threshold ? 1 : 0;
        neighbors += found.neighbor_count[i];
    }
};

template <class Pack>
void carry(Pack& pack, Counts& counts) {
    for (std::uint64_t* count : {&counts.valid, &counts.surface, &counts.more})
        pack.number(*count);
    pack.number(counts.neighbors);
    pack.text(counts.doubt);
}

/// One rank's work on one state.
class LabelWork {
public:
    LabelWork(const RowsOfState& state, const LabelOptions& options, const SlabOptions& slabs,
              double label_threshold, Ranks& ranks)
        : state(state), options(options), slab_options(slabs), label_threshold(label_threshold),
          ranks(ranks), particles(state, arrays_for(options), slabs, ranks) {}

    LabelsInFile run() {
        if (std::string doubt = particles.read(options.skip_invalid); !doubt.empty())
            labels.warnings.push_back(std::move(doubt));
        particles.sort(needs_of(options, particles.array_bytes()));
        const auto stored = stored_spacing_ratio(state.frame, *state.frame.support_radius);
        const bool comes_first = is_spacing_needed_first(state.frame, options);
        if (stored)
            labels.spacing_ratio = *stored;
        else if (comes_first)
            labels.spacing_ratio = particles.measured_spacing_ratio(options.threads);
        label_slabs(!stored && !comes_first);
        labels.rows->settle();
        add_counts();
        labels.slabs = particles.slabs();
        labels.halo = particles.halo();
        labels.bytes_sent = particles.bytes_sent() + labels.rows->bytes_sent();
        return std::move(labels);
    }

private:
    const RowsOfState& state;
    const LabelOptions& options;
    const SlabOptions& slab_options;
    double label_threshold;
    Ranks& ranks;
    StateInSlabs particles;
    LabelsInFile labels;
    Counts counts;

    void label_slabs(bool measures_spacing) {
        std::unique_ptr<PreparedBoundary> boundary;
        std::optional<ScratchFile> sums;
        do_together(ranks, [&] {
            labels.rows = std::make_unique<RowResults>(
                state.size, label_columns + options.features.size(), slab_options.scratch, ranks);
            sums.emplace(slab_options.scratch);
            if (!state.frame.boundary.empty())
                boundary = std::make_unique<PreparedBoundary>(whole_boundary());
        });
        std::uint64_t done = 0;
        particles.for_slabs([&](const Snapshot& slab, PartOfState& of_whole) {
            StatePart part{std::move(of_whole), labels.spacing_ratio, boundary.get(),
                           measures_spacing};
            const auto own = static_cast<std::uint64_t>(
                std::count(part.own.begin(), part.own.end(), std::uint8_t{1}));
            LabelOptions of_slab = options;
            of_slab.progress = [&](std::size_t more) { // the halo included
                if (options.progress)
                    options.progress(done + std::min<std::uint64_t>(more, own));
            };
            const Labels found = label_part(slab, part, *state.frame.support_radius, of_slab);
            done += own;
            if (part.is_first)
                counts.doubt = doubtful_support_radius(slab, *state.frame.support_radius,
                                                       some_side_by_side(slab));
            store(found, part);
            store_sums(found, part, *sums);
        });
        if (measures_spacing) {
            const auto ratio = particles.ratio_of_sums(*sums);
            labels.spacing_ratio =
                ratio ? *ratio : particles.measured_spacing_ratio(options.threads);
        }
    }

    [[nodiscard]] PreparedBoundary whole_boundary() const {
        Snapshot with_first = state.frame;
        with_first.point_data.clear();
        if (state.size > 0)
            with_first.positions = state.read(0, 1, {}).positions;
        return prepared_boundary(with_first, *state.frame.support_radius, {}, labels.spacing_ratio,
                                 options);
    }

    void store(const Labels& found, const StatePart& part) {
        std::vector<double> numbers(label_columns + options.features.size());
        for (std::size_t i = 0; i < part.own.size(); ++i) {
            if (part.own[i] == 0)
                continue;
            numbers[lambda_column] = found.uncovered_fraction[i];
            numbers[mass_offset_column] = found.mass_offset[i];
            numbers[count_column] = found.neighbor_count[i];
            for (std::size_t f = 0; f < found.features.size(); ++f)
                numbers[label_columns + f] = found.features[f][i];
            labels.rows->add(part.numbers[i], numbers.data());
            counts.add(found, i, label_threshold);
        }
    }

    static void store_sums(const Labels& found, const StatePart& part, ScratchFile& sums) {
        std::vector<double> known;
        for (std::size_t i = 0; i < found.kernel_sums.size(); ++i)
            if (part.own[i] != 0 && !std::isnan(found.kernel_sums[i]))
                known.push_back(found.kernel_sums[i]);
        sums.append(known.data(), known.size() * sizeof(double));
    }

    void add_counts() {
        for (const std::string& said : gather(ranks, packed(counts))) {
            const auto one = unpacked<Counts>(said);
            labels.valid += one.valid;
            labels.surface += one.surface;
            labels.more += one.more;
            labels.neighbors += one.neighbors;
            if (!one.doubt.empty())
                labels.warnings.push_back(one.doubt);
        }
    }
};

} // namespace

LabelsInFile label_in_slabs(const RowsOfState& state, const LabelOptions& options,
                            const SlabOptions& slabs, double label_threshold, Ranks& ranks) {
    return LabelWork(state, options, slabs, label_threshold, ranks).run();
}

std::uint64_t memory_in_one_pass(const Snapshot& outline, const LabelOptions& options) {
    std::uint64_t row = 24 + 24 + 8 + 4 + 8 + 8 + 8 + 8 + 8 + 3 + 8 * options.features.size();
    for (const PointArray& array : outline.point_data)
        row += static_cast<std::uint64_t>(array.components) * 8;
    for (const char* name : {"mass", "phase", "id"})
        row += find_array(outline, name) != nullptr ? 16 : 0;
    return outline.particles_in_file * row + outline.boundary.size() * 76;
}

} // namespace meniscus
