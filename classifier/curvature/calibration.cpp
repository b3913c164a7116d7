#include "calibration.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/coverage/sample_directions.hpp>

#include <algorithm>
#include <limits>

namespace meniscus {
namespace {

constexpr const char* calibration_format = "meniscus calibration";
constexpr double min_size = 0.01; ///< a sphere of h / R = 0.01 has a million surface particles
constexpr double max_size = 2;
constexpr double patch_width = 8; ///< of what has no end; particles are trusted in the middle
constexpr int max = std::numeric_limits<int>::max();

struct ShapeKind {
    const char* name;
    int dimension;
    std::size_t proportions;
};

constexpr ShapeKind shape_kinds[] = {{"circle", 2, 0}, {"sphere", 3, 0},   {"ellipsoid", 3, 3},
                                     {"torus", 3, 2},  {"cylinder", 3, 0}, {"paraboloid", 3, 2}};

const ShapeKind* kind_named(const std::string& name, int dimension) {
    for (const ShapeKind& kind : shape_kinds)
        if (name == kind.name && dimension == kind.dimension)
            return &kind;
    return nullptr;
}

std::string kinds_text(int dimension) {
    std::string text;
    for (const ShapeKind& kind : shape_kinds)
        if (kind.dimension == dimension)
            text += (text.empty() ? "'" : ", '") + std::string(kind.name) + "'";
    return text;
}

/// One of the values that a text stands for.
template <class Value>
Value choice(const JsonReader& reader, const char* key, const std::string& text,
             const std::vector<std::pair<std::string, Value>>& choices) {
    std::string expected;
    for (const auto& [name, value] : choices) {
        if (text == name)
            return value;
        expected += (expected.empty() ? "'" : ", '") + name + "'";
    }
    reader.refuse(key, expected);
}

void demand_entries(const JsonReader& reader, const char* key, std::size_t entries) {
    if (entries == 0)
        reader.refuse(key, "a list with at least one entry");
}

std::vector<std::array<double, 3>> read_places(const JsonReader& reader) {
    const std::vector<double> numbers = reader.numbers("places", -1e3, 1e3);
    if (numbers.empty() || numbers.size() % 3 != 0)
        reader.refuse("places", "coordinates x, y, z of one place or more in one list");
    std::vector<std::array<double, 3>> places;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        places.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    return places;
}

CalibrationShape read_shape(const JsonReader& reader, const Calibration& calibration) {
    reader.expect_only({"kind", "proportions", "sizes", "sides", "places"});
    CalibrationShape shape;
    shape.kind = reader.text("kind");
    const ShapeKind* const kind = kind_named(shape.kind, calibration.dimension);
    if (kind == nullptr)
        reader.refuse("kind", "one of " + kinds_text(calibration.dimension) + " in " +
                                  std::to_string(calibration.dimension) + " dimensions");
    if (kind->proportions > 0 || reader.has("proportions"))
        shape.proportions = reader.numbers("proportions", -100, 100);
    if (shape.proportions.size() != kind->proportions)
        reader.refuse("proportions", std::to_string(kind->proportions) + " numbers");
    shape.sizes = reader.numbers("sizes", shape.kind == "paraboloid" ? 0 : min_size, max_size);
    demand_entries(reader, "sizes", shape.sizes.size());
    for (const std::string& side : reader.texts("sides"))
        shape.sides.push_back(choice<Side>(reader, "sides", side,
                                           {{"inside", Side::inside}, {"outside", Side::outside}}));
    demand_entries(reader, "sides", shape.sides.size());
    if (calibration.is_dense)
        shape.places = read_places(reader);
    else if (reader.has("places"))
        reader.refuse("places", "left out: every surface particle of a filled cloud counts");
    for (const double size : shape.sizes) // proportions that no shape has
        shape_of(shape, size, shape.sides.front(), calibration.dimension);
    return shape;
}

FilledClouds read_filled(const JsonReader& reader) {
    reader.expect_only({"kind", "spacing_ratios", "arrangements", "particles"});
    FilledClouds clouds;
    clouds.spacing_ratios = reader.numbers("spacing_ratios", 1.2, 6);
    demand_entries(reader, "spacing_ratios", clouds.spacing_ratios.size());
    for (const JsonReader& entry : reader.objects("arrangements")) {
        entry.expect_only({"kind", "jitter"});
        clouds.arrangements.push_back({choice<Arrangement>(entry, "kind", entry.text("kind"),
                                                           {{"relaxed", Arrangement::relaxed},
                                                            {"lattice", Arrangement::lattice},
                                                            {"random", Arrangement::random}}),
                                       entry.number("jitter", 0, 0.99)});
    }
    demand_entries(reader, "arrangements", clouds.arrangements.size());
    clouds.particles = reader.whole_number("particles", 10, 1000000);
    return clouds;
}

DenseClouds read_dense(const JsonReader& reader) {
    reader.expect_only({"kind", "neighbors", "candidates", "repeats"});
    return {reader.whole_number("neighbors", 50, 100000),
            reader.whole_number("candidates", 20, 100000),
            reader.whole_number("repeats", 2, 1000000)};
}

std::vector<bool> read_terms(const JsonReader& reader) {
    std::vector<bool> has_term(curvature_terms().size());
    for (const std::string& name : reader.texts("terms")) {
        const auto& terms = curvature_terms();
        const auto term = std::find(terms.begin(), terms.end(), name);
        if (term == terms.end())
            reader.refuse("terms", "a list of 'constant', 'turning', 'square', 'closed form'");
        has_term[static_cast<std::size_t>(term - terms.begin())] = true;
    }
    demand_entries(reader, "terms", std::count(has_term.begin(), has_term.end(), true));
    return has_term;
}

std::vector<int> read_samples(const JsonReader& reader) {
    std::vector<int> samples;
    for (const double number : reader.numbers("samples", 0, max_samples)) {
        samples.push_back(static_cast<int>(number));
        if (samples.back() != number || (number > 0 && number < min_samples))
            reader.refuse("samples", "a list of numbers of directions, 0 for exact coverage");
    }
    demand_entries(reader, "samples", samples.size());
    return samples;
}

Calibration calibration_from(const JsonReader& reader) {
    reader.expect_only({"format", "format_version", "dimension", "radius_ratio", "fade", "tau",
                        "normal_passes", "averaged", "terms", "bias_penalty", "min_curvature",
                        "samples", "seed", "clouds", "shapes"});
    if (reader.value("format") != calibration_format)
        reader.refuse("format", std::string("'") + calibration_format + "'");
    if (reader.value("format_version") != 1)
        reader.refuse("format_version", "1 for this program to read it");
    Calibration calibration;
    calibration.dimension = reader.whole_number("dimension", 2, 3);
    calibration.radius_ratio = reader.number("radius_ratio", 0.05, 0.99);
    calibration.fade = reader.number("fade", 0, 1);
    calibration.tau = reader.number("tau", 0, 1);
    calibration.normal_passes = reader.whole_number("normal_passes", 0, 100);
    calibration.averaged = reader.truth("averaged");
    calibration.has_term = read_terms(reader);
    calibration.bias_penalty = reader.number("bias_penalty", 0, 1e9);
    calibration.min_curvature = reader.number("min_curvature", 1e-3, 10);
    calibration.samples = read_samples(reader);
    calibration.seed = static_cast<std::uint64_t>(reader.whole_number("seed", 0, max));
    const JsonReader clouds = reader.object_at("clouds");
    calibration.is_dense =
        choice<bool>(clouds, "kind", clouds.text("kind"), {{"filled", false}, {"dense", true}});
    if (calibration.is_dense && calibration.dimension == 2)
        clouds.refuse("kind", "'filled' in two dimensions");
    if (calibration.is_dense)
        calibration.dense = read_dense(clouds);
    else
        calibration.filled = read_filled(clouds);
    for (const JsonReader& shape : reader.objects("shapes"))
        calibration.shapes.push_back(read_shape(shape, calibration));
    demand_entries(reader, "shapes", calibration.shapes.size());
    return calibration;
}

} // namespace

const std::vector<std::string>& curvature_terms() {
    static const std::vector<std::string> names = {"constant", "turning", "square", "closed form"};
    return names;
}

Shape shape_of(const CalibrationShape& shape, double size, Side side, int dimension) {
    const ShapeKind* const kind = kind_named(shape.kind, dimension);
    if (kind == nullptr || shape.proportions.size() != kind->proportions)
        throw InputError("'" + shape.kind + "' with " + std::to_string(shape.proportions.size()) +
                         " proportions is no shape in " + std::to_string(dimension) +
                         " dimensions");
    const double radius = 1 / size;
    const auto length = [&](std::size_t i) { return shape.proportions[i] * radius; };
    Shape made;
    if (shape.kind == "circle")
        made = circle(radius);
    else if (shape.kind == "sphere")
        made = sphere(radius);
    else if (shape.kind == "cylinder")
        made = cylinder(radius, patch_width);
    else if (shape.kind == "ellipsoid")
        made = ellipsoid({length(0), length(1), length(2)});
    else if (shape.kind == "torus")
        made = torus(length(0), length(1));
    else
        made = paraboloid(shape.proportions[0] * size, shape.proportions[1] * size, patch_width);
    return side == Side::inside ? made : outside(made);
}

Calibration calibration_from_json(const std::string& text, const std::filesystem::path& file) {
    const Json json = parse_json(text, file.string(), "a calibration");
    return naming_file(file, [&] { return calibration_from(JsonReader(json, file.string(), "")); });
}

Calibration read_calibration(const std::filesystem::path& file) {
    return calibration_from_json(
        text_of_file(file, "a calibration such as configs/curvature/solver_like_3d.json"), file);
}

} // namespace meniscus
