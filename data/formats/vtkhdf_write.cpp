#include "vtkhdf.hpp"

#include <meniscus/data/hdf5/descriptor_driver.hpp>
#include <meniscus/data/hdf5/hdf5_handles.hpp>
#include <meniscus/data/hdf5/hdf5_memory.hpp>
#include <meniscus/data/hdf5/hdf5_turn.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

// Higher levels cost more time than they save space on coordinates that are all but random.
// Chunks of at most a megabyte fit HDF5's chunk cache.
constexpr unsigned compression_level = 1;
constexpr hsize_t chunk_bytes = hsize_t{1} << 20;
constexpr hsize_t min_compressed = 1024;

/// The identifier of something that is made in memory, where only memory can be missing.
Handle made(hid_t id, herr_t (*closing)(hid_t)) {
    if (id < 0)
        throw std::bad_alloc();
    return {id, closing};
}

void require(herr_t result) {
    if (result < 0)
        throw std::bad_alloc();
}

/// A property list under which nothing stores its time of creation: the same snapshot gives the
/// same bytes.
Handle timeless(hid_t list_class) {
    Handle list = made(H5Pcreate(list_class), H5Pclose);
    require(H5Pset_obj_track_times(list, false));
    return list;
}

Handle make_group(hid_t parent, const char* name) {
    const Handle creation = timeless(H5P_GROUP_CREATE);
    // All names in the group's header, which has a checksum, however many they are.
    require(H5Pset_link_phase_change(creation, 65535, 65534));
    return made(H5Gcreate2(parent, name, H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose);
}

/// Compression for what is large enough to gain from it.
void set_compression(hid_t creation, const Dimensions& dimensions, std::size_t number_size) {
    const hsize_t row = std::accumulate(dimensions.begin() + 1, dimensions.end(),
                                        hsize_t{number_size}, std::multiplies<>());
    if (dimensions[0] * row < min_compressed)
        return;
    Dimensions chunk = dimensions;
    chunk[0] = std::min(dimensions[0], std::max<hsize_t>(chunk_bytes / row, 1));
    require(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()));
    require(H5Pset_shuffle(creation));
    require(H5Pset_deflate(creation, compression_level));
}

/// Who is inside HDF5 gives its turn to others while it fetches what it is to write.
using Turn = std::unique_lock<FairLock>;

/// Values of rows from `first` on, in memory that lives until the next call.
using FetchRows = std::function<const void*(std::uint64_t first, std::uint64_t count)>;

/// Rows of values, `at_once` of which are fetched at a time.
struct RowSource {
    std::uint64_t at_once;
    FetchRows fetch;
};

/// Rows that are in memory.
RowSource rows_at(const void* values) {
    return {std::numeric_limits<std::uint64_t>::max(),
            [values](std::uint64_t /*first*/, std::uint64_t /*count*/) { return values; }};
}

/// As many rows as whole chunks have, so that no chunk is written twice; all where there are none.
std::uint64_t whole_chunks(hid_t creation, const Dimensions& dimensions, std::uint64_t at_once) {
    if (H5Pget_layout(creation) != H5D_CHUNKED)
        return dimensions[0];
    Dimensions chunk(dimensions.size());
    H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
    return std::max<std::uint64_t>(at_once / chunk[0], 1) * chunk[0];
}

/// Fetches while others have their turn, which comes back whatever happens.
const void* fetch_outside(Turn& turn, const RowSource& source, std::uint64_t first,
                          std::uint64_t count) {
    turn.unlock();
    try {
        const void* values = source.fetch(first, count);
        turn.lock();
        return values;
    } catch (...) {
        turn.lock();
        throw;
    }
}

void write_rows(hid_t dataset, hid_t creation, hid_t memory_type, const Dimensions& dimensions,
                const RowSource& source, Turn& turn) {
    const std::uint64_t rows = dimensions[0];
    const std::uint64_t at_once =
        source.at_once >= rows ? rows : whole_chunks(creation, dimensions, source.at_once);
    for (Dimensions first(dimensions.size()); first[0] < rows; first[0] += at_once) {
        Dimensions count = dimensions;
        count[0] = std::min<std::uint64_t>(at_once, rows - first[0]);
        const void* values = fetch_outside(turn, source, first[0], count[0]);
        const Handle in_file = made(H5Dget_space(dataset), H5Sclose);
        const Handle in_memory =
            made(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
        require(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, first.data(), nullptr, count.data(),
                                    nullptr));
        require(H5Dwrite(dataset, memory_type, in_memory, in_file, H5P_DEFAULT, values));
    }
}

/// A dataset without values yet, and the list that it was created by.
std::pair<Handle, Handle> make_dataset(hid_t group, const std::string& name,
                                       const Dimensions& dimensions, hid_t stored_type) {
    const Handle space =
        made(H5Screate_simple(static_cast<int>(dimensions.size()), dimensions.data(), nullptr),
             H5Sclose);
    Handle creation = timeless(H5P_DATASET_CREATE);
    if (!dimensions.empty())
        set_compression(creation, dimensions, H5Tget_size(stored_type));
    Handle dataset = made(
        H5Dcreate2(group, name.c_str(), stored_type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
        H5Dclose);
    return {std::move(dataset), std::move(creation)};
}

/// Writes numbers in rows.
void write_dataset(hid_t group, const std::string& name, const Dimensions& dimensions,
                   hid_t stored_type, hid_t memory_type, const RowSource& source, Turn& turn) {
    const auto [dataset, creation] = make_dataset(group, name, dimensions, stored_type);
    write_rows(dataset, creation, memory_type, dimensions, source, turn);
}

Dimensions dimensions_of(std::uint64_t rows, int components) {
    return components == 1 ? Dimensions{rows} : Dimensions{rows, static_cast<hsize_t>(components)};
}

template <class Number>
void write_numbers(hid_t group, const std::string& name, const std::vector<Number>& values,
                   Turn& turn) {
    write_dataset(group, name, {values.size()}, number_type<Number>(), number_type<Number>(),
                  rows_at(values.data()), turn);
}

void write_text(hid_t group, const std::string& name, std::string_view text) {
    const Handle type = text_type(text.size(), H5T_CSET_UTF8);
    const std::string padded(text.empty() ? std::string_view("\0", 1) : text);
    const Handle dataset = make_dataset(group, name, {}, type).first;
    require(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()));
}

void write_attribute(hid_t group, const char* name, hid_t space, hid_t type, const void* value) {
    const Handle attribute =
        made(H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    require(H5Awrite(attribute, type, value));
}

/// Entries under the names that the file gives them, in their order. HDF5 takes '/' and a lone '.'
/// for paths; what would share a name after that is told apart by underscores.
template <class Entries, class Name>
auto by_stored_name(const Entries& entries, Name name_of) {
    std::map<std::string, const typename Entries::value_type*> stored;
    for (const auto& entry : entries) {
        std::string name = name_of(entry);
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c == '/' || c == '\0'; }, '_');
        if (name.empty() || name == ".")
            name = "_";
        while (stored.count(name) > 0)
            name += '_';
        stored[name] = &entry;
    }
    return stored;
}

/// Numbers that follow on each other from `first` on, made as they are written.
template <class Number>
void write_made(hid_t group, const char* name, std::uint64_t size, Number (*value)(std::uint64_t),
                Turn& turn) {
    std::vector<Number> some;
    const RowSource source = {std::uint64_t{1} << 18,
                              [&](std::uint64_t first, std::uint64_t count) -> const void* {
                                  some.resize(count);
                                  for (std::uint64_t i = 0; i < count; ++i)
                                      some[i] = value(first + i);
                                  return some.data();
                              }};
    write_dataset(group, name, {size}, number_type<Number>(), number_type<Number>(), source, turn);
}

void write_vertex_cells(hid_t group, std::uint64_t size, Turn& turn) {
    const auto itself = [](std::uint64_t i) { return static_cast<std::int64_t>(i); };
    write_made<std::int64_t>(group, "Offsets", size + 1, itself, turn);
    write_made<std::int64_t>(group, "Connectivity", size, itself, turn);
    write_made<std::uint8_t>(
        group, "Types", size, [](std::uint64_t /*i*/) { return vertex_cell; }, turn);
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
        write_numbers(group, name, std::vector<std::int64_t>{static_cast<std::int64_t>(size)},
                      turn);
}

/// What the writer takes a snapshot from: one in memory, or one that is fetched.
struct Given {
    const Snapshot& frame;
    std::uint64_t size;
    RowSource positions;
    std::function<RowSource(std::size_t place)> values;
};

void write_point_data(hid_t parent, const Given& given, Turn& turn) {
    const Handle group = make_group(parent, "PointData");
    const auto& all = given.frame.point_data;
    const auto arrays = by_stored_name(all, [](const PointArray& array) { return array.name; });
    for (const auto& [name, array] : arrays) {
        const RowSource source = given.values(static_cast<std::size_t>(array - all.data()));
        std::visit(
            [&, name = name, array = array](const auto& values) {
                using Number = typename std::decay_t<decltype(values)>::value_type;
                write_dataset(group, name, dimensions_of(given.size, array->components),
                              number_type<Number>(), number_type<Number>(), source, turn);
            },
            array->values);
    }
}

void write_field_data(hid_t parent, const Snapshot& snapshot, Turn& turn) {
    const Handle group = make_group(parent, "FieldData");
    const std::pair<const char*, std::optional<double>> fields[] = {
        {"support_radius", snapshot.support_radius},
        {"particle_spacing", snapshot.particle_spacing},
        {"particle_volume", snapshot.particle_volume},
        {"time", snapshot.time}};
    for (const auto& [name, value] : fields)
        if (value)
            write_numbers(group, name, std::vector<double>{*value}, turn);
    write_numbers(group, "dimension", std::vector<std::int32_t>{snapshot.dimension}, turn);
}

void write_for_vtk(hid_t file, const Given& given, Turn& turn) {
    const Handle group = make_group(file, "VTKHDF");
    const std::int64_t version[] = {1, 0};
    const hsize_t two = 2;
    write_attribute(group, "Version", made(H5Screate_simple(1, &two, nullptr), H5Sclose),
                    number_type<std::int64_t>(), version);
    write_attribute(group, "Type", made(H5Screate(H5S_SCALAR), H5Sclose),
                    text_type(grid_type.size(), H5T_CSET_ASCII), grid_type.data());
    write_dataset(group, "Points", {given.size, 3},
                  given.frame.position_precision == Precision::float32 ? number_type<float>()
                                                                       : number_type<double>(),
                  number_type<double>(), given.positions, turn);
    write_vertex_cells(group, given.size, turn);
    write_point_data(group, given, turn);
    make_group(group, "CellData");
    write_field_data(group, given.frame, turn);
}

void write_for_meniscus(hid_t file, const Snapshot& snapshot, Turn& turn) {
    const Handle group = make_group(file, "meniscus");
    write_text(group, "format_version", format_version);
    if (!snapshot.scene.empty())
        write_text(group, "scene", snapshot.scene);
    if (!snapshot.boundary.empty()) {
        write_dataset(group, "boundary", {snapshot.boundary.size(), 3}, number_type<double>(),
                      number_type<double>(), rows_at(snapshot.boundary.data()), turn);
    }
    const Handle provenance = make_group(group, "provenance");
    const auto entries =
        by_stored_name(snapshot.provenance, [](const auto& entry) { return entry.first; });
    for (const auto& [name, entry] : entries)
        write_text(provenance, name, entry->second);
}

/// Fills a file with the snapshot. The bytes are those that HDF5 has flushed: closing the file
/// would change them once more.
void fill_file(int descriptor, const Given& given, FileBeingWritten& written) {
    Turn turn(hdf5_turn());
    start_hdf5();
    const QuietErrors quiet;
    const Handle access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    // Since 1.8 HDF5 keeps checksums of its own structures, so that damage is noticed.
    require(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
    const Handle file =
        create_on_descriptor(descriptor, written, timeless(H5P_FILE_CREATE), access);
    if (file < 0)
        throw std::bad_alloc();
    // Nothing reaches the file any more once this is left, be it by an exception.
    const std::unique_ptr<bool, void (*)(bool*)> finish(&written.is_finished,
                                                        [](bool* finished) { *finished = true; });
    write_for_vtk(file, given, turn);
    write_for_meniscus(file, given.frame, turn);
    require(H5Fflush(file, H5F_SCOPE_LOCAL));
}

void write_given(const Given& given, const fs::path& file) {
    write_whole(file, [&](int descriptor) {
        FileBeingWritten written;
        bool has_memory = true;
        try {
            fill_file(descriptor, given, written);
        } catch (const std::bad_alloc&) {
            has_memory = false;
        }
        // HDF5 does not always tell: it writes what it holds back while it closes a dataset.
        if (written.error != 0)
            fail_to_write(file, written.error);
        if (!has_memory)
            throw FailureError(file.string() + ": not enough memory to build the file of " +
                               std::to_string(given.size) + " particles");
        if (ftruncate(descriptor, static_cast<off_t>(written.bytes)) != 0)
            fail_to_write(file, errno);
    });
}

/// The place in memory of an array's values.
const void* values_at(const PointArray& array) {
    return std::visit([](const auto& values) -> const void* { return values.data(); },
                      array.values);
}

/// What could not be read back is refused before it is written.
void check_consistent(const Snapshot& snapshot) {
    const auto refuse_unless = [](bool fine, const std::string& what) {
        if (!fine)
            throw std::invalid_argument("snapshot to write: " + what);
    };
    for (const PointArray& array : snapshot.point_data) {
        const std::size_t count =
            std::visit([](const auto& values) { return values.size(); }, array.values);
        refuse_unless(array.components > 0 &&
                          count == snapshot.size() * static_cast<std::size_t>(array.components),
                      "point data '" + array.name + "' does not have the particles' length");
    }
    for (const auto& length :
         {snapshot.support_radius, snapshot.particle_spacing, snapshot.particle_volume}) {
        refuse_unless(!length || (std::isfinite(*length) && *length > 0),
                      "support radius, particle spacing and volume must be positive and finite");
    }
    refuse_unless(!snapshot.time || std::isfinite(*snapshot.time), "time must be finite");
    refuse_unless(snapshot.dimension == 2 || snapshot.dimension == 3, "dimension must be 2 or 3");
}

} // namespace

void write_vtkhdf(const Snapshot& snapshot, const fs::path& file) {
    check_consistent(snapshot);
    const auto values = [&](std::size_t place) {
        return rows_at(values_at(snapshot.point_data[place]));
    };
    write_given({snapshot, snapshot.size(), rows_at(snapshot.positions.data()), values}, file);
}

void write_vtkhdf(const FetchedSnapshot& snapshot, const fs::path& file) {
    Positions positions;
    PointArray some;
    const auto fetch_positions = [&](std::uint64_t first, std::uint64_t count) -> const void* {
        positions = snapshot.positions(first, count);
        return positions.data();
    };
    const auto values = [&](std::size_t place) {
        return RowSource{snapshot.rows_at_once,
                         [&, place](std::uint64_t first, std::uint64_t count) -> const void* {
                             some.values = snapshot.values(place, first, count);
                             return values_at(some);
                         }};
    };
    write_given({snapshot.frame, snapshot.size, {snapshot.rows_at_once, fetch_positions}, values},
                file);
}

} // namespace meniscus
