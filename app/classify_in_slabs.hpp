// Classes, normals, curvatures and forces of a state that is larger than memory, found in slabs
// (data/slabs/): each with as many layers around it as forces reach, so that every particle gets
// what it gets in one pass, to the bit.
#pragma once

#include "surface_tension.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/slabs/row_results.hpp>
#include <meniscus/data/slabs/state_in_slabs.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct SlabClassifyOptions {
    std::function<const Model&(double spacing_ratio)> model;
    SurfaceTensionOptions surface; ///< set_by_model() not applied
    bool skip_invalid = false;
    int threads = 0;
};

struct ClassesInFile {
    std::unique_ptr<RowResults> rows; ///< of this rank
    double spacing_ratio = 1;
    SurfaceCounts counts;
    std::vector<std::string> warnings;
    std::uint64_t slabs = 0;
    std::uint64_t halo = 0;
    std::uint64_t bytes_sent = 0;
};

/// Classifies the state. Collective; throws as classify_snapshot, find_surface and StateInSlabs do,
/// and what `model` throws, on all ranks alike.
ClassesInFile classify_in_slabs(const RowsOfState& state, const SlabClassifyOptions& options,
                                const SlabOptions& slabs, Ranks& ranks);

/// Adds the arrays of the classes, as classify does, to a frame: empty ones.
void add_empty_classes(Snapshot& frame);

/// Rows of such an array; nothing for another one.
std::optional<ArrayValues> class_values(const PointArray& array, const RowResults& rows,
                                        std::uint64_t first, std::uint64_t count);

/// Bytes that classifying and writing take for a state in memory.
std::uint64_t memory_to_classify(const Snapshot& outline);

} // namespace meniscus
