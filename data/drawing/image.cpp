#include "image.hpp"

#include "detail/glyphs.hpp"
#include <meniscus/data/packing/bytes.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {
namespace {

/// Calls set(column, row) for each pixel of a letter that is set.
template <class Set>
void for_each_pixel(char letter, const Set& set) {
    constexpr int count = sizeof glyphs / sizeof *glyphs;
    const int place = letter - first_glyph;
    const auto& rows = glyphs[place >= 0 && place < count ? place : '?' - first_glyph];
    for (int row = 0; row < glyph_height; ++row)
        for (int column = 0; column < glyph_width; ++column)
            if ((rows[row] >> (glyph_width - 1 - column) & 1) != 0)
                set(column, row);
}

std::string big_endian(std::uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(number >> static_cast<unsigned>(shift) & 255U);
    return bytes;
}

std::string chunk(const std::string& type_and_data) {
    return big_endian(static_cast<std::uint32_t>(type_and_data.size() - 4)) + type_and_data +
           big_endian(crc_32(type_and_data));
}

/// Rows of pixels, each behind a byte that says how it is filtered: as the difference to the pixel
/// before (1), which compresses plain areas well.
std::string filtered_rows(const Image& image) {
    std::string rows;
    rows.reserve(image.pixels.size() * 3 + static_cast<std::size_t>(image.height));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const bool is_first = i % static_cast<std::size_t>(image.width) == 0;
        if (is_first)
            rows += '\1';
        for (std::size_t channel = 0; channel < 3; ++channel)
            rows += static_cast<char>(image.pixels[i][channel] -
                                      (is_first ? 0 : image.pixels[i - 1][channel]));
    }
    return rows;
}

} // namespace

void Image::fill(int left, int top, int right, int bottom, const Color& color) {
    for (int y = std::max(top, 0); y < std::min(bottom, height); ++y)
        for (int x = std::max(left, 0); x < std::min(right, width); ++x)
            at(x, y) = color;
}

int words_width(const std::string& text) {
    return static_cast<int>(text.size()) * glyph_width;
}

int words_height() {
    return glyph_height;
}

void draw_words(Image& image, const Words& words, const Color& color, bool upward) {
    for (std::size_t letter = 0; letter < words.text.size(); ++letter)
        for_each_pixel(words.text[letter], [&](int column, int row) {
            column += static_cast<int>(letter) * glyph_width;
            const int x = words.x + (upward ? row : column);
            const int y = words.y + (upward ? -column : row);
            if (x >= 0 && x < image.width && y >= 0 && y < image.height)
                image.at(x, y) = color;
        });
}

std::string escaped_in_svg(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '&'   ? "&amp;"
                  : c == '<' ? "&lt;"
                  : c == '>' ? "&gt;"
                             : std::string(1, static_cast<unsigned char>(c) < ' ' ? '?' : c);
    return result;
}

std::string to_png(const Image& image) {
    Image drawn = image;
    for (const Words& words : image.words)
        draw_words(drawn, words);
    const std::string size = big_endian(static_cast<std::uint32_t>(image.width)) +
                             big_endian(static_cast<std::uint32_t>(image.height));
    // 8 bits a channel, red, green and blue, deflate, filters row by row, not interlaced.
    const std::string kind("\x08\x02\x00\x00\x00", 5);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR" + size + kind) +
           chunk("IDAT" + deflated(filtered_rows(drawn))) + chunk("IEND");
}

std::string to_svg(const Image& image) {
    Image without_words = image;
    without_words.words.clear();
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\">\n<image width=\"{0}\" height=\"{1}\" href=\"data:image/png;base64,{2}\"/>\n"
        "<g font-family=\"sans-serif\" font-size=\"15\" fill=\"#1b1b1b\">\n",
        image.width, image.height, base64(to_png(without_words)));
    for (const auto& [x, y, text] : image.words)
        svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", x, y + 12, escaped_in_svg(text));
    return svg + "</g>\n</svg>\n";
}

} // namespace meniscus
