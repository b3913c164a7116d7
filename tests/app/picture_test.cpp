#include "report_page.hpp"

#include <cstdlib>

namespace meniscus {
namespace {

using Color = std::array<int, 3>;

/// The pixels of a PNG as `meniscus picture` writes it: differences to the pixel before, in rows.
struct Png {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<Color> pixels;

    explicit Png(const std::string& bytes) {
        const auto number = [&](std::size_t at) {
            std::size_t value = 0;
            for (std::size_t n = 0; n < 4; ++n)
                value = value << 8U | static_cast<unsigned char>(bytes[at + n]);
            return value;
        };
        EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
        width = number(16);
        height = number(20);
        std::string rows(height * (3 * width + 1), '\0');
        uLongf size = rows.size();
        const std::size_t length = number(33);
        EXPECT_EQ(bytes.substr(37, 4), "IDAT");
        EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                             reinterpret_cast<const Bytef*>(bytes.data() + 41), length),
                  Z_OK);
        EXPECT_EQ(size, rows.size());
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    if (c == 0)
                        pixels.push_back(x == 0 ? Color{} : pixels.back());
                    const auto byte = rows[y * (3 * width + 1) + 1 + 3 * x + c];
                    pixels.back()[c] = (pixels.back()[c] + byte) & 255;
                }
    }

    [[nodiscard]] std::size_t like(const Color& color) const {
        return static_cast<std::size_t>(
            std::count_if(pixels.begin(), pixels.end(), [&](const Color& pixel) {
                return std::abs(pixel[0] - color[0]) + std::abs(pixel[1] - color[1]) +
                           std::abs(pixel[2] - color[2]) <
                       12;
            }));
    }
};

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
