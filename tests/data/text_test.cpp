#include "expected_errors.hpp"

#include <meniscus/data/text.hpp>

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
