// Charts: where numbers stand, and that names keep clear of each other.
#include <meniscus/data/drawing/draw_chart.hpp>
#include <meniscus/data/drawing/name_places.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

std::vector<std::string> words_of(const Drawing& drawing) {
    std::vector<std::string> words;
    for (const auto& shape : drawing.shapes)
        if (const auto* lettering = std::get_if<Lettering>(&shape))
            words.push_back(lettering->text);
    return words;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

Chart chart_of(const std::vector<ChartPoint>& points, bool is_logarithmic) {
    return {"", {{"", {"x"}, {"y", is_logarithmic}, {{"", points}}}}};
}

std::vector<DrawingPoint> dots_of(const Drawing& drawing) {
    std::vector<DrawingPoint> dots;
    for (const auto& shape : drawing.shapes)
        if (const auto* dot = std::get_if<Dot>(&shape))
            dots.push_back(dot->middle);
    return dots;
}

TEST(Chart, ALogarithmicAxisHasAPlaceForZero) {
    const Drawing drawing = draw_chart(chart_of({{1, 0}, {2, 0.01}, {3, 1}, {4, 100}}, true));
    const auto words = words_of(drawing);
    for (const char* tick : {"0", "0.01", "1", "100"})
        EXPECT_TRUE(has(words, tick)) << tick;
    EXPECT_FALSE(has(words, "0.001")); // there zero stands
    const auto dots = dots_of(drawing);
    EXPECT_NEAR(dots[1].y - dots[2].y, dots[2].y - dots[3].y, 1e-6);
    EXPECT_NEAR(dots[0].y - dots[1].y, (dots[1].y - dots[2].y) / 2, 1e-6);
}

TEST(Chart, OneNumberHasAPlaceInTheMiddle) {
    for (const bool is_logarithmic : {false, true})
        for (const double value : {0.0, 7.0, 1e-300}) {
            const Drawing drawing = draw_chart(chart_of({{value, value}}, is_logarithmic));
            const DrawingPoint dot = dots_of(drawing).at(0);
            EXPECT_TRUE(dot.x > 0 && dot.x < drawing.width) << value;
            EXPECT_TRUE(dot.y > 0 && dot.y < drawing.height) << value;
        }
}

TEST(Chart, TicksAreRoundNumbers) {
    const auto words = words_of(draw_chart(chart_of({{0, 0.13}, {1, 0.67}}, false)));
    for (const char* tick : {"0.2", "0.3", "0.6"})
        EXPECT_TRUE(has(words, tick)) << tick;
}

TEST(Names, CoverNeitherEachOtherNorPoints) {
    std::vector<NamedPoint> points;
    for (int k = 0; k < 30; ++k)
        points.push_back({{400 + 90 * std::sin(1.7 * k), 250 + 60 * std::cos(2.3 * k)},
                          "a name of some length " + std::to_string(k)});
    const DrawingFrame frame{{0, 0}, {800, 500}};
    const auto places = name_places(points, frame);
    ASSERT_EQ(places.size(), points.size());
    const auto left = [](const Lettering& one) {
        const double width = lettering_width(one.text);
        return one.place.x - (one.anchor == Anchor::begin    ? 0
                              : one.anchor == Anchor::middle ? width / 2
                                                             : width);
    };
    const auto apart = [&](const Lettering& a, const Lettering& b) {
        return std::abs(a.place.y - b.place.y) >= lettering_height - 0.01 ||
               left(a) + lettering_width(a.text) <= left(b) + 0.01 ||
               left(b) + lettering_width(b.text) <= left(a) + 0.01;
    };
    const auto covers = [&](const Lettering& name, const DrawingPoint& place) {
        return std::abs(name.place.y - place.y) < lettering_height / 2 && place.x > left(name) &&
               place.x < left(name) + lettering_width(name.text);
    };
    for (std::size_t a = 0; a < places.size(); ++a) {
        EXPECT_GE(left(places[a].lettering), 0);
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_TRUE(apart(places[a].lettering, places[b].lettering)) << a << " and " << b;
        for (const NamedPoint& point : points)
            EXPECT_FALSE(covers(places[a].lettering, point.place)) << a;
    }
}

TEST(Names, ThatAreNotNeededGiveWay) {
    const std::vector<NamedPoint> points = {{{20, 5}, "as wide as all"},
                                            {{20, 5}, "as wide as all", false}};
    const auto places = name_places(points, {{0, 0}, {120, 10}});
    EXPECT_EQ(places[0].lettering.text, "as wide as all");
    EXPECT_EQ(places[1].lettering.text, "");
}

} // namespace
} // namespace meniscus
