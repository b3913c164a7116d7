// The project's own snapshot files: VTKHDF (HDF5, type UnstructuredGrid, version 1.0), one vertex
// cell a particle, which ParaView and VTK's own reader open as they are. What VTK need not see
// lies in the group /meniscus. The layout is described in docs/file_formats.md.
#pragma once

#include "packed_datasets.hpp"

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/ranks/ranks.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

/// True where the file begins as an HDF5 file and holds a group /VTKHDF.
bool is_vtkhdf(const std::filesystem::path& file);

/// Reads a VTKHDF file of particles. Throws InputError where it is not one, where arrays disagree
/// in length, or where a dataset claims more than the file can hold.
Snapshot read_vtkhdf(const std::filesystem::path& file);

/// What the file says of itself, without its particles: a snapshot of none, with the names of its
/// point data, its numbers, scene and provenance. Throws as read_vtkhdf does, but for the arrays,
/// which are not looked at.
Snapshot read_vtkhdf_header(const std::filesystem::path& file);

/// The same with the number of particles (particles_in_file), the number type and components of
/// each array, which is empty, and the precision of positions. Throws as read_vtkhdf does.
Snapshot read_vtkhdf_outline(const std::filesystem::path& file);

/// Some of a file's particles.
struct VtkhdfPart {
    std::uint64_t first;
    std::uint64_t count;
    std::vector<std::string> arrays; ///< point data to read beside the positions
    bool positions = true;           ///< without, the snapshot has arrays alone
};

/// A snapshot of these particles and arrays alone, without boundary and cells: of what read_vtkhdf
/// gives, those from `first` on. Takes memory for these. Throws as read_vtkhdf does, and where the
/// file has not so many.
Snapshot read_vtkhdf_part(const std::filesystem::path& file, const VtkhdfPart& part);

/// The file's boundary particles; none where it has none. Throws as read_vtkhdf does.
Positions read_vtkhdf_boundary(const std::filesystem::path& file);

/// Writes the snapshot, whole or not at all; the same snapshot gives the same bytes. Throws as
/// write_whole does.
void write_vtkhdf(const Snapshot& snapshot, const std::filesystem::path& file);

/// A snapshot whose particles are fetched as they are written, so that memory holds some of them at
/// a time. Fetching must always give the same values, and may use other snapshot files meanwhile.
struct FetchedSnapshot {
    Snapshot frame; ///< all but particles; its arrays are empty, of the type that is fetched
    std::uint64_t size = 0;
    std::uint64_t rows_at_once = std::uint64_t{1} << 18; ///< about
    std::function<Positions(std::uint64_t first, std::uint64_t count)> positions;
    /// Values of array `place` of the frame.
    std::function<ArrayValues(std::size_t place, std::uint64_t first, std::uint64_t count)> values;
};

/// Writes the same bytes as for the snapshot that is fetched, if that were in memory. Throws as
/// write_vtkhdf does, and what fetching throws.
void write_vtkhdf(const FetchedSnapshot& snapshot, const std::filesystem::path& file);

/// Makes all that is large of such a file, in shares: each rank fetches the rows of its own
/// (first_of_share, data/ranks/ranks.hpp), and beyond its last one those of a chunk that begins
/// before, and compresses them. On the first rank all is there afterwards, in a file
/// in the folder `scratch`. Collective; throws what fetching throws and FailureError where that
/// folder is full, on all ranks alike.
PackedDatasets pack_vtkhdf(const FetchedSnapshot& snapshot, const std::filesystem::path& scratch,
                           Ranks& ranks);

/// The row that no chunk reaches beyond which begins before row `end`: of an array of one
/// component, or of vectors of double. Chunks have a megabyte at most.
inline std::uint64_t end_of_chunks(std::uint64_t end) {
    constexpr std::uint64_t most = std::uint64_t{1} << 20;
    return std::max((end + most - 1) / most * most, end + most / 24);
}

/// Writes the same bytes from what was made before: of the snapshot only the frame and what is
/// small is looked at.
void write_vtkhdf(const FetchedSnapshot& snapshot, const PackedDatasets& packed,
                  const std::filesystem::path& file);

} // namespace meniscus
