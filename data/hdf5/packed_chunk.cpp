#include "packed_chunk.hpp"

#include <cstring>
#include <new>
#include <zlib.h>

namespace meniscus {
namespace {

std::string shuffled(const char* numbers, std::size_t bytes, std::size_t number_size,
                     std::size_t chunk_bytes) {
    std::string planes(chunk_bytes, '\0');
    const std::size_t count = bytes / number_size;
    const std::size_t places = chunk_bytes / number_size;
    for (std::size_t byte = 0; byte < number_size; ++byte) {
        char* plane = planes.data() + byte * places;
        for (std::size_t i = 0; i < count; ++i)
            plane[i] = numbers[i * number_size + byte];
    }
    return planes;
}

} // namespace

std::string packed_chunk(const void* numbers, std::size_t bytes, std::size_t number_size,
                         std::size_t chunk_bytes) {
    const std::string planes =
        shuffled(static_cast<const char*>(numbers), bytes, number_size, chunk_bytes);
    uLongf size = compressBound(planes.size());
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                  reinterpret_cast<const Bytef*>(planes.data()), planes.size(),
                  compression_level) != Z_OK)
        throw std::bad_alloc();
    packed.resize(size);
    return packed;
}

} // namespace meniscus
