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

/// Appends a row of pixels in a graphics card's order (XRGB8888: blue, green, red, unused) to a picture's
/// pixels.
void append_xrgb(const std::byte* row, int width, std::vector<std::byte>& pixels);

/// Writes an opaque picture as a PNG file. Replaces an existing file.
/// @throws std::runtime_error naming the file
void save_png(const Picture& picture, const std::filesystem::path& path);

/// Writes a picture as a JPEG file. It replaces an existing file by rename, so no half file is seen.
void save_jpeg(const Picture& picture, const std::filesystem::path& path);

/// Draws an SVG text as a picture of this size in px, on white.
/// @throws std::runtime_error if the text cannot be read as SVG
Picture drawn_svg(const std::string& svg, int width, int height);

}  // namespace vitrine::player
