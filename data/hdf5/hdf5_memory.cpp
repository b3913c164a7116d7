#include "hdf5_memory.hpp"

#include "hdf5_handles.hpp"

#include <hdf5.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace meniscus {
namespace {

std::atomic<bool> lacked_memory{false};

herr_t note_entry(unsigned /*place*/, const H5E_error2_t* error, void* /*nothing*/) {
    if (error->min_num == H5E_NOSPACE || error->min_num == H5E_CANTALLOC)
        lacked_memory = true;
    return 0;
}

bool has_memory_to_start() {
    void* tried = std::malloc(std::size_t{1} << 20);
    std::free(tried);
    return tried != nullptr && H5open() >= 0;
}

} // namespace

void start_hdf5() {
    static const bool started = has_memory_to_start();
    if (!started)
        throw std::bad_alloc();
}

void leave_hdf5_as_it_is() {
    H5dont_atexit();
}

herr_t note_want_of_memory(hid_t stack, void* /*nothing*/) {
    return H5Ewalk2(stack, H5E_WALK_DOWNWARD, note_entry, nullptr);
}

bool hdf5_lacked_memory() {
    return lacked_memory;
}

} // namespace meniscus
