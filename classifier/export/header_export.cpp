#include "header_export.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace meniscus {
namespace {

constexpr std::string_view reserved_words[] = {"alignas",       "alignof",     "and",
                                               "and_eq",        "asm",         "auto",
                                               "bitand",        "bitor",       "bool",
                                               "break",         "case",        "catch",
                                               "char",          "char16_t",    "char32_t",
                                               "char8_t",       "class",       "co_await",
                                               "co_return",     "co_yield",    "compl",
                                               "concept",       "const",       "const_cast",
                                               "consteval",     "constexpr",   "constinit",
                                               "continue",      "decltype",    "default",
                                               "delete",        "do",          "double",
                                               "dynamic_cast",  "else",        "enum",
                                               "explicit",      "export",      "extern",
                                               "false",         "float",       "for",
                                               "friend",        "goto",        "if",
                                               "inline",        "int",         "long",
                                               "mutable",       "namespace",   "new",
                                               "noexcept",      "not",         "not_eq",
                                               "nullptr",       "operator",    "or",
                                               "or_eq",         "private",     "protected",
                                               "public",        "register",    "reinterpret_cast",
                                               "requires",      "return",      "short",
                                               "signed",        "sizeof",      "static",
                                               "static_assert", "static_cast", "struct",
                                               "switch",        "template",    "this",
                                               "thread_local",  "throw",       "true",
                                               "try",           "typedef",     "typeid",
                                               "typename",      "union",       "unsigned",
                                               "using",         "virtual",     "void",
                                               "volatile",      "wchar_t",     "while",
                                               "xor",           "xor_eq"};

/// Members have the struct's scope, and a member cannot have the struct's name.
constexpr std::string_view members[] = {"k",
                                        "d",
                                        "dimension",
                                        "radius_ratio",
                                        "label_threshold",
                                        "boundary_weight",
                                        "SecondLine",
                                        "min_bulk_neighbor_count",
                                        "max_bulk_neighbor_count",
                                        "min_spacing_ratio",
                                        "max_spacing_ratio",
                                        "coefficients",
                                        "min",
                                        "max",
                                        "averaged",
                                        "fade",
                                        "tau",
                                        "normal_passes",
                                        "features",
                                        "surface_above",
                                        "reference_spacing_ratio"};

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// True for names that the language leaves to programs.
bool is_identifier(std::string_view name) {
    if (name.empty() || !is_letter(name.front()))
        return false;
    if (name.find("__") != std::string_view::npos)
        return false;
    for (const char c : name)
        if (!is_letter(c) && !is_digit(c) && c != '_')
            return false;
    return std::find(std::begin(reserved_words), std::end(reserved_words), name) ==
               std::end(reserved_words) &&
           std::find(std::begin(members), std::end(members), name) == std::end(members);
}

/// Text that no file name can break out of a comment with: what could end the line or join it with
/// the next (line breaks, backslash, the trigraph for it), what could confuse a reader (control
/// and bidirectional characters) becomes an underscore.
std::string comment_text(const std::string& text) {
    std::string safe = text;
    for (char& c : safe)
        if (c < ' ' || c > '~' || c == '\\' || c == '?')
            c = '_';
    return safe;
}

void check_numbers(std::initializer_list<double> numbers) {
    for (const double value : numbers)
        if (!std::isfinite(value))
            throw InputError("the model has a number that is not finite, so no header can be made "
                             "from it; train it again");
}

void check_numbers(const Model& model) {
    const Range none;
    check_numbers({model.line.k, model.line.d, model.radius_ratio, model.label_threshold,
                   model.d_margin, model.reference_spacing_ratio, model.boundary_weight,
                   model.spacing_ratio.value_or(none).min, model.spacing_ratio.value_or(none).max,
                   model.bulk_neighbor_count.value_or(none).min,
                   model.bulk_neighbor_count.value_or(none).max});
}

void check_name(const std::string& struct_name, const std::string& example) {
    if (!is_identifier(struct_name))
        throw InputError("'" + struct_name +
                         "' cannot name the struct of a coefficient header; expected a C++ "
                         "identifier such as " +
                         example);
}

std::string constant(const std::string& name, double value, const std::string& comment) {
    return "    /// " + comment + "\n    static constexpr double " + name + " = " +
           number_text(value) + ";\n";
}

std::string range_constants(const std::string& name, const std::optional<Range>& range,
                            const std::string& meaning) {
    const std::string known = range ? "" : "; 0: not known";
    return constant("min_" + name, range.value_or(Range{}).min,
                    "Least " + meaning + " seen in training" + known) +
           constant("max_" + name, range.value_or(Range{}).max,
                    "Largest " + meaning + " seen in training" + known);
}

std::string boundary_text(const Model& model) {
    if (model.boundary_weight == 0)
        return "boundary particles do not count";
    return "boundary particles count by " + number_text(model.boundary_weight) + " of their volume";
}

std::string provenance_comment(const Model& model) {
    std::string text = "// Trained by " + comment_text(model.objective) +
                       "; neighbors: " + comment_text(model.phase_rule) + "; " +
                       boundary_text(model) + ".\n";
    if (model.training_files.empty())
        return text + "// The training files are not recorded.\n";
    text += "// On its training files it has " + std::to_string(model.false_negatives) +
            " false negatives and " + std::to_string(model.false_positives) + " false positives:\n";
    for (const TrainingFile& file : model.training_files)
        text += "//   " + comment_text(file.name) + ", scene " + comment_text(file.scene) + ": " +
                std::to_string(file.particles) + " particles, " +
                std::to_string(file.surface_particles) + " surface\n//     sha256 " +
                comment_text(file.hash) + "\n";
    return text;
}

std::string truth_text(bool value) {
    return value ? "true" : "false";
}

/// What names the plane of the line; headers without it are of the paper's.
std::string feature_constants(const Model& model) {
    if (is_of_paper(model.features))
        return {};
    return std::string("    /// x and y\n    static constexpr const char* features[] = {\"") +
           feature_list[model.features.first].name + "\", \"" +
           feature_list[model.features.second].name +
           "\"};\n    /// Whether surface lies above the line, else below\n"
           "    static constexpr bool surface_above = " +
           truth_text(model.line.above) + ";\n";
}

/// The second line, as a coefficient struct of its own.
std::string second_struct(const Model& model) {
    if (!model.second)
        return {};
    const SecondModelLine& second = *model.second;
    Model as_first = model;
    as_first.features = second.features;
    as_first.line = second.line;
    std::string text =
        "/// For the candidates that the first lets through, in other features\nstruct SecondLine "
        "{\n" +
        feature_constants(as_first) + constant("k", second.line.k, "Slope") +
        constant("d", second.line.d,
                 "Constant, " + rounded_text(second.d_margin, 3) + " of it for rounding") +
        "    static constexpr int dimension = " + std::to_string(model.dimension) + ";\n" +
        constant("radius_ratio", model.radius_ratio, "As of the first") + "};\n";
    std::string indented;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         begin = end + 1, end = text.find('\n', begin))
        indented += "    " + text.substr(begin, end + 1 - begin);
    return indented;
}

std::string struct_text(const Model& model, const std::string& struct_name) {
    const bool of_paper = is_of_paper(model.features);
    const std::string margin = rounded_text(model.d_margin, 3);
    return "struct " + struct_name + " {\n" + feature_constants(model) +
           constant("k", model.line.k,
                    of_paper ? "Slope, in neighbors per unit of mass offset" : "Slope") +
           constant("d", model.line.d,
                    of_paper ? "Neighbors, " + margin + " of them for rounding"
                             : "Constant, " + margin + " of it for rounding") +
           "    static constexpr int dimension = " + std::to_string(model.dimension) + ";\n" +
           constant("radius_ratio", model.radius_ratio,
                    "r2 / r1 of the labels; neighbors closer than r1 - r2 do not count") +
           constant("reference_spacing_ratio", model.reference_spacing_ratio,
                    model.reference_spacing_ratio > 0
                        ? "The lines follow support radius over rest spacing; k and d are for this"
                        : "0: counts are taken as they are") +
           constant("boundary_weight", model.boundary_weight,
                    "Share of its volume that a boundary particle counts for; 0: it only covers") +
           constant("label_threshold", model.label_threshold,
                    "Surface means an uncovered fraction above this") +
           range_constants("bulk_neighbor_count", model.bulk_neighbor_count,
                           "typical neighbor count inside") +
           range_constants("spacing_ratio", model.spacing_ratio,
                           "support radius over particle spacing") +
           second_struct(model) + "};\n";
}

/// For the include guard (#pragma once draws a warning where the header itself is compiled). It
/// depends on the content, so that two different lines under one name are an error and not the
/// first of them. FNV-1a.
std::string digest(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4)
        digits += "0123456789ABCDEF"[(hash >> static_cast<unsigned>(shift)) & 15U];
    return digits;
}

/// Code inside an include guard.
std::string guarded(const std::string& content) {
    const std::string guard = "MENISCUS_COEFFICIENTS_" + digest(content);
    return "#ifndef " + guard + "\n#define " + guard + "\n\nnamespace meniscus {\n\n" + content +
           "\n} // namespace meniscus\n\n#endif\n";
}

std::string provenance_comment(const CurvatureModel& model) {
    std::string text = "// Trained by calibrate on " + std::to_string(model.cloud_count) + " " +
                       comment_text(model.clouds) + " clouds of seed " +
                       std::to_string(model.seed) + ", " + std::to_string(model.particles) +
                       " particles.\n"
                       "// There the mean error of h kappa (the largest of all groups) and its "
                       "deviation are:\n";
    for (const std::string& line : residual_lines(model))
        text += "//   " + comment_text(line) + "\n";
    return text;
}

std::string struct_text(const CurvatureModel& model, const std::string& struct_name) {
    std::string coefficients;
    for (const double coefficient : model.map.coefficients)
        coefficients += (coefficients.empty() ? "" : ", ") + number_text(coefficient);
    return "struct " + struct_name +
           " {\n    static constexpr int dimension = " + std::to_string(model.map.dimension) +
           ";\n    /// Of 1, the turning of normals, its square, and the closed form\n"
           "    static constexpr double coefficients[] = {" +
           coefficients + "};\n" +
           constant("min", model.map.min, "Turning in training; beyond, straight on") +
           constant("max", model.map.max, "Turning in training; beyond, straight on") +
           "    /// Over the surface particles around\n    static constexpr bool averaged = " +
           (model.map.averaged ? "true" : "false") + ";\n" +
           constant("radius_ratio", model.radius_ratio, "r2 / r1 in training") +
           constant(
               "fade", model.fade,
               "Exposure at which a particle weighs 1, over that on a flat surface, in training") +
           constant("tau", model.tau, "Share of the neighbors in smoothing, in training") +
           "    /// Smoothing passes of the normals, in training\n"
           "    static constexpr int normal_passes = " +
           std::to_string(model.normal_passes) + ";\n" +
           range_constants("spacing_ratio", model.spacing_ratio,
                           "support radius over particle spacing") +
           "};\n";
}

/// The plane of the line, for a comment.
std::string plane_text(const Model& model) {
    if (is_of_paper(model.features))
        return "the\n// mass offset x and the neighbor count y. ";
    const auto row = [](char axis, std::size_t feature) {
        return std::string("//   ") + axis + " = " + feature_list[feature].name + ", " +
               feature_list[feature].meaning + "\n";
    };
    return "\n" + row('x', model.features.first) + row('y', model.features.second) + "// ";
}

} // namespace

std::string coefficient_header(const Model& model, const std::string& struct_name) {
    check_name(struct_name, "SurfaceCoefficients");
    check_numbers(model);
    const std::string content = struct_text(model, struct_name);
    return "// clang-format off\n// The line that tells surface particles from others: surface "
           "where y " +
           std::string(model.line.above ? ">=" : "<=") + " k x + d, with " + plane_text(model) +
           "Written by `meniscus export`; do not edit.\n" + "//\n" + provenance_comment(model) +
           guarded(content);
}

std::string coefficient_header(const CurvatureModel& model, const std::string& struct_name) {
    check_name(struct_name, "CurvatureCoefficients");
    check_numbers({model.map.coefficients[0], model.map.coefficients[1], model.map.coefficients[2],
                   model.map.coefficients[3], model.map.min, model.map.max, model.radius_ratio,
                   model.fade, model.tau, model.spacing_ratio.min, model.spacing_ratio.max});
    return "// clang-format off\n// The map from how normals turn to mean curvature "
           "(curvature_map.hpp). Written by\n"
           "// `meniscus export`; do not edit.\n//\n" +
           provenance_comment(model) + guarded(struct_text(model, struct_name));
}

} // namespace meniscus
