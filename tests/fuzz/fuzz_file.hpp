// What the fuzz targets share. A reader takes a path, so the fuzzer's bytes go to a file that lies
// in memory; the reader either refuses them with an InputError or returns a snapshot that holds
// what the rest of the project relies on. Anything else ends the process, which the fuzzer reports.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <variant>

namespace meniscus {

/// Ends the process where `holds` is false.
inline void require(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "not so: %s\n", what);
        std::abort();
    }
}

/// The path of a regular file of these bytes; the same file at each call.
inline std::filesystem::path file_of(const std::uint8_t* data, std::size_t size) {
    static const int descriptor = memfd_create("fuzz", MFD_CLOEXEC);
    require(descriptor >= 0 && ftruncate(descriptor, 0) == 0 &&
                pwrite(descriptor, data, size, 0) == static_cast<ssize_t>(size),
            "the file in memory can be written");
    return "/proc/self/fd/" + std::to_string(descriptor);
}

inline void check_invariants(const Snapshot& snapshot) {
    require(snapshot.dimension == 2 || snapshot.dimension == 3, "the dimension is 2 or 3");
    require(!snapshot.support_radius || *snapshot.support_radius > 0,
            "the support radius is positive");
    std::set<std::string> names;
    for (const PointArray& array : snapshot.point_data) {
        const std::size_t values =
            std::visit([](const auto& numbers) { return numbers.size(); }, array.values);
        require(array.components >= 1, "an array has components");
        require(values == snapshot.size() * static_cast<std::size_t>(array.components),
                "an array has a value for each particle and component");
        require(names.insert(array.name).second, "names of arrays are unique");
    }
}

/// Calls `reader(file)` on a file of these bytes and checks the snapshot that it returns. To be
/// returned by LLVMFuzzerTestOneInput.
template <class Reader>
int run_reader(const std::uint8_t* data, std::size_t size, Reader reader) {
    const std::filesystem::path file = file_of(data, size);
    try {
        check_invariants(reader(file));
    } catch (const InputError& error) {
        require(std::string(error.what()).find('\n') == std::string::npos,
                "an error message is one line");
    }
    return 0;
}

} // namespace meniscus
