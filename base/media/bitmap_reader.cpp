#include "base/media/bitmap_reader.hpp"

#include "base/media/file_bytes.hpp"
#include "base/state/media_error.hpp"

#include <array>
#include <bit>
#include <cstdlib>
#include <span>

namespace vitrine {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

[[noreturn]] void cut_short() {
    throw MediaError(MediaState::waiting, "the copy is not complete: part of the picture is missing");
}

struct Header {
    std::uint32_t pixels_at = 0;  // byte in the file
    int width = 0;                // px
    int height = 0;
    bool bottom_up = true;
    int bits = 24;                         // bits a pixel
    std::array<std::uint32_t, 3> masks{};  // red, green and blue of 16 and 32 bits a pixel
    std::vector<Rgb> palette;

    std::size_t row_bytes() const {
        return (static_cast<std::size_t>(width) * static_cast<std::size_t>(bits) + 31) / 32 * 4;
    }
};

class Reader {
  public:
    explicit Reader(const std::string& path) : file_(path) {}

    void to(std::uint32_t offset) { at_ = offset; }

    void read(std::span<std::uint8_t> row) {
        if (file_.read(at_, std::as_writable_bytes(row)) < row.size()) cut_short();
        at_ += row.size();
    }

    std::uint32_t little(std::size_t count) {
        std::array<std::uint8_t, 4> bytes{};
        read(std::span(bytes).first(count));
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < count; ++i)
            value |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
        return value;
    }

  private:
    FileBytes file_;
    std::uint64_t at_ = 0;  // byte in the file
};

void require_sane(const Header& header, std::uint32_t compression) {
    const auto pixels = std::int64_t{header.width} * header.height;
    if (header.width <= 0 || header.height <= 0)
        throw MediaError(MediaState::failed, "the picture is damaged: it has no size");
    if (header.width > max_still_side || header.height > max_still_side || pixels > max_bitmap_pixels)
        throw MediaError(MediaState::unsupported, "the picture is too large to be shown");
    constexpr std::uint32_t plain = 0;
    constexpr std::uint32_t bit_fields = 3;
    if (compression != plain && compression != bit_fields)
        throw MediaError(MediaState::unsupported, "this BMP picture is compressed; save it as PNG or JPEG");
    constexpr std::array depths{1, 4, 8, 16, 24, 32};
    if (std::find(depths.begin(), depths.end(), header.bits) == depths.end())
        throw MediaError(MediaState::failed, "the picture is damaged: its number of colours is impossible");
}

void read_palette(Reader& file, Header& header, std::uint32_t colours, bool old) {
    const std::uint32_t max_colours = std::uint32_t{1} << header.bits;
    header.palette.assign(max_colours, Rgb{});
    const std::uint32_t given = colours == 0 || colours > max_colours ? max_colours : colours;
    for (std::uint32_t i = 0; i < given; ++i) {
        const std::uint32_t entry = file.little(old ? 3 : 4);
        header.palette[i] = {static_cast<std::uint8_t>(entry >> 16), static_cast<std::uint8_t>(entry >> 8),
                             static_cast<std::uint8_t>(entry)};
    }
}

Header read_header(Reader& file) {
    Header header;
    file.to(10);
    header.pixels_at = file.little(4);
    const std::uint32_t header_bytes = file.little(4);
    const bool old = header_bytes == 12;  // OS/2 1.x
    const auto width = static_cast<std::int32_t>(old ? file.little(2) : file.little(4));
    const auto height = static_cast<std::int32_t>(old ? file.little(2) : file.little(4));
    header.width = width;
    header.bottom_up = height > 0;
    header.height = height < -max_still_side ? max_still_side + 1 : std::abs(height);
    file.little(2);  // planes
    header.bits = static_cast<int>(file.little(2));
    std::uint32_t compression = 0;
    std::uint32_t colours = 0;
    if (!old) {
        compression = file.little(4);
        file.to(46);
        colours = file.little(4);
        file.to(54);
    }
    require_sane(header, compression);
    header.masks = header.bits == 16 ? std::array<std::uint32_t, 3>{0x7c00, 0x3e0, 0x1f}
                                     : std::array<std::uint32_t, 3>{0xff0000, 0xff00, 0xff};
    if (compression == 3)
        for (auto& mask : header.masks)
            mask = file.little(4);
    if (header.bits <= 8) {
        file.to(14 + header_bytes);
        read_palette(file, header, colours, old);
    }
    return header;
}

std::uint8_t channel(std::uint32_t pixel, std::uint32_t mask) {
    if (mask == 0) return 0;
    const std::uint32_t max_value = mask >> std::countr_zero(mask);
    const std::uint64_t value = (pixel & mask) >> std::countr_zero(mask);
    return static_cast<std::uint8_t>(value * 255 / max_value);
}

Rgb pixel_at(const Header& header, const std::vector<std::uint8_t>& row, std::size_t x) {
    const auto bits = static_cast<std::size_t>(header.bits);
    if (bits <= 8) {
        const std::size_t at = x * bits;
        const std::size_t shift = 8 - bits - at % 8;
        return header.palette[row[at / 8] >> shift & ((1U << bits) - 1)];
    }
    const std::size_t at = x * bits / 8;
    if (bits == 24) return {row[at + 2], row[at + 1], row[at]};
    std::uint32_t pixel = 0;
    for (std::size_t i = 0; i < bits / 8; ++i)
        pixel |= static_cast<std::uint32_t>(row[at + i]) << (8 * i);
    return {channel(pixel, header.masks[0]), channel(pixel, header.masks[1]),
            channel(pixel, header.masks[2])};
}

}  // namespace

StillPicture read_bitmap(const std::string& path) {
    Reader file(path);
    const Header header = read_header(file);
    const auto width = static_cast<std::size_t>(header.width);
    const auto height = static_cast<std::size_t>(header.height);
    StillPicture picture{.width = header.width,
                         .height = header.height,
                         .full = {.width = header.width, .height = header.height},
                         .pixels = {}};
    std::vector<std::uint8_t> row(header.row_bytes());
    file.to(header.pixels_at);
    for (std::size_t line = 0; line < height; ++line) {
        file.read(row);
        if (picture.pixels.empty())
            picture.pixels.resize(4 * width * height);  // allocated only once the first row was read
        std::byte* out = picture.pixels.data() + 4 * width * (header.bottom_up ? height - 1 - line : line);
        for (std::size_t x = 0; x < width; ++x) {
            for (const std::uint8_t value : pixel_at(header, row, x))
                *out++ = std::byte{value};
            *out++ = std::byte{255};
        }
    }
    return picture;
}

}  // namespace vitrine
