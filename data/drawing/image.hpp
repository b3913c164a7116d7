// A picture as pixels with words beside it, and how it is written: PNG with the words drawn in, or
// SVG with the words as text. The same input gives the same bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meniscus {

using Color = std::array<std::uint8_t, 3>; ///< red, green, blue

inline constexpr Color white = {255, 255, 255};
inline constexpr Color ink = {27, 27, 27};

/// Words on a picture; x and y are the upper left corner in pixels.
struct Words {
    int x = 0;
    int y = 0;
    std::string text;
};

struct Image {
    int width = 0;
    int height = 0;
    std::vector<Color> pixels; ///< rows from above
    std::vector<Words> words;

    Image(int width, int height)
        : width(width), height(height),
          pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), white) {}

    /// The pixel at a place within the image.
    Color& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    /// Fills what of a rectangle lies within the image.
    void fill(int left, int top, int right, int bottom, const Color& color);
};

/// Width in pixels of words, and height of a line of them.
int words_width(const std::string& text);
int words_height();

/// Draws words whose upper left corner this is; upward, those that are read from below, whose lower
/// left corner it is. Letters outside ASCII are shown as '?'.
void draw_words(Image& image, const Words& words, const Color& color = ink, bool upward = false);

/// The text as it may stand in an SVG between tags.
std::string escaped_in_svg(const std::string& text);

/// The file's bytes: a PNG of 8 bits a channel. Letters outside ASCII are shown as '?'. Throws
/// FailureError where memory lacks.
std::string to_png(const Image& image);

/// The file's bytes: an SVG with the pixels as an embedded PNG and the words as text.
std::string to_svg(const Image& image);

} // namespace meniscus
