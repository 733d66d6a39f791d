#include "base/media/completeness.hpp"

#include "base/catalogue/media_error.hpp"
#include "base/system/unique_fd.hpp"
#include "base/system/written_size.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <limits>
#include <system_error>

namespace vitrine {

namespace {

constexpr int max_boxes = 100'000;                // walked at the top level of one file
constexpr std::uint64_t slack = 8;                // bytes that sloppy writers promise too much
constexpr std::uint64_t trailing_zeros = 65'536;  // bytes: padding that a sparse copy may leave out
constexpr std::uint64_t unlimited = std::uint64_t{1}
                                    << 62;  // larger sizes are nonsense: kept from overflowing

class Bytes {
  public:
    explicit Bytes(const std::string& path) : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
        struct stat status {};

        if (!fd_.is_open() || ::fstat(fd_.get(), &status) != 0)
            throw MediaError(MediaState::failed, fmt::format("the file cannot be opened: {}",
                                                             std::generic_category().message(errno)));
        size_ = static_cast<std::uint64_t>(status.st_size);
    }

    std::uint64_t size() const { return size_; }

    std::uint64_t written() const { return written_size(fd_.get()); }

    template <std::size_t N> std::optional<std::array<std::uint8_t, N>> at(std::uint64_t offset) const {
        std::array<std::uint8_t, N> bytes{};
        const ssize_t got = ::pread(fd_.get(), bytes.data(), N, static_cast<off_t>(offset));
        if (got != static_cast<ssize_t>(N)) return std::nullopt;
        return bytes;
    }

  private:
    UniqueFd fd_;
    std::uint64_t size_ = 0;
};

template <std::size_t N>
std::uint64_t big_endian(const std::array<std::uint8_t, N>& bytes, std::size_t from, int count) {
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i)
        value = value << 8 | bytes[from + static_cast<std::size_t>(i)];
    return value;
}

template <std::size_t N>
bool is_name(const std::array<std::uint8_t, N>& bytes, std::size_t from, const char* name) {
    return std::memcmp(bytes.data() + from, name, 4) == 0;
}

// ISO base media: boxes of size and type follow each other to the end of the file.
FileExtent iso_extent(const Bytes& file, const char* index) {
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
        if (!named || size < 8) return extent;  // "to the end", or no box any more
        extent.declared = offset + std::min(size, unlimited);
        if (extent.declared >= file.size()) return extent;
        offset = extent.declared;
    }
    return extent;
}

// RIFF: one or, in long AVI files, several chunks with a size.
FileExtent riff_extent(const Bytes& file) {
    FileExtent extent{.present = file.size()};
    std::uint64_t offset = 0;
    for (int chunk = 0; chunk < max_boxes; ++chunk) {
        const auto head = file.at<8>(offset);
        if (!head || !is_name(*head, 0, "RIFF")) return extent;
        std::uint64_t size = 0;
        for (std::size_t i = 8; i > 4; --i)
            size = size << 8 | (*head)[i - 1];
        if (size == 0 || size == std::numeric_limits<std::uint32_t>::max())
            return extent;  // written while recording
        extent.declared = offset + 8 + size;
        offset = extent.declared + (size & 1);
    }
    return extent;
}

// Matroska: the EBML header, then a segment that says its size, or that it does not know it.
FileExtent matroska_extent(const Bytes& file) {
    FileExtent extent{.present = file.size()};
    constexpr std::uint64_t segment = 0x18538067;
    std::uint64_t offset = 0;
    for (int element = 0; element < 16; ++element) {
        const auto head = file.at<12>(offset);
        if (!head) return extent;
        const int id_bytes = std::countl_zero((*head)[0]) + 1;
        if (id_bytes > 4) return extent;
        const std::uint8_t first = (*head)[static_cast<std::size_t>(id_bytes)];
        const int size_bytes = std::countl_zero(first) + 1;
        if (size_bytes > 8) return extent;
        const std::uint64_t mask = (std::uint64_t{1} << (7 * size_bytes)) - 1;
        const std::uint64_t size = big_endian(*head, static_cast<std::size_t>(id_bytes), size_bytes) & mask;
        if (size == mask) return extent;  // unknown: a live recording
        offset += static_cast<std::uint64_t>(id_bytes + size_bytes) + std::min(size, unlimited);
        if (big_endian(*head, 0, id_bytes) == segment) {
            extent.declared = offset;
            return extent;
        }
    }
    return extent;
}

// PNG: chunks up to IEND; what follows it does not matter.
FileExtent png_extent(const Bytes& file) {
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
        if (is_name(*head, 4, "IEND") || extent.declared > file.size()) return extent;
        offset = extent.declared;
    }
    return extent;
}

// The numbers of a TIFF file, which says by its first letter in which order their bytes stand.
class TiffNumbers {
  public:
    TiffNumbers(const Bytes& file, bool big) : file_(file), big_(big) {}

    /// Nothing where it lies beyond the end. @param count  bytes, up to 8
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
    const Bytes& file_;  // outlives this
    bool big_;
};

// Where the pieces of a picture end: `starts` and `lengths` are the positions of two lists of 32-bit numbers
// (or short ones) in the file.
struct TiffList {
    std::uint64_t at = 0;
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;  // a number
};

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

// Where a directory has what: TIFF counts with 4 bytes, BigTIFF, for files beyond 4 GiB, with 8.
struct TiffLayout {
    std::uint64_t directory_at = 4;  // where its position stands
    std::uint64_t number_bytes = 4;  // of positions and counts
    std::uint64_t entries_bytes = 2;

    std::uint64_t entry_bytes() const { return 4 + 2 * number_bytes; }
};

constexpr TiffLayout big_tiff{.directory_at = 8, .number_bytes = 8, .entries_bytes = 8};

// TIFF: the first directory, the lists it points to, and the strips or tiles that these point to.
FileExtent tiff_extent(const Bytes& file) {
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
                                                          0, 0, 0, 0, 0, 0, 0, 8};  // others: not looked at
        const std::uint64_t type = numbers.at(entry + 2, 2).value_or(0);
        TiffList list{.at = std::min(*value, unlimited),
                      .count =
                          std::min(numbers.at(entry + 4, layout.number_bytes).value_or(0), unlimited >> 4),
                      .bytes = type < type_bytes.size() ? type_bytes[type] : std::uint64_t{0}};
        if (list.count * list.bytes <= layout.number_bytes)
            list.at = value_at;  // it stands in the entry itself
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

FileExtent extent_of(const Bytes& file, MediaFormat format) {
    switch (format) {
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
    default:
        return {.present = file.size()};
    }
}

}  // namespace

FileExtent file_extent(const std::string& path, MediaFormat format) {
    return extent_of(Bytes(path), format);
}

void require_complete(const std::string& path, MediaFormat format) {
    const Bytes file(path);
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
