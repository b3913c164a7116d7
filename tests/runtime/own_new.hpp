// operator new of a test program's own: every allocation goes through allocate(), which the one
// file that includes this defines. It returns memory of malloc, or throws.
#pragma once

#include <cstdlib>
#include <new>

void* allocate(std::size_t size);

void* operator new(std::size_t size) {
    return allocate(size);
}
void* operator new[](std::size_t size) {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
