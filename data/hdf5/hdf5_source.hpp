// An open HDF5 file whose contents are not trusted: every dataset's claims are checked against the
// bytes that the file has before memory is taken for them, what would lead to other files is
// refused, and every error names the file and what in it is wrong. What HDF5 itself does on damaged
// files no check can foresee, so all of this runs in a process of its own (see isolated_read.hpp).
// For the sources of data/ only.
#pragma once

#include "hdf5_handles.hpp"
#include "isolated_read.hpp"
#include <meniscus/data/particles/snapshot.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace meniscus {

/// An open file, its name and its size, against which claims are checked.
struct Hdf5Source {
    std::filesystem::path path;
    std::uint64_t bytes;
    Handle file;
    std::string metadata =
        {}; ///< of metadata.json beside it, as read before; empty where there is none
};

/// A dataset whose dimensions the file can hold.
struct Dataset {
    std::string path;
    Handle id;
    Dimensions dimensions;
};

/// Throws the InputError that names the file and `where` in it.
[[noreturn]] void fail(const Hdf5Source& source, const std::string& where,
                       const std::string& expected, const std::string& found);

/// Dimensions for a message: "26136 x 3".
std::string shown(const Dimensions& dimensions);

/// Throws InputError where the file is not a whole HDF5 file. To be called in a process of its own,
/// whose HDF5 library follows no links to other files and loads no filters from then on.
Hdf5Source open_source(const OpenedFile& file);

/// Whether a group that is there has an entry of that name.
bool exists(const Hdf5Source& source, const std::string& path);

/// Names in a group, sorted; none where there is no such group.
std::vector<std::string> names_in(const Hdf5Source& source, const std::string& path);

/// The same for names of arrays; throws InputError where there are more than a state has.
std::vector<std::string> array_names_in(const Hdf5Source& source, const std::string& path);

/// Throws InputError where there is no such dataset, where its values lie in another file, or where
/// the file cannot hold what it claims.
Dataset open_dataset(const Hdf5Source& source, const std::string& path);

std::size_t value_count(const Dataset& dataset);

/// An empty array of the number type that is stored, whatever its byte order. Throws InputError
/// where that is none of ArrayValues.
ArrayValues empty_values(const Hdf5Source& source, const Dataset& dataset);

/// Reads into memory that has room for value_count() values.
void read_into(const Hdf5Source& source, const Dataset& dataset, hid_t memory_type, void* values);

/// Some of the rows of a dataset of particles: those from `first` on. The dataset must have them.
struct Rows {
    std::uint64_t first;
    std::uint64_t count;
};

/// Reads these rows into memory that has room for them.
void read_into(const Hdf5Source& source, const Dataset& dataset, const Rows& rows,
               hid_t memory_type, void* values);

/// All values of these rows in their stored type.
ArrayValues read_numbers(const Hdf5Source& source, const Dataset& dataset, const Rows& rows);

/// All values in their stored type.
ArrayValues read_numbers(const Hdf5Source& source, const Dataset& dataset);

/// The values at one index of the first dimension, which the dataset must have.
ArrayValues read_row(const Hdf5Source& source, const Dataset& dataset, std::uint64_t index);

/// The one text of a dataset; empty where it is no text.
std::string text_dataset(const Hdf5Source& source, const std::string& path);

/// The one text of an attribute; empty where there is none.
std::string text_attribute(const Hdf5Source& source, const char* group, const char* name);

/// The numbers of an attribute; none where there is no such attribute, where it is no number, or no
/// whole one that must be. At most `max` of them.
template <class Number>
std::vector<Number> number_attribute(const Hdf5Source& source, const char* group, const char* name,
                                     std::size_t max) {
    const Handle attribute(H5Aopen_by_name(source.file, group, name, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    if (attribute < 0)
        return {};
    const Handle type(H5Aget_type(attribute), H5Tclose);
    if (std::is_integral_v<Number> && H5Tget_class(type) != H5T_INTEGER)
        return {};
    const Handle space(H5Aget_space(attribute), H5Sclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (count < 1 || static_cast<std::size_t>(count) > max)
        return {};
    std::vector<Number> numbers(static_cast<std::size_t>(count));
    if (H5Aread(attribute, number_type<Number>(), numbers.data()) < 0)
        return {};
    return numbers;
}

} // namespace meniscus
