#include <meniscus/data/json/json_reader.hpp>

#include "expected_errors.hpp"

#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

std::string parse_error_of(const std::string& text) {
    return error_of<InputError>([&] { parse_json(text, "some.json", "a scene"); });
}

TEST(JsonReader, NamesTheNearestSpelling) {
    const std::vector<std::string> words{"gravity", "viscosity", "density", "walls"};
    EXPECT_EQ(nearest_spelling("gavity", words), "gravity");
    EXPECT_EQ(nearest_spelling("viscocity", words), "viscosity");
    EXPECT_EQ(nearest_spelling("walsl", words), "walls");
    EXPECT_EQ(nearest_spelling("denstiy", words), "density");
    EXPECT_EQ(nearest_spelling("", words), "walls");
    EXPECT_EQ(nearest_spelling(std::string(1000000, 'x'), words), "gravity");
}

TEST(JsonReader, CountsExchangedNeighborsAsOneEdit) {
    EXPECT_EQ(nearest_spelling("ab", {"cc", "ba"}), "ba"); // both are two replacements off
    EXPECT_EQ(likely_spelling("lable", {"audit", "label"}), "label");
    EXPECT_EQ(likely_spelling("zzz", {"audit", "label"}), "");
    EXPECT_EQ(likely_spelling("label", {}), "");
}

TEST(JsonReader, NamesWrongKeysWithTheirPath) {
    const Json json = Json::parse(R"({"outer": [{}, {"solvr": 1}]})");
    const JsonReader reader(json, "some.json", "");
    const std::string error = error_of<InputError>([&] {
        reader.objects("outer")[1].expect_only({"solver", "relaxation"});
    });
    expect_mentions(
        error, {"some.json", "'outer[1].solvr'", "did you mean 'solver'", "solver, relaxation"});
}

TEST(JsonReader, RefusesChoicesWithTheNearestOne) {
    const Json json = Json::parse(R"({"solver": "dfhsp"})");
    const JsonReader reader(json, "some.json", "pressure");
    EXPECT_EQ(reader.choice("solver", {"iisph", "dfhsp"}), 1U);
    expect_mentions(
        error_of<InputError>([&] {
            return reader.choice("solver", {"wcsph", "dfsph"});
        }),
        {"some.json", "'pressure.solver'", "wcsph, dfsph", "did you mean 'dfsph'", "dfhsp"});
}

TEST(JsonReader, RefusesAKeyThatStandsTwiceInOneObject) {
    expect_mentions(parse_error_of(R"({"a": {"b": 1, "c": 2, "b": 3}})"),
                    {"some.json", "'b'", "twice"});
    EXPECT_NO_THROW(parse_json(R"({"a": {"b": 1}, "b": [{"a": 1}, {"a": 2}]})", "", ""));
}

TEST(JsonReader, RefusesBracketsNestedTooDeep) {
    for (const char* bracket : {"[", "{\"a\":"}) {
        std::string text;
        for (int depth = 0; depth < 100000; ++depth)
            text += bracket;
        expect_mentions(parse_error_of(text), {"some.json", "100 deep"});
    }
}

} // namespace
} // namespace meniscus
