#include "drawing.hpp"

#include <meniscus/data/packing/bytes.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr double pixels = 1.5; ///< of a PNG, a unit

std::string hex(const Color& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

/// A length in tenths, without trailing zeros.
std::string length_text(double length) {
    return fmt::format("{:g}", std::round(10 * length) / 10);
}

std::string svg_of(const Stroke& stroke) {
    std::string points;
    for (const auto& [x, y] : stroke.points)
        points += (points.empty() ? "" : " ") + length_text(x) + "," + length_text(y);
    return fmt::format("<polyline points=\"{}\" stroke=\"{}\" stroke-width=\"{}\" fill=\"none\"/>",
                       points, hex(stroke.color), length_text(stroke.width));
}

std::string svg_of(const Dot& dot) {
    return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}=\"{}\"{}/>",
                       length_text(dot.middle.x), length_text(dot.middle.y),
                       length_text(dot.radius), dot.is_filled ? "fill" : "stroke", hex(dot.color),
                       dot.is_filled ? "" : " fill=\"none\"");
}

std::string svg_of(const Lettering& lettering) {
    const std::string x = length_text(lettering.place.x);
    const std::string y = length_text(lettering.place.y);
    const char* anchor = lettering.anchor == Anchor::begin    ? ""
                         : lettering.anchor == Anchor::middle ? " text-anchor=\"middle\""
                                                              : " text-anchor=\"end\"";
    const std::string turn =
        lettering.is_upward ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "";
    return fmt::format("<text x=\"{}\" y=\"{}\" dy=\"4\" fill=\"{}\"{}{}>{}</text>", x, y,
                       hex(lettering.color), anchor, turn, escaped_in_svg(lettering.text));
}

std::string svg_of(const Mosaic& mosaic) {
    return fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                       "preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" "
                       "href=\"data:image/png;base64,{}\"/>",
                       length_text(mosaic.corner.x), length_text(mosaic.corner.y),
                       length_text(mosaic.cell * mosaic.cells.width),
                       length_text(mosaic.cell * mosaic.cells.height),
                       base64(to_png(mosaic.cells)));
}

/// The part of a pixel, 0 to 1, that takes the color.
void blend(Image& image, int x, int y, const Color& color, double part) {
    for (std::size_t c = 0; c < 3; ++c) {
        const double old = image.at(x, y)[c];
        image.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(old + part * (color[c] - old)));
    }
}

/// Blends the color into the pixels of a box, by how far their middles are from what is drawn;
/// `distance(x, y)` is negative inside.
template <class Distance>
void paint(Image& image, const DrawingPoint& low, const DrawingPoint& high, const Color& color,
           const Distance& distance) {
    const auto within = [](double place, int end) {
        return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(end)));
    };
    for (int y = within(low.y - 1, image.height); y < within(high.y + 2, image.height); ++y)
        for (int x = within(low.x - 1, image.width); x < within(high.x + 2, image.width); ++x) {
            const double part = std::clamp(0.5 - distance(x + 0.5, y + 0.5), 0.0, 1.0);
            if (part > 0)
                blend(image, x, y, color, part);
        }
}

DrawingPoint scaled(const DrawingPoint& place) {
    return {pixels * place.x, pixels * place.y};
}

void paint_segment(Image& image, const DrawingPoint& a, const DrawingPoint& b,
                   const Stroke& stroke) {
    const double radius = pixels * stroke.width / 2;
    const double squared = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    const auto distance = [&](double x, double y) {
        const double along = (x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y);
        const double share = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
        return std::hypot(x - a.x - share * (b.x - a.x), y - a.y - share * (b.y - a.y)) - radius;
    };
    paint(image, {std::min(a.x, b.x) - radius, std::min(a.y, b.y) - radius},
          {std::max(a.x, b.x) + radius, std::max(a.y, b.y) + radius}, stroke.color, distance);
}

void paint(Image& image, const Stroke& stroke) {
    for (std::size_t k = 1; k < stroke.points.size(); ++k)
        paint_segment(image, scaled(stroke.points[k - 1]), scaled(stroke.points[k]), stroke);
}

void paint(Image& image, const Dot& dot) {
    const DrawingPoint middle = scaled(dot.middle);
    const double radius = pixels * dot.radius;
    paint(image, {middle.x - radius, middle.y - radius}, {middle.x + radius, middle.y + radius},
          dot.color, [&](double x, double y) {
              const double outside = std::hypot(x - middle.x, y - middle.y) - radius;
              return dot.is_filled ? outside : std::abs(outside) - pixels / 2;
          });
}

void paint(Image& image, const Lettering& lettering) {
    const double share = lettering.anchor == Anchor::begin    ? 0
                         : lettering.anchor == Anchor::middle ? 0.5
                                                              : 1;
    const double before = share * words_width(lettering.text);
    const double half = words_height() / 2.0;
    const auto [x, y] = scaled(lettering.place);
    const auto whole = [](double place) { return static_cast<int>(std::lround(place)); };
    if (lettering.is_upward)
        draw_words(image, {whole(x - half), whole(y + before), lettering.text}, lettering.color,
                   true);
    else
        draw_words(image, {whole(x - before), whole(y - half), lettering.text}, lettering.color);
}

void paint(Image& image, const Mosaic& mosaic) {
    const auto edge = [&](double corner, int cell) {
        return static_cast<int>(std::lround(pixels * (corner + cell * mosaic.cell)));
    };
    for (int y = 0; y < mosaic.cells.height; ++y)
        for (int x = 0; x < mosaic.cells.width; ++x)
            image.fill(edge(mosaic.corner.x, x), edge(mosaic.corner.y, y),
                       edge(mosaic.corner.x, x + 1), edge(mosaic.corner.y, y + 1),
                       mosaic.cells.pixels[static_cast<std::size_t>(y) *
                                               static_cast<std::size_t>(mosaic.cells.width) +
                                           static_cast<std::size_t>(x)]);
}

} // namespace

double lettering_width(const std::string& text) {
    return words_width(text) / pixels;
}

std::string to_svg(const Drawing& drawing) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"Arial, Helvetica, sans-serif\" font-size=\"11.5\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        drawing.width, drawing.height);
    for (const auto& shape : drawing.shapes)
        svg += std::visit([](const auto& one) { return svg_of(one); }, shape) + "\n";
    return svg + "</svg>\n";
}

std::string to_png(const Drawing& drawing) {
    Image image(static_cast<int>(pixels * drawing.width),
                static_cast<int>(pixels * drawing.height));
    for (const auto& shape : drawing.shapes)
        std::visit([&](const auto& one) { paint(image, one); }, shape);
    return to_png(image);
}

} // namespace meniscus
