#include "number_blocks.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace meniscus {
namespace {

template <std::size_t Kind = 0>
ArrayValues make_values(std::size_t kind) {
    if constexpr (Kind + 1 < std::variant_size_v<ArrayValues>)
        if (kind != Kind)
            return make_values<Kind + 1>(kind);
    return std::variant_alternative_t<Kind, ArrayValues>{};
}

template <class Number>
Number number_at(const char* stored, bool big_endian) {
    char bytes[sizeof(Number)];
    if (big_endian)
        std::reverse_copy(stored, stored + sizeof(Number), bytes);
    else
        std::copy_n(stored, sizeof(Number), bytes);
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return number;
}

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

} // namespace

std::size_t size_of(NumberType type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

ArrayValues values_of(NumberType type) {
    return make_values(static_cast<std::size_t>(type));
}

std::size_t count_of(const ArrayValues& values) {
    return std::visit([](const auto& numbers) { return numbers.size(); }, values);
}

void append_stored(ArrayValues& values, const char* stored, bool big_endian) {
    std::visit(
        [&](auto& numbers) {
            using Number = typename std::decay_t<decltype(numbers)>::value_type;
            numbers.push_back(number_at<Number>(stored, big_endian));
        },
        values);
}

bool append_word(ArrayValues& values, std::string_view word) {
    return std::visit(
        [&](auto& numbers) {
            typename std::decay_t<decltype(numbers)>::value_type number{};
            if (read_number(word, number) != std::errc())
                return false;
            numbers.push_back(number);
            return true;
        },
        values);
}

ArrayValues decoded(NumberType type, std::string_view block, bool big_endian) {
    ArrayValues values = values_of(type);
    for (std::size_t at = 0; at + size_of(type) <= block.size(); at += size_of(type))
        append_stored(values, block.data() + at, big_endian);
    return values;
}

std::string_view take_word(std::string_view& text) {
    const auto* const begin = std::find_if_not(text.begin(), text.end(), is_space);
    const auto* const end = std::find_if(begin, text.end(), is_space);
    const std::string_view word = text.substr(static_cast<std::size_t>(begin - text.begin()),
                                              static_cast<std::size_t>(end - begin));
    text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    return word;
}

void set_positions(Snapshot& snapshot, const ArrayValues& values, std::size_t components) {
    snapshot.position_precision = std::holds_alternative<std::vector<float>>(values)
                                      ? Precision::float32
                                      : Precision::float64;
    std::visit(
        [&](const auto& coordinates) {
            for (std::size_t i = 0; i + components <= coordinates.size(); i += components) {
                std::array<double, 3> position{};
                for (std::size_t axis = 0; axis < components; ++axis)
                    position[axis] = static_cast<double>(coordinates[i + axis]);
                snapshot.positions.push_back(position);
            }
        },
        values);
    snapshot.dimension_is_stated = components == 2;
    snapshot.dimension = components == 2 ? 2 : dimension_of(snapshot.positions);
}

} // namespace meniscus
