#include "vtkhdf.hpp"

#include "errors.hpp"
#include "hdf5_handles.hpp"
#include "snapshot_files.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

// Deflate makes nothing smaller than 1/1032 of its size, so a dataset of more than that was never
// stored in the file that claims it.
constexpr std::uint64_t largest_compression = 1032;

/// An open file, its name and its size, against which claims are checked.
struct Source {
    fs::path path;
    std::uint64_t bytes;
    Handle file;
};

struct Dataset {
    std::string path;
    Handle id;
    Dimensions dimensions;
};

[[noreturn]] void fail(const Source& source, const std::string& where, const std::string& expected,
                       const std::string& found) {
    throw InputError(source.path.string() + ": " + where + ": expected " + expected + ", found " +
                     found);
}

std::string shown(const Dimensions& dimensions) {
    std::string text = dimensions.empty() ? "a single value" : "";
    for (const hsize_t extent : dimensions) {
        text += (text.empty() ? "" : " x ") + std::to_string(extent);
    }
    return text;
}

bool begins_as_hdf5(const fs::path& file) {
    return read_whole(file, 8) == "\x89HDF\r\n\x1a\n";
}

Source open_source(const fs::path& file) {
    if (!begins_as_hdf5(file)) {
        throw InputError(file.string() + ": expected an HDF5 file, found something else");
    }
    Source source{file, fs::file_size(file),
                  Handle(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose)};
    if (source.file < 0) {
        throw InputError(file.string() + ": expected a complete HDF5 file, found one that is " +
                         "truncated, damaged or still being written; make it again");
    }
    return source;
}

/// Whether a group that is there has an entry of that name.
bool exists(const Source& source, const std::string& path) {
    const htri_t found = H5Lexists(source.file, path.c_str(), H5P_DEFAULT);
    if (found < 0) {
        fail(source, path, "a readable entry or none", "a damaged group; make the file again");
    }
    return found > 0;
}

/// Of a dataset that check_claim has let pass.
std::size_t value_count(const Dataset& dataset) {
    return std::accumulate(dataset.dimensions.begin(), dataset.dimensions.end(), std::size_t{1},
                           std::multiplies<>());
}

/// Whether the product of the dimensions is at most `values`; it may exceed every integer.
bool fits(const Dimensions& dimensions, std::uint64_t values) {
    for (const hsize_t extent : dimensions) {
        if (extent > values) {
            return false;
        }
        values /= std::max<hsize_t>(extent, 1);
    }
    return values > 0;
}

/// A chunk that was stored as it is must have its full size: HDF5 1.10 reads past the end of a
/// shorter one. (A compressed chunk has its own checksum.)
void check_chunks(const Source& source, const Dataset& dataset, hsize_t chunk_size) {
    const Handle space(H5Dget_space(dataset.id), H5Sclose);
    hsize_t count = 0;
    bool whole = H5Dget_num_chunks(dataset.id, space, &count) >= 0;
    Dimensions offset(dataset.dimensions.size());
    for (hsize_t i = 0; whole && i < count; ++i) {
        unsigned skipped_filters = 0;
        haddr_t address = 0;
        hsize_t size = 0;
        whole = H5Dget_chunk_info(dataset.id, space, i, offset.data(), &skipped_filters, &address,
                                  &size) >= 0 &&
                (skipped_filters == 0 || size >= chunk_size);
    }
    if (!whole) {
        fail(source, dataset.path, "whole chunks", "a damaged one; make the file again");
    }
}

/// Refuses dimensions that the file's bytes cannot hold, before memory is taken for them.
void check_claim(const Source& source, const Dataset& dataset) {
    if (std::count(dataset.dimensions.begin(), dataset.dimensions.end(), hsize_t{0}) > 0) {
        return; // no values at all
    }
    const Handle type(H5Dget_type(dataset.id), H5Tclose);
    const Handle creation(H5Dget_create_plist(dataset.id), H5Pclose);
    const auto stored = std::min<std::uint64_t>(H5Dget_storage_size(dataset.id), source.bytes);
    const std::size_t size = std::max<std::size_t>(H5Tget_size(type), 1);
    std::uint64_t room = stored / size;
    Dimensions chunk;
    if (H5Pget_layout(creation) == H5D_CHUNKED) {
        chunk.resize(dataset.dimensions.size());
        H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
        room = stored * largest_compression / size;
    }
    if (!fits(dataset.dimensions, room) || !fits(chunk, room)) {
        fail(source, dataset.path, "bytes for " + shown(dataset.dimensions) + " values",
             std::to_string(stored) + " bytes in the file; it is damaged, make it again");
    }
    if (!chunk.empty()) {
        const hsize_t chunk_size =
            std::accumulate(chunk.begin(), chunk.end(), hsize_t{size}, std::multiplies<>());
        check_chunks(source, dataset, chunk_size);
    }
}

Dataset open_dataset(const Source& source, const std::string& path) {
    Dataset dataset{path, Handle(H5Dopen2(source.file, path.c_str(), H5P_DEFAULT), H5Dclose), {}};
    if (dataset.id < 0) {
        fail(source, path, "a dataset", exists(source, path) ? "a damaged entry" : "none");
    }
    const Handle space(H5Dget_space(dataset.id), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0 || H5Sget_simple_extent_type(space) == H5S_NULL) {
        fail(source, path, "values", "an empty data space");
    }
    dataset.dimensions.resize(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space, dataset.dimensions.data(), nullptr);
    check_claim(source, dataset);
    return dataset;
}

bool same_number(hid_t a, hid_t b) {
    return H5Tget_class(a) == H5Tget_class(b) && H5Tget_size(a) == H5Tget_size(b) &&
           (H5Tget_class(a) == H5T_FLOAT || H5Tget_sign(a) == H5Tget_sign(b));
}

/// An empty array of the number type that is stored, whatever its byte order.
template <std::size_t Kind = 0>
ArrayValues empty_values(const Source& source, const Dataset& dataset) {
    if constexpr (Kind < std::variant_size_v<ArrayValues>) {
        using Values = std::variant_alternative_t<Kind, ArrayValues>;
        const Handle stored(H5Dget_type(dataset.id), H5Tclose);
        if (same_number(stored, number_type<typename Values::value_type>())) {
            return Values();
        }
        return empty_values<Kind + 1>(source, dataset);
    } else {
        fail(source, dataset.path, "integers of 1 to 8 bytes, float or double", "another type");
    }
}

/// Reads into memory that has room for value_count() values.
void read_into(const Source& source, const Dataset& dataset, hid_t memory_type, void* values) {
    if (value_count(dataset) > 0 &&
        H5Dread(dataset.id, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) {
        fail(source, dataset.path, "readable numbers", "damaged ones; make the file again");
    }
}

ArrayValues read_numbers(const Source& source, const Dataset& dataset) {
    ArrayValues read = empty_values(source, dataset);
    std::visit(
        [&](auto& values) {
            using Number = typename std::decay_t<decltype(values)>::value_type;
            values.resize(value_count(dataset));
            read_into(source, dataset, number_type<Number>(), values.data());
        },
        read);
    return read;
}

/// A text of fixed or variable length; `read` fetches it with a given type in memory. Empty where
/// there is none.
template <class Read>
std::string read_text(hid_t stored_type, std::size_t most, Read read) {
    if (H5Tget_class(stored_type) != H5T_STRING) {
        return {};
    }
    const Handle type(H5Tcopy(stored_type), H5Tclose);
    if (H5Tis_variable_str(stored_type) > 0) {
        char* text = nullptr;
        const bool fine = read(type, &text) >= 0 && text != nullptr;
        std::string copy(fine ? text : "");
        H5free_memory(text);
        return copy;
    }
    std::string text(std::min(H5Tget_size(stored_type), most), '\0');
    if (H5Tget_size(stored_type) > most || read(type, text.data()) < 0) {
        return {};
    }
    text.erase(text.find_last_not_of('\0') + 1);
    return text;
}

std::string text_attribute(const Source& source, const char* group, const char* name) {
    const Handle attribute(H5Aopen_by_name(source.file, group, name, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    if (attribute < 0) {
        return {};
    }
    const Handle space(H5Aget_space(attribute), H5Sclose);
    if (H5Sget_simple_extent_npoints(space) != 1) {
        return {};
    }
    return read_text(Handle(H5Aget_type(attribute), H5Tclose), source.bytes,
                     [&](hid_t type, void* text) { return H5Aread(attribute, type, text); });
}

std::string text_dataset(const Source& source, const std::string& path) {
    const Dataset dataset = open_dataset(source, path);
    if (!dataset.dimensions.empty()) {
        fail(source, path, "one text", shown(dataset.dimensions) + " values");
    }
    return read_text(Handle(H5Dget_type(dataset.id), H5Tclose), source.bytes,
                     [&](hid_t type, void* text) {
                         return H5Dread(dataset.id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
                     });
}

/// Names in a group, sorted; none where there is no such group.
std::vector<std::string> names_in(const Source& source, const std::string& path) {
    if (!exists(source, path)) {
        return {};
    }
    const Handle group(H5Gopen2(source.file, path.c_str(), H5P_DEFAULT), H5Gclose);
    H5G_info_t info{};
    if (group < 0 || H5Gget_info(group, &info) < 0) {
        fail(source, path, "a group", "a damaged entry");
    }
    std::vector<std::string> names;
    for (hsize_t i = 0; i < info.nlinks; ++i) {
        const auto name = [&](char* text, std::size_t size) {
            return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, text, size,
                                      H5P_DEFAULT);
        };
        const ssize_t length = name(nullptr, 0);
        if (length < 0) {
            fail(source, path, "names of datasets", "damaged ones; make the file again");
        }
        std::string text(static_cast<std::size_t>(length), '\0');
        name(text.data(), text.size() + 1);
        names.push_back(std::move(text));
    }
    return names;
}

void check_grid(const Source& source) {
    const std::string type = text_attribute(source, "/VTKHDF", "Type");
    if (type != grid_type) {
        fail(source, "/VTKHDF attribute Type", std::string(grid_type),
             type.empty() ? "none that is readable" : "'" + type + "', which is not supported");
    }
    std::int64_t version[2] = {0, 0};
    const Handle attribute(
        H5Aopen_by_name(source.file, "/VTKHDF", "Version", H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const bool fine =
        attribute >= 0 &&
        H5Sget_simple_extent_npoints(Handle(H5Aget_space(attribute), H5Sclose)) == 2 &&
        H5Aread(attribute, number_type<std::int64_t>(), version) >= 0;
    if (!fine || version[0] < 1 || version[0] > 2) {
        fail(source, "/VTKHDF attribute Version", "two numbers, the first 1 or 2",
             fine ? std::to_string(version[0]) : "none that is readable");
    }
    if (exists(source, "/VTKHDF/Steps")) {
        fail(source, "/VTKHDF/Steps", "one state a file", "a series; store each state by itself");
    }
}

/// The sum over the partitions of the grid.
std::uint64_t read_count(const Source& source, const std::string& path) {
    const Dataset dataset = open_dataset(source, path);
    std::vector<std::int64_t> counts(value_count(dataset));
    read_into(source, dataset, number_type<std::int64_t>(), counts.data());
    std::uint64_t sum = 0;
    for (const std::int64_t count : counts) {
        const std::uint64_t most = source.bytes * largest_compression - sum;
        if (count < 0 || static_cast<std::uint64_t>(count) > most) {
            fail(source, path, "counts that the file can hold", std::to_string(count));
        }
        sum += static_cast<std::uint64_t>(count);
    }
    return sum;
}

void read_points(const Source& source, Snapshot& snapshot) {
    const std::uint64_t count = read_count(source, "/VTKHDF/NumberOfPoints");
    const Dataset points = open_dataset(source, "/VTKHDF/Points");
    if (points.dimensions != Dimensions{count, 3}) {
        fail(source, points.path, std::to_string(count) + " x 3 coordinates",
             shown(points.dimensions));
    }
    const ArrayValues type = empty_values(source, points);
    const bool single = std::holds_alternative<std::vector<float>>(type);
    if (!single && !std::holds_alternative<std::vector<double>>(type)) {
        fail(source, points.path, "float or double", "integers");
    }
    snapshot.position_precision = single ? Precision::float32 : Precision::float64;
    snapshot.positions.resize(count);
    read_into(source, points, number_type<double>(), snapshot.positions.data());
}

/// A mesh has points too, but they are no particles.
void check_cells(const Source& source) {
    const std::string path = "/VTKHDF/Types";
    if (!exists(source, path)) {
        return;
    }
    const ArrayValues read = read_numbers(source, open_dataset(source, path));
    const auto* types = std::get_if<std::vector<std::uint8_t>>(&read);
    const std::uint64_t count = read_count(source, "/VTKHDF/NumberOfCells");
    if (types == nullptr || types->size() != count) {
        fail(source, path, std::to_string(count) + " cell types of one byte", "something else");
    }
    for (const std::uint8_t type : *types) {
        if (type != vertex_cell && type != poly_vertex_cell) {
            fail(source, path, "particles (vertex cells, type 1)",
                 "cell type " + std::to_string(type) + "; a mesh is no snapshot");
        }
    }
}

void read_point_data(const Source& source, Snapshot& snapshot) {
    for (const std::string& name : names_in(source, "/VTKHDF/PointData")) {
        const Dataset dataset = open_dataset(source, "/VTKHDF/PointData/" + name);
        const Dimensions& found = dataset.dimensions;
        if (found.empty() || found.size() > 2 || found[0] != snapshot.size() ||
            (found.size() == 2 && (found[1] < 1 || found[1] > 1'000'000))) {
            fail(source, dataset.path,
                 std::to_string(snapshot.size()) + " or " + std::to_string(snapshot.size()) +
                     " x components values, as there are particles",
                 shown(found));
        }
        const int components = found.size() == 2 ? static_cast<int>(found[1]) : 1;
        snapshot.point_data.push_back({name, components, read_numbers(source, dataset)});
    }
}

/// A single number of FieldData, where it is stored.
std::optional<double> read_field(const Source& source, const std::string& name) {
    const std::string path = "/VTKHDF/FieldData/" + name;
    if (!exists(source, "/VTKHDF/FieldData") || !exists(source, path)) {
        return std::nullopt;
    }
    const PointArray field{name, 1, read_numbers(source, open_dataset(source, path))};
    const std::vector<double> values = as_doubles(field);
    if (values.size() != 1 || !std::isfinite(values[0])) {
        fail(source, path, "one finite number",
             values.size() == 1 ? number_text(values[0])
                                : std::to_string(values.size()) + " values");
    }
    return values[0];
}

std::optional<double> read_length(const Source& source, const std::string& name) {
    const std::optional<double> length = read_field(source, name);
    if (length && *length <= 0) {
        fail(source, "/VTKHDF/FieldData/" + name, "a positive length in m", number_text(*length));
    }
    return length;
}

void read_field_data(const Source& source, Snapshot& snapshot) {
    snapshot.support_radius = read_length(source, "support_radius");
    snapshot.particle_spacing = read_length(source, "particle_spacing");
    snapshot.time = read_field(source, "time");
    const int suggested = dimension_of(snapshot.positions);
    const double dimension = read_field(source, "dimension").value_or(suggested);
    if (dimension != 2 && dimension != 3) {
        fail(source, "/VTKHDF/FieldData/dimension", "2 or 3", number_text(dimension));
    }
    snapshot.dimension = static_cast<int>(dimension);
}

Positions read_boundary(const Source& source) {
    const Dataset dataset = open_dataset(source, "/meniscus/boundary");
    if (dataset.dimensions.size() != 2 || dataset.dimensions[1] != 3) {
        fail(source, dataset.path, "particles x 3 coordinates", shown(dataset.dimensions));
    }
    if (!std::holds_alternative<std::vector<double>>(empty_values(source, dataset))) {
        fail(source, dataset.path, "double", "another type of number");
    }
    Positions boundary(dataset.dimensions[0]);
    read_into(source, dataset, number_type<double>(), boundary.data());
    return boundary;
}

void read_for_meniscus(const Source& source, Snapshot& snapshot) {
    if (!exists(source, "/meniscus")) {
        return; // written by another program
    }
    const std::string version = text_dataset(source, "/meniscus/format_version");
    if (version != format_version) {
        fail(source, "/meniscus/format_version", std::string(format_version),
             "'" + version + "'; a newer meniscus wrote it, update this one");
    }
    if (exists(source, "/meniscus/scene")) {
        snapshot.scene = text_dataset(source, "/meniscus/scene");
    }
    if (exists(source, "/meniscus/boundary")) {
        snapshot.boundary = read_boundary(source);
    }
    for (const std::string& name : names_in(source, "/meniscus/provenance")) {
        snapshot.provenance[name] = text_dataset(source, "/meniscus/provenance/" + name);
    }
}

} // namespace

bool is_vtkhdf(const fs::path& file) {
    if (!begins_as_hdf5(file)) {
        return false;
    }
    const QuietErrors quiet;
    return exists(open_source(file), "/VTKHDF");
}

Snapshot read_vtkhdf(const fs::path& file) {
    const QuietErrors quiet;
    const Source source = open_source(file);
    check_grid(source);
    Snapshot snapshot;
    read_points(source, snapshot);
    check_cells(source);
    read_point_data(source, snapshot);
    read_field_data(source, snapshot);
    read_for_meniscus(source, snapshot);
    return snapshot;
}

} // namespace meniscus
