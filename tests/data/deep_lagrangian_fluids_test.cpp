// Records in MessagePack under Zstandard, as msgpack-numpy packs arrays: maps whose keys are bytes.
#include "expected_errors.hpp"
#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <vector>
#include <zstd.h>

namespace meniscus {
namespace {

std::string text(const std::string& value) {
    return static_cast<char>(0xa0 + value.size()) + value;
}

std::string bytes(const std::string& value) {
    return std::string("\xc5", 1) + static_cast<char>(value.size() >> 8) +
           static_cast<char>(value.size() & 255U) + value;
}

std::string list_of(std::size_t count) {
    return std::string(1, static_cast<char>(0x90 + count));
}

std::string map_of(std::size_t pairs) {
    return std::string(1, static_cast<char>(0x80 + pairs));
}

std::string array(const std::vector<float>& values, std::size_t columns) {
    std::string data(values.size() * sizeof(float), '\0');
    std::memcpy(data.data(), values.data(), data.size());
    const auto rows = static_cast<char>(values.size() / columns);
    const std::string shape =
        columns == 1 ? list_of(1) + rows : list_of(2) + rows + static_cast<char>(columns);
    return map_of(4) + bytes("nd") + "\xc3" + bytes("type") + text("<f4") + bytes("shape") + shape +
           bytes("data") + bytes(data);
}

std::string compressed(const std::string& content) {
    std::string stored(ZSTD_compressBound(content.size()), '\0');
    stored.resize(ZSTD_compress(stored.data(), stored.size(), content.data(), content.size(), 3));
    return stored;
}

constexpr const char* name = "sim_0001_00.msgpack.zst";

class DeepLagrangianFluids : public TestFolder {
protected:
    [[nodiscard]] std::string error_for(const std::string& content) const {
        const std::filesystem::path file = write(name, compressed(content));
        return error_of<InputError>([&] { read_snapshot(file); });
    }
};

const std::string first_state =
    map_of(2) + text("pos") + array({9, 9, 9, 9, 9, 8}, 3) + text("box") + array({7, 7, 7}, 3);
const std::string last_state = map_of(5) + text("scene_id") + text("pool") + text("frame_id") +
                               "\xcd\x01\x02" + text("pos") + array({1, 2, 3, 4, 5, 6}, 3) +
                               text("vel") + array({6, 5, 4, 3, 2, 1}, 3) + text("m") +
                               array({0.125F, 0.25F}, 1);

TEST_F(DeepLagrangianFluids, TheLastStateAndTheWallsOfTheFirstAreRead) {
    const Snapshot snapshot =
        read_snapshot(write(name, compressed(list_of(2) + first_state + last_state)));
    EXPECT_EQ(snapshot.positions, (Positions{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(snapshot.position_precision, Precision::float32);
    EXPECT_EQ(snapshot.boundary, (Positions{{7, 7, 7}}));
    EXPECT_EQ(as_doubles(*find_array(snapshot, "velocity")),
              (std::vector<double>{6, 5, 4, 3, 2, 1}));
    EXPECT_EQ(scalar_values(snapshot, "mass"), (std::vector<double>{0.125, 0.25}));
    EXPECT_EQ(snapshot.scene, "pool");
    ASSERT_EQ(snapshot.notes.size(), 2U);
    expect_mentions(snapshot.notes[0], {"box", "1 particles"});
    expect_mentions(snapshot.notes[1], {"last of 2"});
}

TEST_F(DeepLagrangianFluids, AnyStateCanBeRead) {
    const auto file = write(name, compressed(list_of(2) + first_state + last_state));
    ReadChoices choices;
    choices.frame = 0;
    Snapshot snapshot = read_snapshot(file, choices);
    EXPECT_EQ(snapshot.positions, (Positions{{9, 9, 9}, {9, 9, 8}}));
    EXPECT_EQ(snapshot.boundary, (Positions{{7, 7, 7}}));
    EXPECT_EQ(snapshot.provenance["frame"], "0");
    choices.frame = 1;
    snapshot = read_snapshot(file, choices);
    EXPECT_EQ(snapshot.positions, (Positions{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(snapshot.boundary, (Positions{{7, 7, 7}}));
    choices.frame = 2;
    expect_mentions(error_of<InputError>([&] { read_snapshot(file, choices); }),
                    {name, "--frame 2", "0 to 1"});
}

TEST_F(DeepLagrangianFluids, WhatIsNoRecordIsRefused) {
    expect_mentions(error_for("text"), {"list of states"});
    expect_mentions(error_for(list_of(1) + text("text")), {"map for each state"});
    expect_mentions(error_for(list_of(1) + map_of(1) + text("vel") + array({1, 2, 3}, 3)),
                    {"'pos'", "none"});
    expect_mentions(error_for(list_of(1) + map_of(1) + text("pos") + array({1, 2}, 2)),
                    {"'pos'", "N x 3"});
    expect_mentions(error_for(std::string(1 << 20, '\0')), {"bytes in"});
    std::string rows = array({1, 2, 3}, 3);
    rows[rows.find("\x92\x01\x03") + 1] = 2;
    expect_mentions(error_for(list_of(1) + map_of(1) + text("pos") + rows), {"'pos'"});
}

TEST_F(DeepLagrangianFluids, EveryCutIsRefused) {
    const std::string content = list_of(2) + first_state + last_state;
    for (std::size_t size = 1; size < content.size(); ++size)
        EXPECT_FALSE(error_for(content.substr(0, size)).empty()) << size;
    const std::string stored = compressed(content);
    for (std::size_t size = 5; size < stored.size(); ++size) {
        EXPECT_THROW(read_snapshot(write(name, stored.substr(0, size))), InputError) << size;
    }
}

} // namespace
} // namespace meniscus
