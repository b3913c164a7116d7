// Work in slabs finds what work in one pass does, on any number of ranks, and what ranks pack
// together is the file that one writes.
#include "data/fetched_snapshot.hpp"
#include "data/test_folder.hpp"
#include "ranks_of_threads.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/slabs/process_memory.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/labeler/slabs/label_in_slabs.hpp>

#include <atomic>
#include <cmath>
#include <random>

namespace meniscus {
namespace {

constexpr double radius = 1;

/// Particles in no order, with all that decides on labels.
Snapshot scattered(std::size_t count) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> place(0, 1);
    Snapshot state;
    state.support_radius = radius;
    std::vector<double> masses;
    std::vector<std::int64_t> ids;
    for (std::size_t i = 0; i < count; ++i) {
        state.positions.push_back({6 * place(random), 5 * place(random), 30 * place(random)});
        masses.push_back(1 + place(random));
        ids.push_back(static_cast<std::int64_t>(count - i));
    }
    state.point_data = {{"mass", 1, masses}, {"id", 1, ids}};
    return state;
}

RowsOfState rows_of(const Snapshot& state) {
    RowsOfState rows;
    rows.frame = state;
    rows.frame.positions.clear();
    for (PointArray& array : rows.frame.point_data)
        std::visit([](auto& values) { values.clear(); }, array.values);
    rows.size = state.size();
    rows.read = [&state](std::uint64_t first, std::uint64_t count,
                         const std::vector<std::string>& names) {
        Snapshot some;
        some.first_particle = first;
        const auto begin = static_cast<std::ptrdiff_t>(first);
        const auto end = static_cast<std::ptrdiff_t>(first + count);
        some.positions.assign(state.positions.begin() + begin, state.positions.begin() + end);
        for (const std::string& name : names) {
            PointArray array = *find_array(state, name);
            std::visit(
                [&](auto& values) {
                    values = {values.begin() + begin, values.begin() + end};
                },
                array.values);
            some.point_data.push_back(array);
        }
        return some;
    };
    return rows;
}

class Slabs : public TestFolder {
protected:
    /// Memory for some slabs of a state.
    [[nodiscard]] SlabOptions options_for(std::uint64_t bytes) const {
        return {resident_memory() + (std::uint64_t{10} << 20) + bytes, folder};
    }

    /// All labels of all ranks, in the order of the state.
    Labels labels_of(const Snapshot& state, const LabelOptions& options, int count,
                     std::uint64_t bytes) const {
        const RowsOfState rows = rows_of(state);
        const SlabOptions slabs = options_for(bytes);
        Labels all;
        all.uncovered_fraction.resize(state.size());
        all.mass_offset.resize(state.size());
        all.neighbor_count.resize(state.size());
        all.valid.resize(state.size());
        std::atomic<std::uint64_t> number_of_slabs{0};
        on_thread_ranks(count, [&](Ranks& ranks) {
            const LabelsInFile found = label_in_slabs(rows, options, slabs, 0.02, ranks);
            const RowResults& own = *found.rows;
            number_of_slabs = found.slabs;
            const std::uint64_t first = own.first_row();
            const std::uint64_t size = own.end_row() - first;
            const auto copy = [&](const auto& values, auto& into) {
                std::copy(values.begin(), values.end(),
                          into.begin() + static_cast<std::ptrdiff_t>(first));
            };
            copy(own.column(lambda_column, first, size), all.uncovered_fraction);
            copy(own.column(mass_offset_column, first, size), all.mass_offset);
            copy(own.column(count_column, first, size), all.neighbor_count);
            copy(own.was_added(first, size), all.valid);
            if (ranks.rank() == 0)
                all.spacing_ratio = found.spacing_ratio;
        });
        EXPECT_GE(number_of_slabs, static_cast<std::uint64_t>(std::max(count, 2)));
        return all;
    }
};

TEST_F(Slabs, LabelsAreTheSameOnAnyNumberOfRanks) {
    Snapshot state = scattered(40'000);
    state.positions[11][2] = std::nan("");
    for (const bool has_phases : {false, true}) {
        if (has_phases) { // the spacing is measured by itself then
            std::vector<std::int64_t> phases(state.size());
            for (std::size_t i = 0; i < phases.size(); ++i)
                phases[i] = state.positions[i][0] > 3 ? 1 : 0;
            set_array(state, {"phase", 1, phases});
        }
        LabelOptions options;
        options.skip_invalid = true;
        options.threads = 1;
        const Labels whole = label_particles(state, radius, options);
        for (const int ranks : {1, 2, 3, 5}) {
            const Labels found = labels_of(state, options, ranks, 5'500'000);
            EXPECT_EQ(found.uncovered_fraction, whole.uncovered_fraction) << ranks;
            EXPECT_EQ(found.mass_offset, whole.mass_offset);
            EXPECT_EQ(found.neighbor_count, whole.neighbor_count);
            EXPECT_EQ(found.valid, whole.valid);
            EXPECT_EQ(found.spacing_ratio, whole.spacing_ratio);
        }
    }
}

TEST_F(Slabs, ParticlesInOnePlaceAreNoMeasureOfTheSpacing) {
    Snapshot state = scattered(3000);
    for (std::size_t i = 0; i < state.size(); ++i)
        state.positions[i] = {0.5, 0.5, static_cast<double>(i % 12)}; // crowds of 250 each
    LabelOptions options;
    options.threads = 1;
    const Labels whole = label_particles(state, radius, options);
    EXPECT_EQ(labels_of(state, options, 2, 4'350'000).spacing_ratio, whole.spacing_ratio);
}

TEST_F(Slabs, ProgressEndsAtThisRanksParticles) {
    const Snapshot state = scattered(40'000);
    LabelOptions options;
    options.threads = 1;
    std::size_t most = 0;
    options.progress = [&](std::size_t done) { most = std::max(most, done); };
    labels_of(state, options, 1, 5'500'000);
    EXPECT_LE(most, state.size());
    EXPECT_GT(most, state.size() * 9 / 10);
}

TEST_F(Slabs, AFaultOnOneRankIsThrownOnAll) {
    Snapshot state = scattered(1000);
    set_array(state, {"mass", 1, std::vector<double>(1000, -1)});
    const RowsOfState rows = rows_of(state);
    const SlabOptions slabs = options_for(6'000'000);
    std::atomic<int> thrown{0};
    on_thread_ranks(3, [&](Ranks& ranks) {
        try {
            label_in_slabs(rows, {}, slabs, 0.02, ranks);
        } catch (const InputError& error) {
            thrown += std::string(error.what()).find("particle 0 has mass -1") == 0 ? 1 : 0;
        }
    });
    EXPECT_EQ(thrown, 3);
}

TEST_F(Slabs, PackedTogetherIsTheSameFile) {
    for (const std::size_t count : {0U, 3U, 100U, 300'000U}) {
        Snapshot state = scattered(count);
        state.position_precision = Precision::float32;
        set_array(state, {"velocity", 3, std::vector<float>(3 * count, 1.5F)});
        set_array(state, {"class", 1, std::vector<std::int8_t>(count, std::int8_t{1})});
        state.boundary.assign(5000, {1, 2, 3});
        write_vtkhdf(state, folder / "whole.vtkhdf");
        for (const int number : {1, 2, 3, 7}) {
            on_thread_ranks(number, [&](Ranks& ranks) {
                const FetchedSnapshot part = fetched_from(state, 50'000);
                const PackedDatasets packed = pack_vtkhdf(part, folder, ranks);
                if (ranks.rank() == 0)
                    write_vtkhdf(part, packed, folder / "packed.vtkhdf");
            });
            EXPECT_TRUE(bytes_of(folder / "whole.vtkhdf") == bytes_of(folder / "packed.vtkhdf"))
                << count << " particles, " << number << " ranks";
        }
    }
}

} // namespace
} // namespace meniscus
