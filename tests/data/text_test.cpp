#include "expected_errors.hpp"

#include <meniscus/data/text/text.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace meniscus {
namespace {

TEST(Text, NumbersReadBackToTheSameBits) {
    EXPECT_EQ(number_text(2), "2.0");
    EXPECT_EQ(number_text(1e-300), "1e-300");
    for (const double value : {0.1, -1.0 / 3, 5e-324, 1.7976931348623157e308, 1e22})
        EXPECT_EQ(number_from_text(number_text(value)), value);
    EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(Text, NumbersAreRoundedForPeople) {
    EXPECT_EQ(rounded_text(25.926, 4), "25.93");
    EXPECT_EQ(rounded_text(1.0 / 3e9, 2), "3.3e-10");
}

TEST(Text, OnlyWholeTextsAreNumbers) {
    for (const char* text : {"", " 1", "1 ", "1,5", "0.8 m"})
        EXPECT_FALSE(number_from_text(text)) << text;
}

TEST(Text, NumbersAreReadAsTheTypeThatIsAskedFor) {
    float small = 1;
    EXPECT_EQ(read_number("0.1", small), std::errc());
    EXPECT_EQ(small, 0.1F);
    EXPECT_EQ(read_number("-1e-60", small), std::errc());
    EXPECT_EQ(small, 0);
    EXPECT_EQ(read_number("1e60", small), std::errc::result_out_of_range);
    EXPECT_EQ(small, 0);
    std::int8_t integer = 5;
    EXPECT_EQ(read_number("+127", integer), std::errc());
    EXPECT_EQ(integer, 127);
    EXPECT_EQ(read_number("-129", integer), std::errc::result_out_of_range);
    for (const char* text : {"", "+", "-", "+-1", "++1", " 1", "1 ", "1.0", "1e2", "0x1"})
        EXPECT_EQ(read_number(text, integer), std::errc::invalid_argument) << text;
    EXPECT_EQ(integer, 127);
}

TEST(Text, BytesOfFilesAreFitForMessages) {
    EXPECT_EQ(quoted_text("a b"), "'a b'");
    EXPECT_EQ(quoted_text(std::string_view("a\n\0\xff", 4)), "'a\?\?\?'");
    EXPECT_EQ(quoted_text(std::string(61, 'x')), "'" + std::string(60, 'x') + "...'");
}

TEST(Text, RepeatedNamesAreFound) {
    EXPECT_EQ(repeated_name({"b", "a", "c"}), std::nullopt);
    EXPECT_EQ(repeated_name({"b", "a", "b"}), "b");
    EXPECT_EQ(lowered("Pos.X [\xc4]"), "pos.x [\xc4]");
}

TEST(Text, ErrorsNameTheirFileOnce) {
    const auto message = [](const std::string& thrown) {
        return error_of<InputError>(
            [&] { naming_file("dam.vtk", [&] { throw InputError(thrown); }); });
    };
    EXPECT_EQ(message("no particles"), "dam.vtk: no particles");
    EXPECT_EQ(message("dam.vtk: no particles"), "dam.vtk: no particles");
    EXPECT_EQ(naming_file("dam.vtk", [] { return 7; }), 7);
}

} // namespace
} // namespace meniscus
