// DeepLagrangianFluids' records (`.msgpack.zst`): MessagePack, compressed by Zstandard, of a list
// of states. A state is a map in which `pos`, `vel`, `m` and `viscosity` are NumPy arrays, as
// msgpack-numpy writes them; `box` of the first state is the walls.
#include "snapshot_formats.hpp"

#include "detail/frames.hpp"
#include "detail/msgpack_items.hpp"
#include "detail/number_blocks.hpp"
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <zstd.h>

namespace meniscus {
namespace {

namespace fs = std::filesystem;
using Kind = MsgpackItem::Kind;

constexpr std::string_view magic = "\x28\xb5\x2f\xfd";
/// Numbers shrink to a tenth at the most; what claims more is no record of particles.
constexpr std::uint64_t max_compression = 100;

[[noreturn]] void fail(const fs::path& file, const std::string& expected,
                       const std::string& found) {
    throw InputError(file.string() + ": DeepLagrangianFluids' record: expected " + expected +
                     ", found " + found);
}

std::string decompressed(const fs::path& file, const std::string& bytes) {
    const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
    if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN)
        fail(file, "a frame of Zstandard that states its size",
             "none; compress the file again with zstd");
    if (size > bytes.size() * max_compression + 4096)
        fail(file, "numbers of particles",
             std::to_string(size) + " bytes in " + std::to_string(bytes.size()));
    std::string content(size, '\0');
    if (ZSTD_decompress(content.data(), content.size(), bytes.data(), bytes.size()) != size)
        fail(file, "a whole frame of Zstandard", "a damaged one; copy or make the file again");
    return content;
}

/// An array of msgpack-numpy: its rows and columns, and its values where they can be read.
struct NumpyArray {
    std::size_t rows = 0;
    std::size_t columns = 1;
    ArrayValues values;
};

std::optional<NumberType> type_of(std::string_view description) {
    static const std::map<std::string_view, NumberType> types = {
        {"i1", NumberType::int8},   {"u1", NumberType::uint8},  {"i2", NumberType::int16},
        {"u2", NumberType::uint16}, {"i4", NumberType::int32},  {"u4", NumberType::uint32},
        {"i8", NumberType::int64},  {"u8", NumberType::uint64}, {"f4", NumberType::float32},
        {"f8", NumberType::float64}};
    const auto known = types.find(description.substr(std::min<std::size_t>(1, description.size())));
    return known == types.end() ? std::nullopt : std::optional(known->second);
}

/// One or two extents.
bool take_shape(std::string_view& rest, NumpyArray& array) {
    const auto head = take_item(rest);
    if (!head || head->kind != Kind::array || head->count < 1 || head->count > 2)
        return false;
    for (std::uint64_t axis = 0; axis < head->count; ++axis) {
        const auto extent = take_item(rest);
        if (!extent || extent->kind != Kind::integer || extent->number < 0)
            return false;
        (axis == 0 ? array.rows : array.columns) = static_cast<std::size_t>(extent->number);
    }
    return true;
}

/// None where the map that begins here is no array of numbers.
std::optional<NumpyArray> numpy_array(std::string_view rest) {
    const auto head = take_item(rest);
    if (!head || head->kind != Kind::map)
        return {};
    NumpyArray array;
    std::string_view type;
    std::string_view data;
    bool has_shape = false;
    for (std::uint64_t pair = 0; pair < head->count; ++pair) {
        const auto key = take_item(rest);
        std::string_view value = rest;
        if (!key || !skip_item(rest))
            return {};
        if (key->bytes == "shape")
            has_shape = take_shape(value, array);
        else if (key->bytes == "type")
            type = take_item(value)->bytes;
        else if (key->bytes == "data")
            data = take_item(value)->bytes;
    }
    const auto known = type_of(type);
    if (!has_shape || !known)
        return {};
    const std::size_t values = data.size() / size_of(*known);
    if (data.size() % size_of(*known) != 0 || array.columns == 0 || values % array.columns != 0 ||
        values / array.columns != array.rows)
        return {};
    array.values = decoded(*known, data, type.front() == '>');
    return array;
}

/// Where each key of the map that begins here has its value.
std::map<std::string, std::string_view> entries_of(const fs::path& file, std::string_view rest) {
    std::map<std::string, std::string_view> entries;
    const auto head = take_item(rest);
    if (!head || head->kind != Kind::map)
        fail(file, "a map for each state", "something else");
    for (std::uint64_t pair = 0; pair < head->count; ++pair) {
        const auto key = take_item(rest);
        const std::string_view value = rest;
        if (!key || !skip_item(rest))
            fail(file, "whole states", "the end of the file; copy or make it again");
        if (entries.size() < max_arrays)
            entries.emplace(key->bytes, value);
    }
    return entries;
}

Positions points_of(const fs::path& file, const std::string& name, std::string_view value) {
    const auto array = numpy_array(value);
    if (!array || array->columns != 3)
        fail(file, "an array of N x 3 numbers for '" + name + "'", "something else");
    Snapshot points;
    set_positions(points, array->values, 3);
    return points.positions;
}

Snapshot snapshot_of(const fs::path& file, const std::map<std::string, std::string_view>& state) {
    const auto pos = state.find("pos");
    if (pos == state.end())
        fail(file, "'pos' in each state", "none");
    Snapshot snapshot;
    snapshot.positions = points_of(file, "pos", pos->second);
    snapshot.dimension = dimension_of(snapshot.positions);
    if (std::holds_alternative<std::vector<float>>(numpy_array(pos->second)->values))
        snapshot.position_precision = Precision::float32;
    for (const auto& [name, value] : state) {
        auto array = name == "pos" ? std::nullopt : numpy_array(value);
        if (array && array->rows == snapshot.size() && array->columns <= 9)
            snapshot.point_data.push_back(
                {name, static_cast<int>(array->columns), std::move(array->values)});
    }
    std::string_view scene = state.count("scene_id") > 0 ? state.at("scene_id") : "";
    if (const auto item = take_item(scene))
        snapshot.scene = item->bytes;
    return snapshot;
}

bool is_zstd(const fs::path& file) {
    return read_whole(file, magic.size()) == magic;
}

/// Throws InputError on anything else; memory is bounded by the file's own size.
Snapshot read_record(const fs::path& file, const ReadChoices& choices) {
    const std::string content = decompressed(file, read_whole(file));
    std::string_view rest = content;
    const auto head = take_item(rest);
    if (!head || head->kind != Kind::array || head->count == 0)
        fail(file, "a list of states in MessagePack", "something else");
    const std::string_view first = rest;
    const std::uint64_t frame = frame_to_read(choices, head->count);
    for (std::uint64_t state = 0; state < frame; ++state)
        if (!skip_item(rest))
            fail(file, "whole states", "the end of the file; copy or make it again");
    Snapshot snapshot = snapshot_of(file, entries_of(file, rest));
    const auto at_first = entries_of(file, first);
    if (const auto box = at_first.find("box"); box != at_first.end()) {
        snapshot.boundary = points_of(file, "box", box->second);
        snapshot.provenance["boundary_arrays"] = "box";
        snapshot.notes.push_back("walls: box, " + std::to_string(snapshot.boundary.size()) +
                                 " particles");
    }
    note_frame(snapshot, choices, frame, head->count);
    return snapshot;
}

} // namespace

SnapshotFormat deep_lagrangian_fluids_format() {
    return {"DeepLagrangianFluids", is_zstd, read_record, true};
}

} // namespace meniscus
