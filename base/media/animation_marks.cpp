#include "base/media/animation_marks.hpp"

#include "base/media/file_bytes.hpp"
#include "base/media/gif_extent.hpp"

#include <algorithm>
#include <string_view>

namespace vitrine {

namespace {

constexpr int max_chunks_before_picture = 100'000;  // looked at in one file

template <std::size_t N>
bool is_named(const std::array<std::uint8_t, N>& head, std::size_t from, std::string_view name) {
    return std::equal(
        name.begin(), name.end(), head.begin() + static_cast<std::ptrdiff_t>(from),
        [](char letter, std::uint8_t byte) { return static_cast<std::uint8_t>(letter) == byte; });
}

}  // namespace

bool is_animated_gif(const FileBytes& file) {
    return gif_pictures(file, 2) >= 2;
}

bool is_animated_webp(const FileBytes& file) {
    constexpr std::uint8_t animation_flag = 0x02;
    const auto head = file.at<21>(0);  // RIFF, its size, WEBP, VP8X, its size, flags
    if (!head || !is_named(*head, 12, "VP8X") || ((*head)[20] & animation_flag) == 0) return false;
    int pictures = 0;
    std::uint64_t offset = 12;
    for (int chunk = 0; chunk < max_chunks_before_picture && pictures < 2; ++chunk) {
        const auto next = file.at<8>(offset);
        if (!next) break;
        if (is_named(*next, 0, "ANMF")) ++pictures;
        const std::uint64_t size = little_endian(*next, 4, 4);
        offset += 8 + size + (size & 1);
    }
    return pictures >= 2;
}

bool is_animated_png(const FileBytes& file) {
    std::uint64_t offset = 8;
    for (int chunk = 0; chunk < max_chunks_before_picture; ++chunk) {
        const auto head = file.at<12>(offset);
        if (!head || is_named(*head, 4, "IDAT")) return false;
        if (is_named(*head, 4, "acTL"))  // then the number of its pictures
            return ((*head)[8] | (*head)[9] | (*head)[10]) != 0 || (*head)[11] >= 2;
        offset += 12 + big_endian(*head, 0, 4);
    }
    return false;
}

}  // namespace vitrine
