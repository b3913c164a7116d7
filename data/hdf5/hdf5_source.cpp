#include "hdf5_source.hpp"

#include "deflate.hpp"
#include "descriptor_driver.hpp"
#include <meniscus/data/text/errors.hpp>

#include <zlib.h>

#include <algorithm>
#include <functional>
#include <new>
#include <numeric>

namespace meniscus {

namespace {

/// Whether the product of the dimensions is at most `values`; it may exceed every integer.
bool fits(const Dimensions& dimensions, std::uint64_t values) {
    for (const hsize_t extent : dimensions) {
        if (extent > values)
            return false;
        values /= std::max<hsize_t>(extent, 1);
    }
    return values > 0;
}

struct Chunk {
    Dimensions offset;
    hsize_t size = 0; ///< bytes in the file
};

/// Bytes that a deflated chunk has when it is inflated; 0 where it is damaged or has far more than
/// `most`.
std::uint64_t inflated_size(const Dataset& dataset, const Chunk& chunk, std::uint64_t max) {
    std::string stored(chunk.size, '\0');
    std::uint32_t skipped_filters = 0;
    z_stream stream = {};
    if (H5Dread_chunk(dataset.id, H5P_DEFAULT, chunk.offset.data(), &skipped_filters,
                      stored.data()) < 0)
        return 0;
    if (inflateInit(&stream) != Z_OK)
        throw std::bad_alloc();
    Bytef inflated[16384];
    stream.next_in = reinterpret_cast<Bytef*>(stored.data());
    stream.avail_in = static_cast<uInt>(stored.size());
    int result = Z_OK;
    while (result == Z_OK && stream.total_out <= max) {
        stream.next_out = inflated;
        stream.avail_out = sizeof inflated;
        result = inflate(&stream, Z_NO_FLUSH);
    }
    inflateEnd(&stream);
    return result == Z_STREAM_END ? stream.total_out : 0;
}

/// Whether the last filter, which is the first to be undone, is deflate, and nothing in the file
/// keeps a checksum of what the dataset says of itself (its header is of version 1).
bool needs_inflating(const Dataset& dataset, hid_t creation) {
    H5O_info_t info;
    const int filters = H5Pget_nfilters(creation);
    std::size_t no_values = 0;
    unsigned flags = 0;
    return filters > 0 &&
           H5Pget_filter2(creation, static_cast<unsigned>(filters - 1), &flags, &no_values, nullptr,
                          0, nullptr, nullptr) == H5Z_FILTER_DEFLATE &&
           (H5Oget_info2(dataset.id, &info, H5O_INFO_HDR) < 0 || info.hdr.version == 1);
}

/// Every chunk must have its full size, as it is stored or after inflating: HDF5 1.10 reads past
/// the end of a shorter one, and takes what lies there for numbers.
void check_chunks(const Hdf5Source& source, const Dataset& dataset, hid_t creation,
                  hsize_t chunk_size) {
    const Handle space(H5Dget_space(dataset.id), H5Sclose);
    const bool has_filters = H5Pget_nfilters(creation) > 0;
    const bool inflate_them = needs_inflating(dataset, creation);
    hsize_t count = 0;
    bool whole = H5Dget_num_chunks(dataset.id, space, &count) >= 0;
    Chunk chunk{Dimensions(dataset.dimensions.size())};
    for (hsize_t i = 0; whole && i < count; ++i) {
        unsigned skipped_filters = 0;
        haddr_t address = 0;
        whole = H5Dget_chunk_info(dataset.id, space, i, chunk.offset.data(), &skipped_filters,
                                  &address, &chunk.size) >= 0 &&
                chunk.size <= source.bytes;
        if (whole && (!has_filters || skipped_filters != 0))
            whole = chunk.size >= chunk_size;
        else if (whole && inflate_them)
            whole = inflated_size(dataset, chunk, chunk_size) == chunk_size;
    }
    if (!whole)
        fail(source, dataset.path, "whole chunks", "a damaged one; make the file again");
}

/// Refuses dimensions that the file's bytes cannot hold, before memory is taken for them.
void check_claim(const Hdf5Source& source, const Dataset& dataset) {
    if (std::count(dataset.dimensions.begin(), dataset.dimensions.end(), hsize_t{0}) > 0)
        return; // no values at all
    const Handle type(H5Dget_type(dataset.id), H5Tclose);
    const Handle creation(H5Dget_create_plist(dataset.id), H5Pclose);
    const auto stored = std::min<std::uint64_t>(H5Dget_storage_size(dataset.id), source.bytes);
    const std::size_t size = std::max<std::size_t>(H5Tget_size(type), 1);
    std::uint64_t room = stored / size;
    Dimensions chunk;
    if (H5Pget_layout(creation) == H5D_CHUNKED) {
        chunk.resize(dataset.dimensions.size());
        H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
        room = stored * max_compression / size;
    }
    if (!fits(dataset.dimensions, room) || !fits(chunk, room)) {
        fail(source, dataset.path, "bytes for " + shown(dataset.dimensions) + " values",
             std::to_string(stored) + " bytes in the file; it is damaged, make it again");
    }
    if (!chunk.empty()) {
        const hsize_t chunk_size =
            std::accumulate(chunk.begin(), chunk.end(), hsize_t{size}, std::multiplies<>());
        check_chunks(source, dataset, creation, chunk_size);
    }
}

/// Links of a kind that leads out of the file, at any step of the path.
void check_links(const Hdf5Source& source, const std::string& path) {
    for (std::size_t end = 0; end < path.size();) {
        end = std::min(path.find('/', end + 1), path.size());
        const std::string step = path.substr(0, end);
        H5L_info_t link;
        if (step == "/")
            continue;
        if (H5Lget_info(source.file, step.c_str(), &link, H5P_DEFAULT) < 0)
            return; // none, or a damaged one, as whoever opens it finds out
        if (link.type != H5L_TYPE_HARD && link.type != H5L_TYPE_SOFT)
            fail(source, step, "values in the file itself",
                 "a link to another file; copy the values into this one (h5repack)");
    }
}

/// Values that lie in other files.
void check_storage(const Hdf5Source& source, const Dataset& dataset) {
    const Handle creation(H5Dget_create_plist(dataset.id), H5Pclose);
    if (H5Pget_layout(creation) == H5D_VIRTUAL || H5Pget_external_count(creation) > 0)
        fail(source, dataset.path, "values in the file itself",
             "a reference to another file; copy the values into this one (h5repack)");
}

herr_t add_name(hid_t /*group*/, const char* name, const H5L_info_t* /*link*/, void* names) {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
}

bool same_number(hid_t a, hid_t b) {
    return H5Tget_class(a) == H5Tget_class(b) && H5Tget_size(a) == H5Tget_size(b) &&
           (H5Tget_class(a) == H5T_FLOAT || H5Tget_sign(a) == H5Tget_sign(b));
}

/// An empty array of the stored type, which is looked for from Kind on.
template <std::size_t Kind = 0>
ArrayValues values_of_type(const Hdf5Source& source, const Dataset& dataset) {
    if constexpr (Kind < std::variant_size_v<ArrayValues>) {
        using Values = std::variant_alternative_t<Kind, ArrayValues>;
        const Handle stored(H5Dget_type(dataset.id), H5Tclose);
        if (same_number(stored, number_type<typename Values::value_type>()))
            return Values();
        return values_of_type<Kind + 1>(source, dataset);
    } else {
        fail(source, dataset.path, "integers of 1 to 8 bytes, float or double", "another type");
    }
}

/// A text of fixed or variable length; `read` fetches it with a given type in memory. Empty where
/// there is none.
template <class Read>
std::string read_text(hid_t stored_type, std::size_t max, Read read) {
    if (H5Tget_class(stored_type) != H5T_STRING)
        return {};
    const Handle type(H5Tcopy(stored_type), H5Tclose);
    if (H5Tis_variable_str(stored_type) > 0) {
        char* text = nullptr;
        const bool fine = read(type, &text) >= 0 && text != nullptr;
        std::string copy(fine ? text : "");
        H5free_memory(text);
        return copy;
    }
    std::string text(std::min(H5Tget_size(stored_type), max), '\0');
    if (H5Tget_size(stored_type) > max || read(type, text.data()) < 0)
        return {};
    text.erase(text.find_last_not_of('\0') + 1);
    return text;
}

} // namespace

void fail(const Hdf5Source& source, const std::string& where, const std::string& expected,
          const std::string& found) {
    const std::string message = where + ": expected " + expected + ", found " + found;
    throw InputError(source.path.string() + ": " + message);
}

std::string shown(const Dimensions& dimensions) {
    std::string text = dimensions.empty() ? "a single value" : "";
    for (const hsize_t extent : dimensions)
        text += (text.empty() ? "" : " x ") + std::to_string(extent);
    return text;
}

Hdf5Source open_source(const OpenedFile& file) {
    // Names in a file may lead nowhere else, be it to another file or to a program that decodes.
    H5Lunregister(H5L_TYPE_EXTERNAL);
    H5PLset_loading_state(0);
    Hdf5Source source{file.path, file.bytes, open_descriptor(file.descriptor, file.bytes)};
    if (source.file < 0) {
        throw InputError(file.path.string() + ": expected a complete HDF5 file, found " +
                         "something else, or one that is truncated, damaged or still being "
                         "written; make it again");
    }
    return source;
}

bool exists(const Hdf5Source& source, const std::string& path) {
    check_links(source, path);
    const htri_t found = H5Lexists(source.file, path.c_str(), H5P_DEFAULT);
    if (found < 0)
        fail(source, path, "a readable entry or none", "a damaged group; make the file again");
    return found > 0;
}

std::vector<std::string> names_in(const Hdf5Source& source, const std::string& path) {
    if (!exists(source, path))
        return {};
    const Handle group(H5Gopen2(source.file, path.c_str(), H5P_DEFAULT), H5Gclose);
    if (group < 0)
        fail(source, path, "a group", "a damaged entry");
    std::vector<std::string> names;
    hsize_t first = 0;
    if (H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &first, add_name, &names) < 0)
        fail(source, path, "names of datasets", "damaged ones; make the file again");
    for (std::size_t i = 1; i < names.size(); ++i)
        if (names[i] <= names[i - 1])
            fail(source, path, "names that are sorted and differ",
                 "'" + names[i] + "' out of order");
    return names;
}

std::vector<std::string> array_names_in(const Hdf5Source& source, const std::string& path) {
    std::vector<std::string> names = names_in(source, path);
    if (names.size() > max_arrays)
        fail(source, path, "at most " + std::to_string(max_arrays) + " arrays",
             std::to_string(names.size()));
    return names;
}

Dataset open_dataset(const Hdf5Source& source, const std::string& path) {
    check_links(source, path);
    Dataset dataset{path, Handle(H5Dopen2(source.file, path.c_str(), H5P_DEFAULT), H5Dclose), {}};
    if (dataset.id < 0)
        fail(source, path, "a dataset", exists(source, path) ? "a damaged entry" : "none");
    check_storage(source, dataset);
    const Handle space(H5Dget_space(dataset.id), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0 || H5Sget_simple_extent_type(space) == H5S_NULL)
        fail(source, path, "values", "an empty data space");
    dataset.dimensions.resize(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space, dataset.dimensions.data(), nullptr);
    check_claim(source, dataset);
    return dataset;
}

std::size_t value_count(const Dataset& dataset) {
    return std::accumulate(dataset.dimensions.begin(), dataset.dimensions.end(), std::size_t{1},
                           std::multiplies<>());
}

ArrayValues empty_values(const Hdf5Source& source, const Dataset& dataset) {
    return values_of_type(source, dataset);
}

void read_into(const Hdf5Source& source, const Dataset& dataset, hid_t memory_type, void* values) {
    if (value_count(dataset) > 0 &&
        H5Dread(dataset.id, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        fail(source, dataset.path, "readable numbers", "damaged ones; make the file again");
}

void read_into(const Hdf5Source& source, const Dataset& dataset, const Rows& rows,
               hid_t memory_type, void* values) {
    if (rows.count == 0 || value_count(dataset) == 0)
        return;
    Dimensions first(dataset.dimensions.size());
    Dimensions count = dataset.dimensions;
    first[0] = rows.first;
    count[0] = rows.count;
    const Handle in_file(H5Dget_space(dataset.id), H5Sclose);
    const Handle in_memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                           H5Sclose);
    if (H5Sselect_hyperslab(in_file, H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr) <
            0 ||
        H5Dread(dataset.id, memory_type, in_memory, in_file, H5P_DEFAULT, values) < 0)
        fail(source, dataset.path, "readable numbers", "damaged ones; make the file again");
}

ArrayValues read_numbers(const Hdf5Source& source, const Dataset& dataset, const Rows& rows) {
    ArrayValues read = empty_values(source, dataset);
    const std::size_t width =
        value_count(dataset) / std::max<std::size_t>(dataset.dimensions.at(0), 1);
    std::visit(
        [&](auto& values) {
            using Number = typename std::decay_t<decltype(values)>::value_type;
            values.resize(rows.count * width);
            read_into(source, dataset, rows, number_type<Number>(), values.data());
        },
        read);
    return read;
}

ArrayValues read_numbers(const Hdf5Source& source, const Dataset& dataset) {
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

ArrayValues read_row(const Hdf5Source& source, const Dataset& dataset, std::uint64_t index) {
    Dimensions begin(dataset.dimensions.size(), 0);
    Dimensions count = dataset.dimensions;
    begin[0] = index;
    count[0] = 1;
    const Handle space(H5Dget_space(dataset.id), H5Sclose);
    const Handle row(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                     H5Sclose);
    ArrayValues read = empty_values(source, dataset);
    std::visit(
        [&](auto& values) {
            using Number = typename std::decay_t<decltype(values)>::value_type;
            values.resize(value_count(dataset) / dataset.dimensions[0]);
            if (!values.empty() && (H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(),
                                                        nullptr, count.data(), nullptr) < 0 ||
                                    H5Dread(dataset.id, number_type<Number>(), row, space,
                                            H5P_DEFAULT, values.data()) < 0))
                fail(source, dataset.path, "readable numbers", "damaged ones; make the file again");
        },
        read);
    return read;
}

std::string text_dataset(const Hdf5Source& source, const std::string& path) {
    const Dataset dataset = open_dataset(source, path);
    if (!dataset.dimensions.empty())
        fail(source, path, "one text", shown(dataset.dimensions) + " values");
    return read_text(Handle(H5Dget_type(dataset.id), H5Tclose), source.bytes,
                     [&](hid_t type, void* text) {
                         return H5Dread(dataset.id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
                     });
}

std::string text_attribute(const Hdf5Source& source, const char* group, const char* name) {
    const Handle attribute(H5Aopen_by_name(source.file, group, name, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    if (attribute < 0)
        return {};
    const Handle space(H5Aget_space(attribute), H5Sclose);
    if (H5Sget_simple_extent_npoints(space) != 1)
        return {};
    return read_text(Handle(H5Aget_type(attribute), H5Tclose), source.bytes,
                     [&](hid_t type, void* text) { return H5Aread(attribute, type, text); });
}

} // namespace meniscus
