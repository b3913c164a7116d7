// Blocks of numbers of one type, as bytes of either order or as words of text. For formats that
// name their types: VTK XML, PLY and NumPy.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace meniscus {

/// The kinds of numbers that arrays hold, by their place in ArrayValues.
enum class NumberType : std::size_t {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};

std::size_t size_of(NumberType type);

/// Empty values of that type.
ArrayValues values_of(NumberType type);

std::size_t count_of(const ArrayValues& values);

/// Adds the number that the bytes at `stored` stand for.
void append_stored(ArrayValues& values, const char* stored, bool big_endian);

/// Adds the number that the word stands for; false where it is none that the type holds.
bool append_word(ArrayValues& values, std::string_view word);

/// All numbers of a block of bytes.
ArrayValues decoded(NumberType type, std::string_view block, bool big_endian);

/// The next word of a text, which is shortened by it; empty at its end.
std::string_view take_word(std::string_view& text);

/// Positions of `components` (2 or 3) values a particle, sets their precision, and the dimension
/// where there are two.
void set_positions(Snapshot& snapshot, const ArrayValues& values, std::size_t components);

} // namespace meniscus
