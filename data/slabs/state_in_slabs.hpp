// A state that is larger than memory, worked on in slabs: layers of the neighbor search's cells
// along its longest axis, each with some layers of particles beside it on either side, as far as
// neighbors, or neighbors of neighbors, reach. Cells lie where those of the whole state would, so
// that each particle finds the same neighbors in the same order, and what is found of it is the
// same, to the bit. What does not fit goes through scratch files: particles are read once, in the
// order of the file, and sorted into slabs. Several ranks share the rows and the slabs.
#pragma once

#include "part_of_state.hpp"
#include "slab_needs.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/ranks/ranks.hpp>
#include <meniscus/data/text/scratch_file.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
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
};

/// All but what is const is collective, and so is ratio_of_sums(); it throws on all ranks alike:
/// InputError where the state cannot be worked with, as for one in memory, or memory does not
/// suffice, saying how much would; FailureError where the scratch folder is full.
class StateInSlabs {
public:
    /// `arrays`: of those that the state has, the ones that come with the particles (mass, phase,
    /// id). The state must live as long.
    StateInSlabs(const RowsOfState& state, const std::vector<std::string>& arrays,
                 const SlabOptions& options, Ranks& ranks);
    ~StateInSlabs();
    StateInSlabs(const StateInSlabs&) = delete;
    StateInSlabs& operator=(const StateInSlabs&) = delete;

    /// Reads this rank's share of the rows, calling visit with what is read, checks it, and keeps
    /// what is valid. Returns a line on doubtful positions, or nothing.
    std::string read(bool skip_invalid, const std::function<void(const Snapshot&)>& visit = {});

    /// Sorts all particles into slabs, anew where that was done before for other needs.
    void sort(const SlabNeeds& needs);

    /// Calls visit with each slab of this rank: its particles, in the order of the file.
    void for_slabs(const std::function<void(const Snapshot& particles, PartOfState& part)>& visit);

    /// The value that decides on the spacing ratio by the kernel sums that all ranks have in these
    /// files (quartile_place); nothing where there is none.
    [[nodiscard]] std::optional<double> ratio_of_sums(const ScratchFile& sums) const;

    /// The spacing ratio, by a pass of its own over all slabs.
    double measured_spacing_ratio(int threads);

    [[nodiscard]] std::uint64_t slabs() const;
    [[nodiscard]] std::uint64_t halo() const; ///< of this rank's slabs, summed over for_slabs()
    [[nodiscard]] std::uint64_t bytes_sent() const;
    [[nodiscard]] Ranks& ranks() const;
    [[nodiscard]] const RowsOfState& state() const;

    /// Bytes a particle that the arrays add to what a slab takes.
    [[nodiscard]] std::uint64_t array_bytes() const;

private:
    struct Work;
    std::unique_ptr<Work> work;
};

} // namespace meniscus
