#include "base/media/gif_extent.hpp"

#include <algorithm>
#include <limits>

namespace vitrine {

namespace {

constexpr int max_parts = 4'000'000;  // parts of 255 bytes: a gigabyte

/// The size in bytes of the colour table that a byte of flags announces.
std::uint64_t table_bytes(std::uint8_t flags) {
    return (flags & 0x80) != 0 ? std::uint64_t{3} << ((flags & 7) + 1) : 0;
}

/// The byte after a chain of parts, each with its length before it; an empty part ends the chain.
/// @return  beyond the file's end if the empty part is missing
std::uint64_t behind_parts(const FileBytes& file, std::uint64_t offset) {
    constexpr std::uint64_t missing = 256;
    for (int part = 0; part < max_parts; ++part) {
        const auto length = file.at<1>(offset);
        if (!length) return std::max(offset, file.size()) + missing;
        offset += 1 + (*length)[0];
        if ((*length)[0] == 0) return offset;
    }
    return offset;
}

struct GifWalk {
    int pictures = 0;
    std::uint64_t end = 0;  // the byte after the last block that was walked over; 0: the file is no GIF there
};

/// Walks over a GIF's blocks. @param most  pictures at which the walk ends
GifWalk walked(const FileBytes& file, int most) {
    constexpr std::uint8_t extension = 0x21, picture = 0x2c, end = 0x3b;
    int pictures = 0;
    const auto head = file.at<13>(0);
    if (!head) return {.pictures = 0, .end = 13};
    std::uint64_t offset = 13 + table_bytes((*head)[10]);
    for (int block = 0; block < max_parts; ++block) {
        const auto kind = file.at<1>(offset);
        if (!kind) return {pictures, offset};  // no end mark: some writers leave it out
        if ((*kind)[0] == end) return {pictures, offset + 1};
        if ((*kind)[0] == extension) {
            offset = behind_parts(file, offset + 2);
        } else if ((*kind)[0] == picture) {
            if (++pictures >= most) return {pictures, offset};
            const auto flags = file.at<1>(offset + 9);
            offset = behind_parts(file, offset + 11 + (flags ? table_bytes((*flags)[0]) : 0));
        } else {
            return {pictures, 0};
        }
    }
    return {pictures, 0};
}

}  // namespace

int gif_pictures(const FileBytes& file, int most) {
    return walked(file, most).pictures;
}

std::uint64_t gif_end(const FileBytes& file) {
    return walked(file, std::numeric_limits<int>::max()).end;
}

}  // namespace vitrine
