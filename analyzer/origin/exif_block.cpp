#include "analyzer/origin/exif_block.hpp"

#include "base/media/file_bytes.hpp"
#include "base/media/heif_reader.hpp"

#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>

namespace vitrine::analyzer {

namespace {

constexpr int max_parts = 1000;                             // segments or chunks that are read
constexpr std::uint64_t max_exif = std::uint64_t{1} << 20;  // bytes
constexpr std::string_view exif_mark("Exif\0\0", 6);

/// A part of a file.
struct Part {
    std::uint64_t at = 0;
    std::uint64_t bytes = 0;
};

std::vector<std::byte> bytes_of(const FileBytes& file, const Part& part) {
    if (part.bytes > max_exif) return {};
    std::vector<std::byte> bytes(part.bytes);
    bytes.resize(file.read(part.at, bytes));
    if (bytes.size() >= exif_mark.size() &&
        std::memcmp(bytes.data(), exif_mark.data(), exif_mark.size()) == 0)
        bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(exif_mark.size()));
    return bytes;
}

/// JPEG: segments with a marker and a length, up to the picture's data.
std::optional<Part> jpeg_part(const FileBytes& file) {
    constexpr int app1 = 0xe1;
    constexpr int start_of_scan = 0xda;
    std::uint64_t at = 2;
    for (int i = 0; i < max_parts; ++i) {
        const auto head = file.at<10>(at);
        if (!head || (*head)[0] != 0xff || (*head)[1] == start_of_scan) return std::nullopt;
        const std::uint64_t length = big_endian(*head, 2, 2);
        if (length < 2) return std::nullopt;
        if ((*head)[1] == app1 && std::memcmp(head->data() + 4, exif_mark.data(), exif_mark.size()) == 0)
            return Part{.at = at + 4, .bytes = length - 2};
        at += 2 + length;
    }
    return std::nullopt;
}

/// The layout of chunks, each with a name and a length.
struct ChunkLayout {
    std::uint64_t first;  // byte of the first chunk
    std::size_t name_at;  // in the chunk's head of 8 bytes
    bool is_big_endian;
    std::uint64_t trailing;  // bytes behind the data
    std::string_view name;   // of the chunk with the EXIF
};

constexpr ChunkLayout png_layout{
    .first = 8, .name_at = 4, .is_big_endian = true, .trailing = 4, .name = "eXIf"};
constexpr ChunkLayout webp_layout{
    .first = 12, .name_at = 0, .is_big_endian = false, .trailing = 0, .name = "EXIF"};

std::optional<Part> chunk_part(const FileBytes& file, const ChunkLayout& layout) {
    std::uint64_t at = layout.first;
    for (int i = 0; i < max_parts; ++i) {
        const auto head = file.at<8>(at);
        if (!head) return std::nullopt;
        const std::size_t length_at = 4 - layout.name_at;
        const std::uint64_t length =
            layout.is_big_endian ? big_endian(*head, length_at, 4) : little_endian(*head, length_at, 4);
        if (std::memcmp(head->data() + layout.name_at, layout.name.data(), 4) == 0)
            return Part{.at = at + 8, .bytes = length};
        at += 8 + length + layout.trailing;
        if (!layout.is_big_endian) at += length & 1U;
    }
    return std::nullopt;
}

}  // namespace

std::vector<std::byte> exif_block(const std::string& path, MediaFormat format) {
    if (format == MediaFormat::heif) return heif_exif(path);
    const FileBytes file(path);
    std::optional<Part> part;
    if (format == MediaFormat::jpeg) part = jpeg_part(file);
    if (format == MediaFormat::png) part = chunk_part(file, png_layout);
    if (format == MediaFormat::webp) part = chunk_part(file, webp_layout);
    return part ? bytes_of(file, *part) : std::vector<std::byte>();
}

}  // namespace vitrine::analyzer
