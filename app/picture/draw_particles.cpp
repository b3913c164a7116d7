#include "draw_particles.hpp"

#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/math/angles.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

constexpr int margin = 24;
constexpr int legend_height = 60;
constexpr Color boundary_color = {190, 190, 190};

using Point = std::array<double, 3>;

struct Ball {
    Point place; ///< to the right, upward, towards the viewer
    Color color;
};

/// To the right, upward and towards the viewer.
std::array<Point, 3> view_axes(const PictureOptions& options, int dimension) {
    if (dimension == 2)
        return {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
    const double around = options.azimuth * pi / 180;
    const double up = options.elevation * pi / 180;
    return {Point{std::cos(around), 0, -std::sin(around)},
            Point{-std::sin(around) * std::sin(up), std::cos(up), -std::cos(around) * std::sin(up)},
            Point{std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up)}};
}

bool is_finite(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

double middle(const Positions& positions, std::size_t axis) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Point& position : positions)
        if (is_finite(position)) {
            low = std::min(low, position[axis]);
            high = std::max(high, position[axis]);
        }
    return (low + high) / 2;
}

bool is_kept(const Point& position, const std::optional<Cut>& cut) {
    return is_finite(position) &&
           (!cut || (cut->keeps_larger ? position[cut->axis] >= *cut->place
                                       : position[cut->axis] <= *cut->place));
}

void add_balls(const Positions& positions, const std::optional<Cut>& cut,
               const std::array<Point, 3>& axes, const std::vector<Color>& colors,
               std::vector<Ball>& balls) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!is_kept(positions[i], cut))
            continue;
        Ball ball{{}, colors.empty() ? boundary_color : colors[i]};
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t c = 0; c < 3; ++c)
                ball.place[axis] += axes[axis][c] * positions[i][c];
        balls.push_back(ball);
    }
}

/// How metres become pixels, so that all balls fit.
struct Frame {
    double scale = 1;         ///< pixels a metre
    double left = 0, top = 0; ///< pixel of the origin
};

Frame frame_of(const std::vector<Ball>& balls, const PictureOptions& options) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Point low = {far, far, far};
    Point high = {-far, -far, -far};
    for (const Ball& ball : balls)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], ball.place[axis] - options.diameter / 2);
            high[axis] = std::max(high[axis], ball.place[axis] + options.diameter / 2);
        }
    const double width = options.width - 2 * margin;
    const double height =
        options.height - 2 * margin - legend_height - (options.title.empty() ? 0 : words_height());
    Frame frame;
    frame.scale = std::min(width / (high[0] - low[0]), height / (high[1] - low[1]));
    frame.left = margin + width / 2 - frame.scale * (low[0] + high[0]) / 2;
    frame.top = margin + (options.title.empty() ? 0 : words_height()) + height / 2 +
                frame.scale * (low[1] + high[1]) / 2;
    return frame;
}

/// Balls into a picture twice as fine, by depth, pixel by pixel.
class Canvas {
public:
    Canvas(int width, int height)
        : image(width, height),
          depth(image.pixels.size(), -std::numeric_limits<float>::infinity()) {}

    void draw(const Ball& ball, double x, double y, double radius, double scale) {
        const auto first = [](double edge) {
            return std::max(0, static_cast<int>(std::ceil(edge)));
        };
        for (int row = first(y - radius); row <= y + radius && row < image.height; ++row)
            for (int column = first(x - radius); column <= x + radius && column < image.width;
                 ++column)
                set(ball, column, row,
                    ((column - x) * (column - x) + (row - y) * (row - y)) / (radius * radius),
                    radius / scale);
    }

    /// At half the fineness.
    [[nodiscard]] Image halved() {
        Image half(image.width / 2, image.height / 2);
        for (int y = 0; y < half.height; ++y)
            for (int x = 0; x < half.width; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    half.at(x, y)[c] = static_cast<std::uint8_t>(
                        (image.at(2 * x, 2 * y)[c] + image.at(2 * x + 1, 2 * y)[c] +
                         image.at(2 * x, 2 * y + 1)[c] + image.at(2 * x + 1, 2 * y + 1)[c] + 2) /
                        4);
        return half;
    }

private:
    Image image;
    std::vector<float> depth;

    /// `share`: squared distance from the ball's middle over its squared radius.
    void set(const Ball& ball, int x, int y, double share, double radius) {
        if (share > 1)
            return;
        const double bulge = std::sqrt(1 - share);
        const auto here = static_cast<float>(ball.place[2] + radius * bulge);
        float& nearest = depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x)];
        if (here <= nearest)
            return;
        nearest = here;
        for (std::size_t c = 0; c < 3; ++c)
            image.at(x, y)[c] =
                static_cast<std::uint8_t>(std::lround(ball.color[c] * (0.5 + 0.5 * bulge)));
    }
};

void add_classes(const Coloring& coloring, Image& image) {
    int x = margin;
    const int y = image.height - margin - words_height();
    for (const auto& [color, name] : coloring.classes) {
        image.fill(x, y + 2, x + 12, y + 14, color);
        image.words.push_back({x + 20, y, name});
        x += 20 + words_width(name) + 30;
    }
}

void add_scale(const Coloring& coloring, Image& image) {
    const int length = std::min(320, image.width - 2 * margin);
    const int y = image.height - margin - words_height();
    for (int x = 0; x < length; ++x)
        image.fill(margin + x, y - 18, margin + x + 1, y - 4,
                   scale_color(coloring.is_signed, (x + 0.5) / length));
    const std::string low = rounded_text(coloring.low, 4);
    const std::string high = rounded_text(coloring.high, 4);
    image.words.push_back({margin, y, low});
    image.words.push_back({margin + length - words_width(high), y, high});
    image.words.push_back({margin + length + 16, y - 18, coloring.quantity});
}

} // namespace

Image draw_particles(const Snapshot& snapshot, const Coloring& coloring,
                     const PictureOptions& options) {
    const auto axes = view_axes(options, snapshot.dimension);
    std::optional<Cut> cut = options.cut;
    if (cut && !cut->place)
        cut->place = middle(snapshot.positions, cut->axis);
    std::vector<Ball> balls;
    add_balls(snapshot.positions, cut, axes, coloring.colors, balls);
    if (options.with_boundary)
        add_balls(snapshot.boundary, cut, axes, {}, balls);
    Canvas canvas(2 * options.width, 2 * options.height);
    if (!balls.empty()) {
        const Frame frame = frame_of(balls, options);
        for (const Ball& ball : balls)
            canvas.draw(ball, 2 * (frame.left + frame.scale * ball.place[0]),
                        2 * (frame.top - frame.scale * ball.place[1]),
                        std::max(frame.scale * options.diameter, 1.0), 2 * frame.scale);
    }
    Image image = canvas.halved();
    if (!options.title.empty())
        image.words.push_back({margin, margin / 2, options.title});
    if (coloring.classes.empty())
        add_scale(coloring, image);
    else
        add_classes(coloring, image);
    return image;
}

} // namespace meniscus
