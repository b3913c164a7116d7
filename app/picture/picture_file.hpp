// The file that a picture is written to, told by its ending.
#pragma once

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <filesystem>
#include <string>

namespace meniscus {

/// Throws InputError unless the name ends in .png or .svg.
inline void check_picture_name(const std::filesystem::path& file) {
    const std::string kind = lowered(file.extension().string());
    if (kind != ".png" && kind != ".svg")
        throw InputError(file.string() + ": expected a name that ends in .png or .svg");
}

/// Bytes of an Image or a Drawing for a file of such a name.
template <class Picture>
std::string picture_bytes(const Picture& picture, const std::filesystem::path& file) {
    return lowered(file.extension().string()) == ".png" ? to_png(picture) : to_svg(picture);
}

} // namespace meniscus
