#include "descriptor_driver.hpp"

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <new>
#include <string_view>
#include <unistd.h>

namespace meniscus {
namespace {

/// What the property list that a file is opened with tells this driver.
struct Given {
    int descriptor;
    std::uint64_t bytes;
    FileBeingWritten* written; ///< null where the file is read
};

/// HDF5's part comes first, as it demands.
struct OpenFile {
    H5FD_t common;
    Given given;
    haddr_t end; ///< of what HDF5 has given a meaning
};

const OpenFile& ours(const H5FD_t* file) {
    return *reinterpret_cast<const OpenFile*>(file);
}

/// The one name that is opened; names in the file are of others.
constexpr std::string_view only_name = "the descriptor";

H5FD_t* open_file(const char* name, unsigned flags, hid_t access, haddr_t /*max*/) {
    const auto* given = static_cast<const Given*>(H5Pget_driver_info(access));
    const bool writes = (flags & H5F_ACC_RDWR) != 0;
    if (given == nullptr || name != only_name || writes != (given->written != nullptr))
        return nullptr;
    auto* file = new (std::nothrow) OpenFile{};
    if (file == nullptr)
        return nullptr;
    file->given = *given;
    return &file->common;
}

/// As HDF5's driver for files in memory has them, so that files are laid out alike.
herr_t tell_features_of_output(const H5FD_t* /*file*/, unsigned long* features) {
    *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA |
                H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

herr_t close_file(H5FD_t* file) {
    delete reinterpret_cast<OpenFile*>(file);
    return 0;
}

herr_t tell_features(const H5FD_t* /*file*/, unsigned long* features) {
    *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA_READ |
                H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

haddr_t end_of_meaning(const H5FD_t* file, H5FD_mem_t /*type*/) {
    return ours(file).end;
}

herr_t set_end_of_meaning(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t end) {
    reinterpret_cast<OpenFile*>(file)->end = end;
    return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t /*type*/) {
    return ours(file).given.bytes;
}

int last_error_of_reading = 0; ///< of a child that reads one file, in one thread

/// What lies behind the end of the file reads as zeros, as with HDF5's own driver.
herr_t read_bytes(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t address,
                  std::size_t size, void* buffer) {
    auto* bytes = static_cast<char*>(buffer);
    // Damaged files have addresses that the system would not even take.
    if (address >= ours(file).given.bytes) {
        std::fill_n(bytes, size, '\0');
        return 0;
    }
    while (size > 0) {
        const ssize_t count =
            pread(ours(file).given.descriptor, bytes, size, static_cast<off_t>(address));
        if (count < 0 && errno != EINTR) {
            last_error_of_reading = errno;
            return -1;
        }
        if (count == 0) {
            std::fill_n(bytes, size, '\0');
            return 0;
        }
        if (count > 0) {
            bytes += count;
            address += static_cast<haddr_t>(count);
            size -= static_cast<std::size_t>(count);
        }
    }
    return 0;
}

herr_t refuse_to_write(H5FD_t* /*file*/, H5FD_mem_t /*type*/, hid_t /*transfer*/,
                       haddr_t /*address*/, std::size_t /*size*/, const void* /*buffer*/) {
    return -1;
}

herr_t write_bytes(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t address,
                   std::size_t size, const void* buffer) {
    Given& given = reinterpret_cast<OpenFile*>(file)->given;
    const auto* bytes = static_cast<const char*>(buffer);
    if (given.written->is_finished)
        return 0;
    while (size > 0) {
        const ssize_t count = pwrite(given.descriptor, bytes, size, static_cast<off_t>(address));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0) {
            given.written->error = errno;
            given.written->is_finished = true; // so that HDF5 can close it
            return -1;
        }
        bytes += count;
        address += static_cast<haddr_t>(count);
        size -= static_cast<std::size_t>(count);
    }
    given.bytes = std::max<std::uint64_t>(given.bytes, address);
    return 0;
}

herr_t note_end_of_output(H5FD_t* file, H5FD_mem_t type, haddr_t end) {
    if (FileBeingWritten& written = *ours(file).given.written; !written.is_finished)
        written.bytes = end;
    return set_end_of_meaning(file, type, end);
}

/// Nobody else knows the file yet. A driver that can lock files has HDF5 mark them as open for
/// writing, as it marks those in memory.
herr_t lock_nothing(H5FD_t* /*file*/, hbool_t /*writes*/) {
    return 0;
}

herr_t unlock_nothing(H5FD_t* /*file*/) {
    return 0;
}

H5FD_class_t driver() {
    constexpr H5FD_mem_t shared_lists[] = H5FD_FLMAP_DICHOTOMY;
    H5FD_class_t driver = {};
    driver.name = "meniscus_descriptor";
    driver.maxaddr = HADDR_MAX;
    driver.fc_degree = H5F_CLOSE_WEAK;
    driver.fapl_size = sizeof(Given);
    driver.open = open_file;
    driver.close = close_file;
    driver.query = tell_features;
    driver.get_eoa = end_of_meaning;
    driver.set_eoa = set_end_of_meaning;
    driver.get_eof = end_of_file;
    driver.read = read_bytes;
    driver.write = refuse_to_write;
    std::copy(std::begin(shared_lists), std::end(shared_lists), driver.fl_map);
    return driver;
}

H5FD_class_t driver_of_output() {
    H5FD_class_t output = driver();
    output.name = "meniscus_output";
    output.query = tell_features_of_output;
    output.set_eoa = note_end_of_output;
    output.write = write_bytes;
    output.lock = lock_nothing;
    output.unlock = unlock_nothing;
    return output;
}

} // namespace

int error_of_reading() {
    return last_error_of_reading;
}

Handle open_descriptor(int descriptor, std::uint64_t bytes) {
    static const H5FD_class_t kept = driver(); // HDF5 reads it as long as the driver is known
    const Handle known(H5FDregister(&kept), H5FDunregister);
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    const Given given = {descriptor, bytes, nullptr};
    if (known < 0 || access < 0 || H5Pset_driver(access, known, &given) < 0)
        throw std::bad_alloc();
    return {H5Fopen(only_name.data(), H5F_ACC_RDONLY, access), H5Fclose};
}

Handle create_on_descriptor(int descriptor, FileBeingWritten& written, hid_t creation,
                            hid_t access) {
    static const H5FD_class_t kept = driver_of_output();
    const Handle known(H5FDregister(&kept), H5FDunregister);
    const Given given = {descriptor, 0, &written};
    if (known < 0 || H5Pset_driver(access, known, &given) < 0)
        throw std::bad_alloc();
    return {H5Fcreate(only_name.data(), H5F_ACC_TRUNC, creation, access), H5Fclose};
}

} // namespace meniscus
