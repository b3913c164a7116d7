// The list of formats that are kept in HDF5 files, which only the groups in them tell apart: a new
// one is its file, with a function that is declared here, and its place in the list.
#pragma once

#include <meniscus/data/formats/read_choices.hpp>
#include <meniscus/data/hdf5/hdf5_source.hpp>

namespace meniscus {

struct Hdf5Format {
    const char* name; ///< as messages give it
    bool (*holds)(const Hdf5Source& source);
    Snapshot (*read)(const Hdf5Source& source, const ReadChoices& choices);
    bool holds_frames = false; ///< as in SnapshotFormat
};

Hdf5Format vtkhdf_format();
Hdf5Format pysph_format();
Hdf5Format gadget_format();
Hdf5Format h5part_format();
Hdf5Format lagrangebench_format();

/// In the order in which a file is tried.
inline std::vector<Hdf5Format> hdf5_formats() {
    return {vtkhdf_format(), pysph_format(), gadget_format(), h5part_format(),
            lagrangebench_format()};
}

} // namespace meniscus
