#include "hdf5_files.hpp"

#include "errors.hpp"
#include "hdf5_source.hpp"
#include "isolated_read.hpp"
#include "snapshot_files.hpp"

#include <fstream>
#include <string>

namespace meniscus {

namespace {

namespace fs = std::filesystem;

struct Hdf5Format {
    const char* name;
    bool (*holds)(const Hdf5Source&);
    Snapshot (*read)(const Hdf5Source&);
};

// A new format in HDF5 is one line here.
constexpr Hdf5Format hdf5_formats[] = {
    {"VTKHDF", holds_vtkhdf, vtkhdf_snapshot},
    {"PySPH", holds_pysph, pysph_snapshot},
};

Snapshot read(const fs::path& file) {
    const Hdf5Source source = open_source(file);
    std::string known;
    for (const Hdf5Format& format : hdf5_formats) {
        if (format.holds(source)) {
            return format.read(source);
        }
        known += (known.empty() ? "" : ", ") + std::string(format.name);
    }
    throw InputError(file.string() + ": expected a snapshot in a known format of HDF5 (" + known +
                     "), found another HDF5 file; export it in one of these");
}

} // namespace

bool is_hdf5(const fs::path& file) {
    const std::string signature = "\x89HDF\r\n\x1a\n";
    if (read_whole(file, signature.size()) == signature) {
        return true;
    }
    std::ifstream stream(file, std::ios::binary);
    std::string found(signature.size(), '\0');
    // Where the format allows it to stand; reading fails at the end of the file.
    for (std::streamoff offset = 512; stream; offset *= 2) {
        stream.seekg(offset);
        if (stream.read(found.data(), static_cast<std::streamsize>(found.size())) &&
            found == signature) {
            return true;
        }
    }
    return false;
}

Snapshot read_hdf5(const fs::path& file) {
    return read_isolated(file, read);
}

} // namespace meniscus
