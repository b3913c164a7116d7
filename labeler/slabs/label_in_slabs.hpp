// A state that is larger than memory, labelled in slabs (data/slabs/): each particle gets the same
// labels as in one pass, to the bit.
#pragma once

#include <meniscus/data/ranks/ranks.hpp>
#include <meniscus/data/slabs/row_results.hpp>
#include <meniscus/data/slabs/state_in_slabs.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace meniscus {

/// The labels of this rank's rows, and what there is to say of those of the whole state.
struct LabelsInFile {
    /// In the columns of label_columns, those of LabelOptions::features behind them.
    std::unique_ptr<RowResults> rows;

    double spacing_ratio = 1;
    std::uint64_t valid = 0;
    std::uint64_t surface = 0;
    std::uint64_t more = 0;            ///< uncovered by more than the threshold
    double neighbors = 0;              ///< sum of the valid ones' neighbor counts
    std::vector<std::string> warnings; ///< one line each

    // How it was done, for whoever measures it:
    std::uint64_t slabs = 0;
    std::uint64_t halo = 0;       ///< particles that were there for their neighbors alone
    std::uint64_t bytes_sent = 0; ///< to other ranks
};

enum LabelColumn : std::size_t { lambda_column, mass_offset_column, count_column, label_columns };

/// Labels the state; `label_threshold` is for LabelsInFile::more. Options are those of
/// label_particles, `progress` is called with the particles of this rank. Collective; throws as
/// label_particles and StateInSlabs do.
LabelsInFile label_in_slabs(const RowsOfState& state, const LabelOptions& options,
                            const SlabOptions& slabs, double label_threshold, Ranks& ranks);

/// Bytes that label_particles and writing take for a state in memory of so many particles, point
/// data and boundary.
std::uint64_t memory_in_one_pass(const Snapshot& outline, const LabelOptions& options);

} // namespace meniscus
