#include "data/test_folder.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace meniscus {
namespace {

using Json = nlohmann::ordered_json;

Model example() {
    Model model;
    model.line = {116.37671050512346, 25.9865004163};
    model.label_threshold = 0.02;
    model.objective = "neyman-pearson";
    model.d_margin = 0.00083188355252561725;
    model.spacing_ratio = Range{2, 2.0000000000000004};
    model.bulk_neighbor_count = Range{26, 43};
    model.training_files = {{"dam \"14\".vtkhdf", std::string(64, 'a'), "dam", 26100, 9000},
                            {"tröpfchen.vtkhdf", std::string(64, 'b'), "droplet", 8000, 2000}};
    model.false_positives = 17;
    return model;
}

std::string reading_error(const std::string& text) {
    return error_of<InputError>([&] { model_from_json(text, "folder/line.json"); });
}

/// The error where one thing of a good model was changed.
std::string error_after(const std::function<void(Json&)>& damage) {
    Json json = Json::parse(model_to_json(example()));
    damage(json);
    return reading_error(json.dump());
}

TEST(Model, ReadsBackToTheSameBits) {
    const Model model = example();
    const std::string text = model_to_json(model);
    const Model read = model_from_json(text, "line.json");
    EXPECT_EQ(model_to_json(read), text);
    EXPECT_EQ(read.line.k, model.line.k);
    EXPECT_EQ(read.line.d, model.line.d);
    EXPECT_EQ(read.d_margin, model.d_margin);
    EXPECT_EQ(read.spacing_ratio->max, model.spacing_ratio->max);
    EXPECT_EQ(read.training_files[0].name, model.training_files[0].name);
    EXPECT_EQ(read.training_files[1].surface_particles, 2000U);
    EXPECT_EQ(read.false_positives, 17U);
    EXPECT_EQ(read.file, "line.json");
}

TEST(Model, SaysByWhatWeightBoundaryParticlesCount) {
    Model model = example();
    model.boundary_weight = 0.85;
    const std::string text = model_to_json(model);
    EXPECT_EQ(Json::parse(text)["boundary_weight"], 0.85);
    EXPECT_EQ(model_from_json(text, "line.json").boundary_weight, 0.85);
}

TEST(Model, ReadsBackWithoutRangesAndFiles) {
    Model model;
    model.line = {74.6888, 28};
    model.objective = "published";
    const Model read = model_from_json(model_to_json(model), "published.json");
    EXPECT_FALSE(read.spacing_ratio);
    EXPECT_FALSE(read.bulk_neighbor_count);
    EXPECT_TRUE(read.training_files.empty());
    EXPECT_EQ(read.line.k, 74.6888);
}

TEST(Model, KeysKeepTheirOrder) {
    const std::string text = model_to_json(example());
    EXPECT_EQ(text.find("{\n  \"format\": \"meniscus model\",\n  \"format_version\": 1,\n  \"k\": "
                        "116.37671050512346,\n"),
              0U)
        << text;
    EXPECT_EQ(text.back(), '\n');
}

TEST(Model, NamesFileAndKeyOfEachMissingKey) {
    const Json json = Json::parse(model_to_json(example()));
    for (const auto& entry : json.items()) {
        const std::string error = error_after([&](Json& damaged) { damaged.erase(entry.key()); });
        EXPECT_NE(error.find("folder/line.json"), std::string::npos) << error;
        EXPECT_NE(error.find("'" + entry.key() + "'"), std::string::npos) << error;
    }
    const std::string error =
        error_after([](Json& damaged) { damaged["training_files"][1].erase("hash"); });
    EXPECT_NE(error.find("'training_files[1].hash'"), std::string::npos) << error;
}

TEST(Model, NamesFileAndKeyOfEachWrongType) {
    const Json json = Json::parse(model_to_json(example()));
    for (const auto& entry : json.items())
        for (const Json& wrong : {Json(true), Json::parse("{\"min\": \"a\"}"), Json(-1.5e300)}) {
            const std::string error =
                error_after([&](Json& damaged) { damaged[entry.key()] = wrong; });
            EXPECT_NE(error.find("'" + entry.key()), std::string::npos) << error;
            EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        }
}

TEST(Model, RefusesNumbersThatAreNotFinite) {
    for (const char* key : {"k", "d", "radius_ratio", "label_threshold", "d_margin"}) {
        const std::string null = error_after([&](Json& damaged) { damaged[key] = nullptr; });
        EXPECT_NE(null.find(std::string("'") + key + "'"), std::string::npos) << null;
        EXPECT_NE(null.find("found null"), std::string::npos) << null;
        std::string text = Json::parse(model_to_json(example())).dump();
        const std::string start = std::string("\"") + key + "\":";
        text.replace(text.find(start), start.size(), start + "1e999,\"x\":");
        const std::string huge = reading_error(text);
        EXPECT_NE(huge.find(std::string("'") + key + "'"), std::string::npos) << huge;
    }
}

TEST(Model, RefusesImplausibleValues) {
    const std::vector<std::pair<const char*, Json>> cases = {
        {"k", 1e7},
        {"d", -1e7},
        {"dimension", 4},
        {"dimension", 2.5},
        {"radius_ratio", 0},
        {"radius_ratio", 1.01},
        {"label_threshold", 1},
        {"label_threshold", -0.1},
        {"d_margin", -1},
        {"spacing_ratio", {{"min", 3}, {"max", 2}}},
        {"bulk_neighbor_count", {{"min", -3}, {"max", 2}}},
        {"false_negatives", 11001},
        {"false_positives", 23101},
        {"false_positives", -1},
        {"false_positives", 1.5},
        {"features", {"neighbor_count", "neighbor_count"}},
        {"features", {"neighbor_count", "offset"}},
        {"features", {"relative_neighbor_count", "mass_offset"}},
        {"boundary_weight", "by volume"},
        {"boundary_weight", -1},
        {"reference_spacing_ratio", "2"},
        {"format", "something else"},
        {"format_version", 2},
    };
    for (const auto& [key, value] : cases) {
        const std::string error =
            error_after([&, key = key, &value = value](Json& damaged) { damaged[key] = value; });
        EXPECT_NE(error.find(std::string("'") + key), std::string::npos) << key << ": " << error;
    }
}

TEST(Model, RefusesWhatIsNoModel) {
    for (const char* text : {"", "{", "[1, 2]", "3", "{\"k\": 1", "\xff\xfe", "nan"}) {
        const std::string error = reading_error(text);
        EXPECT_EQ(error.find("folder/line.json"), 0U) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    EXPECT_THROW(read_model("no/such/model.json"), InputError);
    EXPECT_THROW(read_model("."), InputError);
}

TEST(Model, CutOffAnywhereIsRefused) {
    const std::string text = model_to_json(example());
    for (std::size_t length = 0; length + 2 < text.size(); ++length)
        EXPECT_NE(reading_error(text.substr(0, length)), "") << length;
}

using ModelFile = TestFolder;

TEST_F(ModelFile, IsRead) {
    const auto file = write("line.json", model_to_json(example()));
    EXPECT_EQ(read_model(file).line.d, example().line.d);
}

TEST(ModelUse, OfAnotherKindIsRefused) {
    Model model = example();
    model.file = "line.json";
    EXPECT_NO_THROW(check_dimension(model, 3, "a.vtkhdf"));
    EXPECT_THROW(check_dimension(model, 2, "a.vtkhdf"), InputError);
    EXPECT_NO_THROW(check_radius_ratio(model, 0.8, "a.vtkhdf"));
    EXPECT_THROW(check_radius_ratio(model, 0.75, "a.vtkhdf"), InputError);
    EXPECT_NO_THROW(check_boundary_weight(model, 0, "a.vtkhdf"));
    EXPECT_EQ(error_of<InputError>([&] { check_boundary_weight(model, 0.85, "a.vtkhdf"); }),
              "model line.json was trained with boundary weight 0, a.vtkhdf was labelled with "
              "0.85; label it with --boundary-weight 0.0");
    EXPECT_NO_THROW(check_boundary_weight(model, {}, "a.vtkhdf"));
}

TEST(ModelUse, OutsideTheTrainedRangeDrawsOneWarning) {
    const Model model = example();
    EXPECT_EQ(outside_trained_range(model, {{"a", 2.0, 30.0}, {"b", {}, {}}}), "");
    EXPECT_EQ(outside_trained_range(model, {{"a", 2.0, 25.0}, {"b", 3.0, 50.0}, {"c", 1.5, 50.0}}),
              "the model is used outside what it was trained on: h / particle spacing is 3 in b "
              "and was 2 in training; bulk neighbor count is 50 in b and was 26 to 43 in training");
    EXPECT_EQ(outside_trained_range(Model{}, {{"a", 9.0, 90.0}}), "");
}

} // namespace
} // namespace meniscus
