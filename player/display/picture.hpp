#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::player {

/// The picture that a screen showed at one moment: RGBA, 8 bits a channel, rows from the top, no padding.
struct Picture {
    int width = 0;  // px
    int height = 0;
    std::vector<std::byte> pixels;  // width * height * 4
};

/// Appends a row of pixels as graphics cards have them (XRGB8888: blue, green, red, nothing) to a picture's.
void append_xrgb(const std::byte* row, int width, std::vector<std::byte>& pixels);

/// Writes an opaque picture as a PNG file, replacing what is there.
/// @throws std::runtime_error naming the file
void save_png(const Picture& picture, const std::filesystem::path& path);

/// The same as a JPEG file, replacing what is there as a whole: written beside and renamed.
void save_jpeg(const Picture& picture, const std::filesystem::path& path);

/// A drawing as a picture of a size in px, on white.
/// @throws std::runtime_error where it cannot be read as SVG
Picture drawn_svg(const std::string& svg, int width, int height);

}  // namespace vitrine::player
