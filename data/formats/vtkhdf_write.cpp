#include "vtkhdf.hpp"

#include <meniscus/data/hdf5/hdf5_handles.hpp>
#include <meniscus/data/hdf5/hdf5_lock.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>

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

/// Writes numbers or, with no dimensions at all, one text.
void write_dataset(hid_t group, const std::string& name, const Dimensions& dimensions,
                   hid_t stored_type, hid_t memory_type, const void* values) {
    const Handle space =
        made(H5Screate_simple(static_cast<int>(dimensions.size()), dimensions.data(), nullptr),
             H5Sclose);
    const Handle creation = timeless(H5P_DATASET_CREATE);
    if (!dimensions.empty())
        set_compression(creation, dimensions, H5Tget_size(stored_type));
    const Handle dataset = made(
        H5Dcreate2(group, name.c_str(), stored_type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
        H5Dclose);
    if (H5Sget_simple_extent_npoints(space) > 0)
        require(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
}

template <class Number>
void write_numbers(hid_t group, const std::string& name, const std::vector<Number>& values,
                   int components = 1) {
    const auto width = static_cast<hsize_t>(components);
    const Dimensions dimensions =
        components == 1 ? Dimensions{values.size()} : Dimensions{values.size() / width, width};
    write_dataset(group, name, dimensions, number_type<Number>(), number_type<Number>(),
                  values.data());
}

void write_text(hid_t group, const std::string& name, std::string_view text) {
    const Handle type = text_type(text.size(), H5T_CSET_UTF8);
    const std::string padded(text.empty() ? std::string_view("\0", 1) : text);
    write_dataset(group, name, {}, type, type, padded.data());
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

void write_vertex_cells(hid_t group, std::size_t count) {
    std::vector<std::int64_t> ascending(count + 1);
    std::iota(ascending.begin(), ascending.end(), 0);
    write_numbers(group, "Offsets", ascending);
    ascending.pop_back();
    write_numbers(group, "Connectivity", ascending);
    write_numbers(group, "Types", std::vector<std::uint8_t>(count, vertex_cell));
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
        write_numbers(group, name, std::vector<std::int64_t>{static_cast<std::int64_t>(count)});
}

void write_point_data(hid_t parent, const Snapshot& snapshot) {
    const Handle group = make_group(parent, "PointData");
    const auto arrays =
        by_stored_name(snapshot.point_data, [](const PointArray& array) { return array.name; });
    for (const auto& [name, array] : arrays) {
        std::visit(
            [&, name = name, array = array](const auto& values) {
                write_numbers(group, name, values, array->components);
            },
            array->values);
    }
}

void write_field_data(hid_t parent, const Snapshot& snapshot) {
    const Handle group = make_group(parent, "FieldData");
    const std::pair<const char*, std::optional<double>> fields[] = {
        {"support_radius", snapshot.support_radius},
        {"particle_spacing", snapshot.particle_spacing},
        {"particle_volume", snapshot.particle_volume},
        {"time", snapshot.time}};
    for (const auto& [name, value] : fields)
        if (value)
            write_numbers(group, name, std::vector<double>{*value});
    write_numbers(group, "dimension", std::vector<std::int32_t>{snapshot.dimension});
}

void write_for_vtk(hid_t file, const Snapshot& snapshot) {
    const Handle group = make_group(file, "VTKHDF");
    const std::int64_t version[] = {1, 0};
    const hsize_t two = 2;
    write_attribute(group, "Version", made(H5Screate_simple(1, &two, nullptr), H5Sclose),
                    number_type<std::int64_t>(), version);
    write_attribute(group, "Type", made(H5Screate(H5S_SCALAR), H5Sclose),
                    text_type(grid_type.size(), H5T_CSET_ASCII), grid_type.data());
    write_dataset(group, "Points", {snapshot.size(), 3},
                  snapshot.position_precision == Precision::float32 ? number_type<float>()
                                                                    : number_type<double>(),
                  number_type<double>(), snapshot.positions.data());
    write_vertex_cells(group, snapshot.size());
    write_point_data(group, snapshot);
    make_group(group, "CellData");
    write_field_data(group, snapshot);
}

void write_for_meniscus(hid_t file, const Snapshot& snapshot) {
    const Handle group = make_group(file, "meniscus");
    write_text(group, "format_version", format_version);
    if (!snapshot.scene.empty())
        write_text(group, "scene", snapshot.scene);
    if (!snapshot.boundary.empty()) {
        write_dataset(group, "boundary", {snapshot.boundary.size(), 3}, number_type<double>(),
                      number_type<double>(), snapshot.boundary.data());
    }
    const Handle provenance = make_group(group, "provenance");
    const auto entries =
        by_stored_name(snapshot.provenance, [](const auto& entry) { return entry.first; });
    for (const auto& [name, entry] : entries)
        write_text(provenance, name, entry->second);
}

/// The bytes of the whole file. They are made in memory, so that what reaches the disk does so
/// whole or not at all. `name` is only what HDF5 tells files in memory apart by.
std::string file_image(const Snapshot& snapshot, const std::string& name) {
    const Handle access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    require(H5Pset_fapl_core(access, std::size_t{1} << 24, false));
    // Since 1.8 HDF5 keeps checksums of its own structures, so that damage is noticed.
    require(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
    const Handle file =
        made(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, timeless(H5P_FILE_CREATE), access), H5Fclose);
    write_for_vtk(file, snapshot);
    write_for_meniscus(file, snapshot);
    require(H5Fflush(file, H5F_SCOPE_LOCAL));
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    // The driver's own memory: H5Fget_file_image would clear the flag "open for writing", which has
    // no meaning in this version of the format, without mending the checksum over it.
    void** memory = nullptr;
    require(H5Fget_vfd_handle(file, H5P_DEFAULT, reinterpret_cast<void**>(&memory)));
    if (size <= 0 || memory == nullptr)
        throw std::bad_alloc();
    return {static_cast<const char*>(*memory), static_cast<std::size_t>(size)};
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
    std::string image;
    try {
        const std::lock_guard alone(hdf5_lock());
        const QuietErrors quiet;
        image = file_image(snapshot, file.string() + " (in memory)");
    } catch (const std::bad_alloc&) {
        throw FailureError(file.string() + ": not enough memory to build the file of " +
                           std::to_string(snapshot.size()) + " particles");
    }
    write_whole(file, image);
}

} // namespace meniscus
