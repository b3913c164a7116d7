// Values as bytes, for other ranks of the same program: one function carry(pack, value) serves both
// ends, so that they cannot disagree.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace meniscus {

/// Appends what it is given to `bytes`.
class Packer {
public:
    std::string bytes;

    template <class Number>
    void number(const Number& value) {
        static_assert(std::is_trivially_copyable_v<Number>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }

    template <class Container>
    void size(const Container& container) {
        number(std::uint64_t{container.size()});
    }

    void text(const std::string& letters) {
        size(letters);
        bytes += letters;
    }
};

/// Takes out, in the same order, what a Packer has put in. Throws std::out_of_range where there is
/// less.
class Unpacker {
public:
    explicit Unpacker(std::string_view packed) : bytes(packed) {}

    template <class Number>
    void number(Number& value) {
        static_assert(std::is_trivially_copyable_v<Number>);
        if (bytes.size() < sizeof value)
            throw std::out_of_range("less was sent than is expected");
        std::memcpy(&value, bytes.data(), sizeof value);
        bytes.remove_prefix(sizeof value);
    }

    template <class Container>
    void size(Container& container) {
        std::uint64_t count = 0;
        number(count);
        if (count > bytes.size())
            throw std::out_of_range("less was sent than is expected");
        container.resize(count);
    }

    void text(std::string& letters) {
        size(letters);
        letters.assign(bytes.substr(0, letters.size()));
        bytes.remove_prefix(letters.size());
    }

    [[nodiscard]] bool is_empty() const { return bytes.empty(); }

private:
    std::string_view bytes;
};

template <class Pack>
void carry(Pack& pack, std::string& text) {
    pack.text(text);
}

template <class Pack>
void carry(Pack& pack, std::optional<double>& value) {
    bool is_there = value.has_value();
    double number = value.value_or(0);
    pack.number(is_there);
    pack.number(number);
    if (is_there)
        value = number;
}

/// Numbers, or values that have a carry() of their own.
template <class Pack, class Value>
void carry(Pack& pack, std::vector<Value>& values) {
    pack.size(values);
    for (Value& value : values)
        if constexpr (std::is_arithmetic_v<Value>)
            pack.number(value);
        else
            carry(pack, value);
}

template <class Value>
std::string packed(Value value) {
    Packer packer;
    carry(packer, value);
    return packer.bytes;
}

template <class Value>
Value unpacked(std::string_view bytes) {
    Value value;
    Unpacker unpacker(bytes);
    carry(unpacker, value);
    return value;
}

} // namespace meniscus
