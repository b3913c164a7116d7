// For hosts that trap floating-point exceptions, as Fortran codes do by -ffpe-trap=zero,invalid.
// Vectors calculate in lanes that nobody asks for, where 0 / 0 is no fault: so within the bodies of
// a loop traps are held off, and left as they were found, exception flags included. What the
// runtime does outside of its loop raises none.
//     tension.step(view, count, radii, WithHeldTraps<OpenMpLoop>{});
// Costs two moves of a register for each body. The C interface does so by itself.
#pragma once

#include "../simd/instruction_set.hpp"

#include <cstddef>

#if defined(__SSE2_MATH__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Holds off all traps of the calling thread while it lives.
class HeldTraps {
public:
    HeldTraps(const HeldTraps&) = delete;
    HeldTraps& operator=(const HeldTraps&) = delete;

#if defined(__SSE2_MATH__)
    HeldTraps() : before(_mm_getcsr()) {
        _mm_setcsr(before | _MM_MASK_MASK);
    }
    ~HeldTraps() {
        _mm_setcsr(before);
    }

private:
    unsigned before; // control and flags
#else
    HeldTraps() {
        std::feholdexcept(&before);
    }
    ~HeldTraps() {
        std::fesetenv(&before);
    }

private:
    std::fenv_t before;
#endif
};

/// A loop (parallel_loop.hpp) whose bodies run with traps held off.
template <class Loop>
struct WithHeldTraps {
    Loop loop = {};

    [[nodiscard]] int workers() const { return loop.workers(); }

    template <class Body>
    void operator()(std::size_t count, Body&& body) const {
        loop(count, [&](std::size_t begin, std::size_t end, int worker) {
            const HeldTraps held;
            body(begin, end, worker);
        });
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
