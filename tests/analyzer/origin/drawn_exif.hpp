#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// An entry of EXIF: text, or bytes that are taken as they are.
struct ExifLine {
    int tag = 0;
    int type = 2;  // 2: text, 5: fractions, 7: bytes
    std::string bytes{};
};

inline std::string number_bytes(std::uint64_t value, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

/// A directory of EXIF with its values behind it. @param at  its place behind the TIFF header's begin
inline std::string exif_directory(const std::vector<ExifLine>& lines, std::uint64_t at) {
    std::string directory = number_bytes(lines.size(), 2);
    std::string values;
    const std::uint64_t values_at = at + 2 + 12 * lines.size() + 4;
    for (const ExifLine& line : lines) {
        const std::string bytes = line.type == 2 ? line.bytes + '\0' : line.bytes;
        const std::uint64_t unit = line.type == 5 ? 8 : line.type == 4 ? 4 : 1;
        directory += number_bytes(static_cast<std::uint64_t>(line.tag), 2);
        directory += number_bytes(static_cast<std::uint64_t>(line.type), 2);
        directory += number_bytes(bytes.size() / unit, 4);
        directory += bytes.size() <= 4 ? bytes + std::string(4 - bytes.size(), '\0')
                                       : number_bytes(values_at + values.size(), 4);
        if (bytes.size() > 4) values += bytes;
    }
    return directory + number_bytes(0, 4) + values;
}

/// The lines that a camera wrote, in the three directories of EXIF.
struct DrawnExif {
    std::vector<ExifLine> main{};
    std::vector<ExifLine> photo{};
    std::vector<ExifLine> gps{};

    /// Little-endian, from the TIFF header on.
    std::string bytes() const {
        constexpr std::uint64_t main_at = 8;
        std::vector<ExifLine> lines = main;
        const auto end = [&] { return main_at + exif_directory(lines, main_at).size(); };
        lines.push_back({.tag = 0x8769, .type = 4, .bytes = number_bytes(0, 4)});
        lines.push_back({.tag = 0x8825, .type = 4, .bytes = number_bytes(0, 4)});
        const std::uint64_t photo_at = end();
        const std::string photo_bytes = exif_directory(photo, photo_at);
        const std::uint64_t gps_at = photo_at + photo_bytes.size();
        lines[lines.size() - 2].bytes = number_bytes(photo_at, 4);
        lines[lines.size() - 1].bytes = number_bytes(gps_at, 4);
        return std::string("II*\0", 4) + number_bytes(main_at, 4) + exif_directory(lines, main_at) +
               photo_bytes + exif_directory(gps, gps_at);
    }
};

/// The beginning of a JPEG with EXIF; nothing behind it can be decoded.
inline std::string jpeg_with(const std::string& exif) {
    const std::string content = std::string("Exif\0\0", 6) + exif;
    const std::size_t length = content.size() + 2;
    return std::string("\xff\xd8\xff\xe0\0\x04JF", 8) + "\xff\xe1" + static_cast<char>(length >> 8U) +
           static_cast<char>(length) + content + "\xff\xda";
}

}  // namespace vitrine::analyzer
