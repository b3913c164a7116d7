// A picture of lines, dots and words: as SVG, which stays sharp at any size, or as PNG, for what
// takes no SVG. The same drawing gives the same bytes.
#pragma once

#include "image.hpp"

#include <string>
#include <variant>
#include <vector>

namespace meniscus {

/// To the right and downward from the upper left corner.
struct DrawingPoint {
    double x = 0;
    double y = 0;
};

struct Stroke {
    std::vector<DrawingPoint> points;
    Color color = ink;
    double width = 1;
};

struct Dot {
    DrawingPoint middle;
    double radius = 1;
    Color color = ink;
    bool is_filled = true; ///< or a ring
};

/// Which part of words stands at their place.
enum class Anchor { begin, middle, end };

struct Lettering {
    DrawingPoint place; ///< at half the letters' height
    std::string text;
    Color color = ink;
    Anchor anchor = Anchor::begin;
    bool is_upward = false; ///< read from below
};

/// Pixels, each a square of the drawing.
struct Mosaic {
    DrawingPoint corner; ///< upper left
    double cell = 1;
    Image cells;
};

/// What comes later covers what comes earlier.
struct Drawing {
    int width = 0;
    int height = 0;
    std::vector<std::variant<Stroke, Dot, Lettering, Mosaic>> shapes;
};

/// About the width and height of words in a drawing; fonts of viewers differ.
double lettering_width(const std::string& text);
inline constexpr double lettering_height = 12;

/// The file's bytes.
std::string to_svg(const Drawing& drawing);

/// The same, half again as wide and as high in pixels. Throws FailureError where memory lacks.
std::string to_png(const Drawing& drawing);

} // namespace meniscus
