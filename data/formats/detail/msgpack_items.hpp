// MessagePack, item by item (https://github.com/msgpack/msgpack/blob/master/spec.md): numbers,
// texts, and the heads of arrays and maps, whose items follow. Nothing is built in memory, so that
// what a file claims to hold costs nothing before it is there.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace meniscus {

struct MsgpackItem {
    enum class Kind { nothing, boolean, integer, real, text, array, map, extension };
    Kind kind = Kind::nothing;
    double number = 0;           ///< of a boolean, integer or real
    std::uint64_t count = 0;     ///< items of an array, pairs of a map
    std::string_view bytes = {}; ///< of a text (str or bin), or an extension
};

/// The next item of `rest`, which is shortened by it; none where the bytes end before it does, or
/// begin no item.
std::optional<MsgpackItem> take_item(std::string_view& rest);

/// Takes the next item with all that it holds; false where the bytes end before it does.
bool skip_item(std::string_view& rest);

} // namespace meniscus
