#include "msgpack_items.hpp"

#include <cstddef>
#include <cstring>

namespace meniscus {
namespace {

using Kind = MsgpackItem::Kind;

/// The number of that many bytes, the highest first; none where there are fewer.
std::optional<std::uint64_t> take_integer(std::string_view& rest, std::size_t bytes) {
    if (rest.size() < bytes)
        return {};
    std::uint64_t value = 0;
    for (const char byte : rest.substr(0, bytes))
        value = value << 8 | static_cast<unsigned char>(byte);
    rest.remove_prefix(bytes);
    return value;
}

template <class Real, class Bits>
double real_of(std::uint64_t value) {
    const auto bits = static_cast<Bits>(value);
    Real real;
    std::memcpy(&real, &bits, sizeof real);
    return real;
}

/// An integer of that many bytes with the highest bit as its sign.
double signed_of(std::uint64_t value, std::size_t bytes) {
    const unsigned unused = 64 - 8 * static_cast<unsigned>(bytes);
    return static_cast<double>(static_cast<std::int64_t>(value << unused) >> unused);
}

std::optional<MsgpackItem> take_number(std::string_view& rest, unsigned char head) {
    const std::size_t bytes = head == 0xca ? 4 : head == 0xcb ? 8 : std::size_t{1} << (head & 3);
    const auto value = take_integer(rest, bytes);
    if (!value)
        return {};
    if (head == 0xca)
        return MsgpackItem{Kind::real, real_of<float, std::uint32_t>(*value)};
    if (head == 0xcb)
        return MsgpackItem{Kind::real, real_of<double, std::uint64_t>(*value)};
    return MsgpackItem{Kind::integer,
                       head >= 0xd0 ? signed_of(*value, bytes) : static_cast<double>(*value)};
}

std::optional<MsgpackItem> take_bytes(std::string_view& rest, Kind kind,
                                      std::optional<std::uint64_t> size) {
    const std::size_t type = kind == Kind::extension ? 1 : 0;
    if (!size || rest.size() < type || *size > rest.size() - type)
        return {};
    MsgpackItem item{kind};
    item.bytes = rest.substr(type, *size);
    rest.remove_prefix(type + *size);
    return item;
}

std::optional<MsgpackItem> take_head(Kind kind, std::optional<std::uint64_t> count) {
    if (!count)
        return {};
    MsgpackItem item{kind};
    item.count = *count;
    return item;
}

/// What begins with a byte from 0xc0 to 0xdf.
std::optional<MsgpackItem> take_named(std::string_view& rest, unsigned char head) {
    if (head == 0xc0)
        return MsgpackItem{};
    if (head == 0xc2 || head == 0xc3)
        return MsgpackItem{Kind::boolean, head == 0xc3 ? 1.0 : 0.0};
    if (head >= 0xc4 && head <= 0xc6)
        return take_bytes(rest, Kind::text, take_integer(rest, std::size_t{1} << (head - 0xc4)));
    if (head >= 0xc7 && head <= 0xc9)
        return take_bytes(rest, Kind::extension,
                          take_integer(rest, std::size_t{1} << (head - 0xc7)));
    if (head >= 0xca && head <= 0xd3)
        return take_number(rest, head);
    if (head >= 0xd4 && head <= 0xd8)
        return take_bytes(rest, Kind::extension, std::uint64_t{1} << (head - 0xd4));
    if (head >= 0xd9 && head <= 0xdb)
        return take_bytes(rest, Kind::text, take_integer(rest, std::size_t{1} << (head - 0xd9)));
    if (head == 0xdc || head == 0xdd)
        return take_head(Kind::array, take_integer(rest, head == 0xdc ? 2 : 4));
    if (head == 0xde || head == 0xdf)
        return take_head(Kind::map, take_integer(rest, head == 0xde ? 2 : 4));
    return {};
}

} // namespace

std::optional<MsgpackItem> take_item(std::string_view& rest) {
    const auto first = take_integer(rest, 1);
    if (!first)
        return {};
    const auto head = static_cast<unsigned char>(*first);
    if (head < 0x80)
        return MsgpackItem{Kind::integer, static_cast<double>(head)};
    if (head < 0x90)
        return take_head(Kind::map, head & 15U);
    if (head < 0xa0)
        return take_head(Kind::array, head & 15U);
    if (head < 0xc0)
        return take_bytes(rest, Kind::text, head & 31U);
    if (head >= 0xe0)
        return MsgpackItem{Kind::integer, signed_of(head, 1)};
    return take_named(rest, head);
}

bool skip_item(std::string_view& rest) {
    for (std::uint64_t missing = 1; missing > 0; --missing) {
        const auto item = take_item(rest);
        if (!item)
            return false;
        missing += item->kind == Kind::map ? 2 * item->count : item->count;
    }
    return true;
}

} // namespace meniscus
