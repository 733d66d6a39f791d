#include "base/media/completeness.hpp"

#include "base/media/file_bytes.hpp"
#include "base/media/gif_extent.hpp"
#include "base/state/media_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

namespace vitrine {

namespace {

constexpr int max_boxes = 100'000;                // boxes read at the top level of one file
constexpr std::uint64_t slack = 8;                // bytes that careless writers declare in excess
constexpr std::uint64_t trailing_zeros = 65'536;  // bytes of padding that a sparse copy may leave out
constexpr std::uint64_t unlimited = std::uint64_t{1} << 62;  // larger sizes are nonsense and would overflow

template <std::size_t N>
bool is_name(const std::array<std::uint8_t, N>& bytes, std::size_t from, const char* name) {
    return std::memcmp(bytes.data() + from, name, 4) == 0;
}

// ISO base media: boxes with size and type follow each other to the end of the file.
FileExtent iso_extent(const FileBytes& file, const char* index) {
    FileExtent extent{.present = file.size(), .declared = 0, .has_index = false};
    std::uint64_t offset = 0;
    for (int box = 0; box < max_boxes; ++box) {
        const auto head = file.at<16>(offset);
        if (!head) {
            const auto name = file.at<8>(offset);
            const std::uint64_t size = name ? big_endian(*name, 0, 4) : 0;
            if (name && size >= 8) extent.declared = offset + size;  // a box of less than 16 bytes at the end
            return extent;
        }
        std::uint64_t size = big_endian(*head, 0, 4);
        const bool named = std::all_of(head->begin() + 4, head->begin() + 8, [](auto c) { return c >= 32; });
        if (size == 1) size = big_endian(*head, 8, 8);
        if (is_name(*head, 4, index)) extent.has_index = true;
        if (!named || size < 8) return extent;  // the box reaches to the end, or this is not a box
        extent.declared = offset + std::min(size, unlimited);
        if (extent.declared >= file.size()) return extent;
        offset = extent.declared;
    }
    return extent;
}

// RIFF: one or, in long AVI files, several chunks with a size.
FileExtent riff_extent(const FileBytes& file) {
    FileExtent extent{.present = file.size()};
    std::uint64_t offset = 0;
    for (int chunk = 0; chunk < max_boxes; ++chunk) {
        const auto head = file.at<8>(offset);
        if (!head || !is_name(*head, 0, "RIFF")) return extent;
        const std::uint64_t size = little_endian(*head, 4, 4);
        if (size == 0 || size == std::numeric_limits<std::uint32_t>::max())
            return extent;  // a recording writes the size at its end
        extent.declared = offset + 8 + size;
        offset = extent.declared + (size & 1);
    }
    return extent;
}

// Matroska: the EBML header, then a segment with its size or the mark for an unknown size.
FileExtent matroska_extent(const FileBytes& file) {
    FileExtent extent{.present = file.size()};
    constexpr std::uint64_t segment = 0x18538067;
    std::uint64_t offset = 0;
    for (int element = 0; element < 16; ++element) {
        const auto head = file.at<12>(offset);
        if (!head) return extent;
        const auto id_bytes = 1 + static_cast<std::size_t>(std::countl_zero((*head)[0]));
        if (id_bytes > 4) return extent;
        const auto size_bytes = 1 + static_cast<std::size_t>(std::countl_zero((*head)[id_bytes]));
        if (size_bytes > 8) return extent;
        const std::uint64_t mask = (std::uint64_t{1} << (7 * size_bytes)) - 1;
        const std::uint64_t size = big_endian(*head, id_bytes, size_bytes) & mask;
        if (size == mask) return extent;  // unknown: a live recording
        offset += id_bytes + size_bytes + std::min(size, unlimited);
        if (big_endian(*head, 0, id_bytes) == segment) {
            extent.declared = offset;
            return extent;
        }
    }
    return extent;
}

// PNG: chunks up to IEND; data after it does not matter.
FileExtent png_extent(const FileBytes& file) {
    FileExtent extent{.present = file.size()};
    std::uint64_t offset = 8;
    for (int chunk = 0; chunk < max_boxes; ++chunk) {
        const auto head = file.at<8>(offset);
        constexpr std::uint64_t around = 12;  // length, name and checksum of a chunk
        if (!head) {
            extent.declared = std::max(offset, file.size()) + around;
            return extent;
        }
        extent.declared = offset + around + big_endian(*head, 0, 4);
        if (is_name(*head, 4, "IEND")) return extent;
        if (extent.declared > file.size()) {
            extent.declared += around;  // for IEND, which is missing
            return extent;
        }
        offset = extent.declared;
    }
    return extent;
}

// Reads the numbers of a TIFF file. The first letter of the file tells the order of their bytes.
class TiffNumbers {
  public:
    TiffNumbers(const FileBytes& file, bool big) : file_(file), big_(big) {}

    /// A number. None: it lies beyond the end. @param count  bytes, up to 8
    std::optional<std::uint64_t> at(std::uint64_t offset, std::uint64_t count) const {
        if (offset > file_.size() || offset + count > file_.size()) return std::nullopt;
        std::uint64_t value = 0;
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto byte = file_.at<1>(offset + (big_ ? i : count - 1 - i));
            if (!byte) return std::nullopt;
            value = value << 8 | (*byte)[0];
        }
        return value;
    }

  private:
    const FileBytes& file_;  // outlives this
    bool big_;
};

// A list of numbers in a TIFF file.
struct TiffList {
    std::uint64_t at = 0;
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;  // size of one number, 2 to 8
};

// The byte after the last piece of a picture. @param starts, lengths  lists of the pieces' places and lengths
std::uint64_t pieces_end(const TiffNumbers& numbers, const TiffList& starts, const TiffList& lengths) {
    std::uint64_t end = 0;
    const std::uint64_t count = std::min({starts.count, lengths.count, std::uint64_t{max_boxes}});
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto start = numbers.at(starts.at + i * starts.bytes, starts.bytes);
        const auto length = numbers.at(lengths.at + i * lengths.bytes, lengths.bytes);
        if (start && length) end = std::max(end, std::min(*start, unlimited) + std::min(*length, unlimited));
    }
    return end;
}

// The layout of a directory: TIFF counts with 4 bytes, BigTIFF, for files beyond 4 GiB, with 8.
struct TiffLayout {
    std::uint64_t directory_at = 4;  // byte of the file that holds its position
    std::uint64_t number_bytes = 4;  // size of a position or a count
    std::uint64_t entries_bytes = 2;

    std::uint64_t entry_bytes() const { return 4 + 2 * number_bytes; }
};

constexpr TiffLayout big_tiff{.directory_at = 8, .number_bytes = 8, .entries_bytes = 8};

// TIFF: the first directory, the lists that it points to, and the strips or tiles that these point to.
FileExtent tiff_extent(const FileBytes& file) {
    FileExtent extent{.present = file.size()};
    const auto head = file.at<2>(0);
    const TiffNumbers numbers(file, head && (*head)[0] == 'M');
    constexpr std::uint64_t big_version = 43;
    const TiffLayout layout = numbers.at(2, 2) == big_version ? big_tiff : TiffLayout{};
    const auto directory = numbers.at(layout.directory_at, layout.number_bytes);
    if (!directory || *directory > unlimited) return extent;
    const auto entries = numbers.at(*directory, layout.entries_bytes);
    const std::uint64_t first = *directory + layout.entries_bytes;
    const std::uint64_t count = std::min(entries.value_or(1), std::uint64_t{max_boxes});
    extent.declared = first + count * layout.entry_bytes();
    TiffList starts;
    TiffList lengths;
    for (std::uint64_t i = 0; entries && i < count; ++i) {
        const std::uint64_t entry = first + i * layout.entry_bytes();
        const std::uint64_t value_at = entry + 4 + layout.number_bytes;
        const auto value = numbers.at(value_at, layout.number_bytes);
        if (!value) return extent;
        constexpr std::array<std::uint8_t, 17> type_bytes{0, 1, 1, 2, 4, 8, 0, 0, 0,
                                                          0, 0, 0, 0, 0, 0, 0, 8};  // other types are ignored
        const std::uint64_t type = numbers.at(entry + 2, 2).value_or(0);
        TiffList list{.at = std::min(*value, unlimited),
                      .count =
                          std::min(numbers.at(entry + 4, layout.number_bytes).value_or(0), unlimited >> 4),
                      .bytes = type < type_bytes.size() ? type_bytes[type] : std::uint64_t{0}};
        if (list.count * list.bytes <= layout.number_bytes)
            list.at = value_at;  // the value is in the entry itself
        extent.declared = std::max(extent.declared, list.at + list.count * list.bytes);
        const std::uint64_t tag = numbers.at(entry, 2).value_or(0);
        if (tag == 273 || tag == 324) starts = list;  // StripOffsets, TileOffsets
        if (tag == 279 || tag == 325) lengths = list;
    }
    extent.declared = std::max(extent.declared, pieces_end(numbers, starts, lengths));
    return extent;
}

std::string share(std::uint64_t part, std::uint64_t whole) {
    const auto percent = static_cast<int>(100.0 * static_cast<double>(part) / static_cast<double>(whole));
    return percent == 0 ? "less than 1 %" : fmt::format("{} %", percent);
}

FileExtent extent_of(const FileBytes& file, MediaFormat format) {
    switch (still_format(format)) {
    case MediaFormat::mp4:
        return iso_extent(file, "moov");
    case MediaFormat::heif:
        return iso_extent(file, "meta");
    case MediaFormat::avi:
    case MediaFormat::webp:
        return riff_extent(file);
    case MediaFormat::matroska:
        return matroska_extent(file);
    case MediaFormat::png:
        return png_extent(file);
    case MediaFormat::tiff:
        return tiff_extent(file);
    case MediaFormat::gif:
        return {.present = file.size(), .declared = gif_end(file)};
    default:
        return {.present = file.size()};
    }
}

}  // namespace

FileExtent file_extent(const std::string& path, MediaFormat format) {
    return extent_of(FileBytes(path), format);
}

void require_complete(const std::string& path, MediaFormat format) {
    const FileBytes file(path);
    const FileExtent extent = extent_of(file, format);
    if (const auto written = file.written(); written + trailing_zeros < file.size())
        throw MediaError(
            MediaState::waiting,
            fmt::format("the copy is not complete: {} of it is written so far", share(written, file.size())));
    if (extent.declared > extent.present + slack)
        throw MediaError(MediaState::waiting, fmt::format("the copy is not complete: {} of it is here",
                                                          share(extent.present, extent.declared)));
    if (!extent.has_index && format == MediaFormat::mp4)
        throw MediaError(MediaState::waiting, "the copy is not complete: the film's index is missing so far");
}

}  // namespace vitrine
