#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// A picture: RGBA, 8 bits a channel, rows from the top, no padding.
struct Picture {
    int width = 0;  // px
    int height = 0;
    std::vector<std::byte> pixels;  // width * height * 4
};

/// A picture as graphics cards hold it: XRGB8888 (blue, green, red, unused), no padding. It can be copied
/// from a screen in a few milliseconds; to_picture() takes longer.
struct CardPicture {
    /// The pixels are not defined yet.
    CardPicture(int its_width, int its_height);

    /// Row y of those in memory, 4 * width bytes.
    std::span<std::byte> row(int y) const;

    int width;  // px
    int height;
    bool is_bottom_first = false;         // the order of GL; else the top row comes first
    std::shared_ptr<std::byte[]> pixels;  // copies share them
};

/// Lends memory to one picture after the other: to the next one that of the last, unless somebody still holds
/// it. Fresh memory can cost more time than the copy of a picture.
class CardPictureMemory {
  public:
    CardPicture next(int width, int height);

  private:
    CardPicture last_{0, 0};
};

/// The same picture in the order of Picture, opaque.
Picture to_picture(const CardPicture& card);

/// Writes an opaque picture as a PNG file. Replaces an existing file.
/// @throws std::runtime_error naming the file
void save_png(const Picture& picture, const std::filesystem::path& path);

/// Writes a picture as a JPEG file. It replaces an existing file by rename, so no half file is seen.
void save_jpeg(const Picture& picture, const std::filesystem::path& path);

/// Draws an SVG text as a picture of this size in px, on white.
/// @throws std::runtime_error if the text cannot be read as SVG
Picture drawn_svg(const std::string& svg, int width, int height);

}  // namespace vitrine::player
