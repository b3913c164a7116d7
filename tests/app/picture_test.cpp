#include "png.hpp"
#include "report_page.hpp"

#include <cstdlib>

namespace meniscus {
namespace {

constexpr Color lowest = {68, 1, 84};
constexpr Color highest = {253, 231, 37};
constexpr Color gray = {190, 190, 190};

class Picture : public CommandLine {
protected:
    /// Two balls, the one at larger x the hotter, and a boundary particle.
    [[nodiscard]] Path two_balls(int dimension = 3) const {
        Snapshot snapshot;
        snapshot.dimension = dimension;
        snapshot.support_radius = 2;
        snapshot.particle_spacing = 1;
        snapshot.positions = {{0, 0, 0}, {3, 0, 0}};
        snapshot.boundary = {{1.5, 0, 0}};
        set_array(snapshot, {"heat", 1, std::vector<double>{1, 2}});
        set_array(snapshot, {"velocity", 3, std::vector<double>{0, 0, 1, 0, 2, 0}});
        return save(snapshot, "balls.vtkhdf");
    }

    [[nodiscard]] Png png(const Words& words) const {
        succeed(Words{"picture", "-o", output, "--quiet", "--size", "400,300"} + words);
        return Png(bytes_of(output));
    }

    const Path output = folder / "picture.png";
};

TEST_F(Picture, HasTheSizeAndTheColorsAskedFor) {
    for (const int dimension : {2, 3}) {
        const Path balls = two_balls(dimension);
        const Png by_heat = png({balls, "--color", "heat"});
        EXPECT_EQ(by_heat.width, 400U);
        EXPECT_EQ(by_heat.height, 300U);
        EXPECT_EQ(by_heat.pixels.front(), (Color{255, 255, 255}));
        // The bar of colors has a little of each, the balls far more.
        EXPECT_GT(by_heat.like(lowest), 300U) << dimension;
        EXPECT_GT(by_heat.like(highest), 300U) << dimension;
        EXPECT_EQ(by_heat.like(gray), 0U);
        // Vectors by their length.
        EXPECT_EQ(png({balls, "--color", "velocity"}).like(highest), by_heat.like(highest));
        EXPECT_GT(png({balls, "--color", "heat", "--walls"}).like(gray), 200U);
        EXPECT_LT(png({balls, "--color", "heat", "--range", "0,2"}).like(lowest), 200U);
    }
}

TEST_F(Picture, ACutTakesAwayOneSide) {
    const Path balls = two_balls();
    for (const char* cut : {"x", "x<1", "x<2.9"})
        EXPECT_LT(png({balls, "--color", "heat", "--cut", cut}).like(highest), 200U) << cut;
    const Png other = png({balls, "--color", "heat", "--cut", "x>1"});
    EXPECT_LT(other.like(lowest), 200U);
    EXPECT_GT(other.like(highest), 300U);
}

TEST_F(Picture, TheNearerBallHidesTheFarther) {
    const Path balls = two_balls();
    const Png from_right = png({balls, "--color", "heat", "--view", "90,0"});
    EXPECT_GT(from_right.like(highest), 300U);
    EXPECT_LT(from_right.like(lowest), 200U);
    const Png from_left = png({balls, "--color", "heat", "--view", "-90,0"});
    EXPECT_GT(from_left.like(lowest), 300U);
    EXPECT_LT(from_left.like(highest), 200U);
}

TEST_F(Picture, ClassesAreThoseOfClassifyElseOfTheLabel) {
    const Path droplet = sample("droplet_iisph_04");
    constexpr Color surface = {213, 94, 0};
    constexpr Color interior = {0, 114, 178};
    constexpr Color covered = {0, 158, 115};
    const Png labelled = png({label(droplet), "--cut", "z"});
    constexpr std::size_t in_legend = 144;
    EXPECT_GT(labelled.like(surface), 5 * in_legend);
    EXPECT_GT(labelled.like(interior), 5 * in_legend);
    EXPECT_EQ(labelled.like(covered), 0U);
    Snapshot classified = read_vtkhdf(two_balls());
    set_array(classified, {"surface", 1, std::vector<std::uint8_t>{0, 1}});
    set_array(classified, {"surface_class", 1, std::vector<std::uint8_t>{0, 1}});
    const Png by_class = png({save(classified, "classified.vtkhdf")});
    EXPECT_GT(by_class.like(covered), 2 * in_legend);
    EXPECT_GT(by_class.like(interior), 2 * in_legend);
    EXPECT_EQ(by_class.like(surface), in_legend);
}

TEST_F(Picture, SvgHasItsWordsAsText) {
    const Words words = {"picture", two_balls(),   "-o",      folder / "picture.svg",
                         "--title", "<b> & \"c\"", "--color", "heat"};
    succeed(words);
    const std::string svg = bytes_of(folder / "picture.svg");
    expect_mentions(svg, {"<svg", ">&lt;b&gt; &amp; \"c\"</text>", ">heat</text>", "base64"});
    EXPECT_EQ(svg.find("<b>"), std::string::npos);
    succeed(words);
    EXPECT_EQ(bytes_of(folder / "picture.svg"), svg);
}

TEST_F(Picture, RefusesWhatItDoesNotUnderstand) {
    const Path balls = two_balls();
    const Words words = {"picture", balls, "-o", output};
    fail(2, words + Words{"--color", "warmth"}, {"balls.vtkhdf", "warmth", "heat", "class"});
    for (const char* cut : {"w", "x=1", "x<", "x<nan", "xx", "<"})
        fail(2, words + Words{"--cut", cut}, {"--cut", "y<0.2"});
    for (const char* range : {"2,1", "nan,1", "-inf,inf"})
        fail(2, words + Words{"--range", range}, {"--range"});
    fail(2, words + Words{"--view", "nan,0"}, {"--view"});
    fail(2, words + Words{"--diameter", "0"}, {"--diameter"});
    fail(2, words + Words{"--size", "10,10"}, {"--size"});
    fail(2, {"picture", balls, "-o", folder / "picture.jpg"}, {"picture.jpg", ".png", ".svg"});
    fail(2, {"picture", folder / "missing.vtkhdf", "-o", output}, {"missing.vtkhdf"});
}

} // namespace
} // namespace meniscus
