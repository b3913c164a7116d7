// Pictures of the command read back.
#pragma once

#include <gtest/gtest.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace meniscus {

using Color = std::array<int, 3>;

/// The pixels of a PNG as the command writes it: differences to the pixel before, in rows.
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

} // namespace meniscus
