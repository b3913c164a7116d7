#include "data/test_folder.hpp"

#include <meniscus/classifier/export/header_export.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace meniscus {
namespace {

Model example() {
    Model model;
    model.line = {116.37671050512345, 25.986500416300001};
    model.objective = "neyman-pearson";
    model.label_threshold = 0.1 + 0.2;
    model.bulk_neighbor_count = Range{26, 43};
    model.training_files = {{"dam.vtkhdf", std::string(64, 'a'), "dam", 26100, 9000}};
    return model;
}

std::string hexadecimal(double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%a", value);
    return text;
}

class HeaderExport : public TestFolder {
protected:
    /// True where the compiler takes the file without a warning.
    bool compiles(const std::string& name, const std::string& source) const {
        const auto file = write(name, source);
        const std::string command = std::string(MENISCUS_CXX_COMPILER) +
                                    " -std=c++17 -Wall -Wextra -Werror -fsyntax-only -x c++ '" +
                                    file.string() + "'";
        return std::system(command.c_str()) == 0;
    }
};

TEST_F(HeaderExport, CompilesAlone) {
    EXPECT_TRUE(compiles("line.hpp", coefficient_header(example(), "SurfaceCoefficients")));
}

TEST_F(HeaderExport, ValuesReadBackToTheSameBits) {
    for (const double factor : {1.0, -1.0 / 3, 1e-300, 1e15}) {
        Model model = example();
        model.line.k *= factor;
        model.line.d *= factor;
        write("line.hpp", coefficient_header(model, "Line"));
        const auto same = [](const std::string& name, double value) {
            return "static_assert(meniscus::Line::" + name + " == " + hexadecimal(value) + ");\n";
        };
        EXPECT_TRUE(
            compiles("check.cpp",
                     "#include \"line.hpp\"\n#include \"line.hpp\"\n" + same("k", model.line.k) +
                         same("d", model.line.d) + same("radius_ratio", 0.8) +
                         same("label_threshold", model.label_threshold) +
                         same("min_bulk_neighbor_count", 26) + same("max_bulk_neighbor_count", 43) +
                         same("min_spacing_ratio", 0) + same("max_spacing_ratio", 0) +
                         "static_assert(meniscus::Line::dimension == 3);\nint main() {}\n"))
            << factor;
    }
}

TEST_F(HeaderExport, NoFileNameBreaksOutOfAComment) {
    // Turns the direction of the text after it around, for whoever reads the file.
    const std::string bidirectional = {'a', '\xe2', '\x80', '\xae'};
    for (const std::string& name :
         std::vector<std::string>{"a\nint broken", "a\r\nint broken", "a\\", "a\?\?/",
                                  "*/ int broken", bidirectional, "a\v\f", "\xff"}) {
        Model model = example();
        model.training_files = {{name, name, name, 1, 1}};
        model.objective = name;
        model.phase_rule = name;
        EXPECT_TRUE(compiles("line.hpp", coefficient_header(model, "Line"))) << name;
    }
}

TEST_F(HeaderExport, SaysWhetherBoundaryParticlesCount) {
    Model model = example();
    EXPECT_NE(coefficient_header(model, "Line").find("boundary particles do not count.\n"),
              std::string::npos);
    model.boundary_weight = 0.85;
    EXPECT_NE(coefficient_header(model, "Line")
                  .find("boundary particles count by 0.85 of their volume.\n"),
              std::string::npos);
}

TEST_F(HeaderExport, TwoLinesUnderOneNameAreAnError) {
    Model other = example();
    other.line.d += 1;
    write("a.hpp", coefficient_header(example(), "Line"));
    write("b.hpp", coefficient_header(other, "Line"));
    write("c.hpp", coefficient_header(other, "OtherLine"));
    EXPECT_FALSE(compiles("ab.cpp", "#include \"a.hpp\"\n#include \"b.hpp\"\n"));
    EXPECT_TRUE(compiles("ac.cpp", "#include \"a.hpp\"\n#include \"c.hpp\"\n"));
}

TEST(StructName, MustBeAnIdentifierThatProgramsMayUse) {
    for (const char* name : {"Line", "k2", "Surface_Coefficients"})
        EXPECT_NO_THROW(coefficient_header(example(), name)) << name;
    for (const char* name : {"", "2d", "a b", "a;b", "class", "k", "a__b", "_a", "a-b", "\xc3\xa4"})
        EXPECT_THROW(coefficient_header(example(), name), InputError) << name;
}

TEST(Header, RefusesNumbersThatAreNotFinite) {
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        Model model = example();
        model.line.d = value;
        EXPECT_THROW(coefficient_header(model, "Line"), InputError);
    }
}

} // namespace
} // namespace meniscus
