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
    EXPECT_EQ(quoted_text(std::string_view("a\n\0\xff", 4)), "'a\\x0a\\x00\\xff'");
    EXPECT_EQ(quoted_text(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
    EXPECT_EQ(quoted_text(std::string(61, 'x')).size(), 62U);
}

TEST(Text, WhatIsPrintableStays) {
    for (const char* text : {"", "a b ~", "Öl über Wasser", "表面", "🌊", "\\x1b"})
        EXPECT_EQ(printable(text), text);
}

TEST(Text, NothingMovesTheCursorOrForgesALine) {
    EXPECT_EQ(printable("\x1b[31m\r\n\t\x7f"), "\\x1b[31m\\x0d\\x0a\\x09\\x7f");
    EXPECT_EQ(printable("a\u009b2Jb"), "a\\xc2\\x9b2Jb"); // escape and [ in one
    EXPECT_EQ(printable("a\u202eb\u2028c"), "a\\xe2\\x80\\xaeb\\xe2\\x80\\xa8c");
    EXPECT_EQ(printable("\xff\x9b \xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80 \xe2\x82"),
              "\\xff\\x9b \\xc0\\xaf \\xed\\xa0\\x80 \\xf4\\x90\\x80\\x80 \\xe2\\x82");
    EXPECT_EQ(printable_lines("one\n\x1b two\n"), "one\n\\x1b two\n");
    EXPECT_STREQ(InputError("a\nb").what(), "a\\x0ab");
    EXPECT_STREQ(FailureError("a\x1b").what(), "a\\x1b");
}

TEST(Text, LongTextsLoseTheirMiddle) {
    EXPECT_EQ(printable("0123456789", 10), "0123456789");
    EXPECT_EQ(printable("0123456789a", 10), "0123...89a");
    const std::string text = printable(std::string(300000, 'k'), 100);
    EXPECT_EQ(text.size(), 100U);
    EXPECT_EQ(printable(text, 100), text);
    for (std::size_t max = 3; max < 40; ++max) { // no character is cut
        const std::string cut = printable("äöüäöüäöüäöüäöüäöüäöüäöü", max);
        EXPECT_LE(cut.size(), max);
        EXPECT_EQ(printable(cut, max), cut);
    }
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
