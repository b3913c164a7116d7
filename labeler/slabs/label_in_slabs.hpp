// A state that is larger than memory, labelled in slabs: layers of the neighbor search's cells
// along its longest axis, each with the layer of particles beside it on either side, which is as
// far as neighbors reach. Cells lie where those of the whole state would, so that each particle
// finds the same neighbors in the same order and gets the same labels, to the bit. What does not
// fit goes through scratch files: particles are read in the order of the file, sorted into slabs,
// labelled slab by slab, and their labels put back into the order of the file. Several ranks share
// the slabs.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/ranks/ranks.hpp>
#include <meniscus/data/text/scratch_file.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

/// A state whose particles are read in rows, in the order of the file.
struct RowsOfState {
    Snapshot frame; ///< all but particles; with a support radius for all and the whole boundary
    std::uint64_t size = 0;
    /// Positions and these arrays of `count` particles from `first` on, that being first_particle.
    std::function<Snapshot(std::uint64_t first, std::uint64_t count,
                           const std::vector<std::string>& arrays)>
        read;
};

struct SlabOptions {
    std::uint64_t memory = 0;      ///< bytes that this process may take in all
    std::filesystem::path scratch; ///< folder for what does not fit
    double label_threshold = 0;    ///< for LabelsInFile::more
};

/// The labels of all particles in the order of the file, and what there is to say of them.
class LabelsInFile {
public:
    LabelsInFile(const std::filesystem::path& scratch, std::size_t features);

    /// As Labels has them, of particles from `first` on.
    [[nodiscard]] Labels rows(std::uint64_t first, std::uint64_t count) const;

    /// Adds those that come next.
    void append(const Labels& labels, double label_threshold);

    double spacing_ratio = 1;
    std::uint64_t valid = 0;
    std::uint64_t surface = 0;
    std::uint64_t more = 0;            ///< uncovered by more than the threshold
    double neighbors = 0;              ///< sum of the valid ones' neighbor counts
    std::vector<std::string> warnings; ///< one line each

    // How it was done, for whoever measures it:
    std::uint64_t slabs = 0;
    std::uint64_t halo = 0;            ///< particles that were there for their neighbors alone
    std::uint64_t bytes_exchanged = 0; ///< between ranks

private:
    std::vector<ScratchFile> columns; ///< lambda, mass offset, count, features, valid
};

/// Labels the state. On rank 0 the labels are there afterwards; on others only what is said of
/// them. Options are those of label_particles, `progress` is called with the particles of this
/// rank. Throws as label_particles does, InputError where the memory does not suffice, saying how
/// much would, and FailureError where the scratch folder is full; on all ranks alike.
LabelsInFile label_in_slabs(const RowsOfState& state, const LabelOptions& options,
                            const SlabOptions& slabs, Ranks& ranks);

/// Bytes that label_particles and writing take for a state in memory of so many particles, point
/// data and boundary.
std::uint64_t memory_in_one_pass(const Snapshot& outline, const LabelOptions& options);

/// Bytes that this process has in memory now, and the most that it ever had; 0 where the system
/// does not say.
std::uint64_t resident_memory();
std::uint64_t peak_memory();

} // namespace meniscus
