#include "analyzer/film/block_motion.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

// Searches every block at half the size over the whole reach first: all blocks at one shift together, which a
// compiler turns into vector code. Then it searches around the place found, at full size.

namespace vitrine::analyzer {

namespace {

constexpr int width = static_cast<int>(FrameFeatures::detail_width);
constexpr int height = static_cast<int>(FrameFeatures::detail_height);
constexpr int block_width = 8;
constexpr int block_height = 6;
constexpr int columns = width / block_width;
constexpr int rows = height / block_height;
constexpr double min_block_contrast = 25;  // grey levels squared: less is only noise
constexpr int noise = 40;                  // grey levels squared: blocks that differ by less are the same

constexpr int half_width = width / 2;
constexpr int half_height = height / 2;
constexpr int reach_x = 4;  // px at half the size: an eighth of the width
constexpr int reach_y = 3;
constexpr int padded_width = half_width + 2 * reach_x;
constexpr int padded_height = half_height + 2 * reach_y;

using Detail = std::array<std::uint8_t, static_cast<std::size_t>(width) * height>;
using Half = std::array<std::int16_t, static_cast<std::size_t>(half_width) * half_height>;
using Padded = std::array<std::int16_t, static_cast<std::size_t>(padded_width) * padded_height>;

struct Match {
    int difference = std::numeric_limits<int>::max();
    int x = 0;
    int y = 0;
};

using Matches = std::array<Match, static_cast<std::size_t>(columns) * rows>;

Half halved(const Detail& detail) {
    Half half{};
    for (int y = 0; y < half_height; ++y) {
        const std::uint8_t* above = detail.data() + static_cast<std::ptrdiff_t>(2) * y * width;
        const std::uint8_t* below = above + width;
        std::int16_t* out = half.data() + static_cast<std::ptrdiff_t>(y) * half_width;
        for (int x = 0; x < half_width; ++x, above += 2, below += 2)
            out[x] = static_cast<std::int16_t>((above[0] + above[1] + below[0] + below[1] + 2) / 4);
    }
    return half;
}

// Adds a margin that repeats the border.
Padded padded(const Half& half) {
    Padded out{};
    for (int y = 0; y < padded_height; ++y) {
        const std::int16_t* in =
            half.data() +
            static_cast<std::ptrdiff_t>(std::clamp(y - reach_y, 0, half_height - 1)) * half_width;
        std::int16_t* row = out.data() + static_cast<std::ptrdiff_t>(y) * padded_width;
        std::copy_n(in, half_width, row + reach_x);
        std::fill_n(row, reach_x, in[0]);
        std::fill_n(row + reach_x + half_width, reach_x, in[half_width - 1]);
    }
    return out;
}

// Compares all blocks at one shift.
void compare(const Padded& before, const Half& after, int shift_x, int shift_y, Matches& matches) {
    auto match = matches.begin();
    for (int top = 0; top < half_height; top += block_height / 2) {
        std::array<int, half_width> sums{};
        for (int y = top; y < top + block_height / 2; ++y) {
            const std::int16_t* from = before.data() +
                                       static_cast<std::ptrdiff_t>(y + reach_y + shift_y) * padded_width +
                                       reach_x + shift_x;
            const std::int16_t* to = after.data() + static_cast<std::ptrdiff_t>(y) * half_width;
            for (int x = 0; x < half_width; ++x)
                sums[static_cast<std::size_t>(x)] += (from[x] - to[x]) * (from[x] - to[x]);
        }
        for (std::size_t x = 0; x < sums.size(); x += block_width / 2, ++match) {
            const int difference = sums[x] + sums[x + 1] + sums[x + 2] + sums[x + 3];
            if (difference < match->difference) *match = {difference, shift_x, shift_y};
        }
    }
}

Matches coarse_matches(const Detail& before, const Detail& after) {
    const Padded from = padded(halved(before));
    const Half to = halved(after);
    Matches matches;
    compare(from, to, 0, 0, matches);
    for (int y = -reach_y; y <= reach_y; ++y)
        for (int x = -reach_x; x <= reach_x; ++x)
            compare(from, to, x, y, matches);
    return matches;
}

int block_difference(const std::uint8_t* a, const std::uint8_t* b) {
    int sum = 0;
    for (int row = 0; row < block_height; ++row, a += width, b += width)
        for (int x = 0; x < block_width; ++x)
            sum += (int{a[x]} - int{b[x]}) * (int{a[x]} - int{b[x]});
    return sum;
}

// The smallest difference of a block around twice its coarse shift.
int smallest_difference(const Detail& before, const Detail& after, int left, int top, const Match& match) {
    const std::uint8_t* block = after.data() + static_cast<std::ptrdiff_t>(top) * width + left;
    const int middle_x = std::clamp(left + 2 * match.x, 0, width - block_width);
    const int middle_y = std::clamp(top + 2 * match.y, 0, height - block_height);
    int smallest = std::numeric_limits<int>::max();
    for (int y = std::max(0, middle_y - 1); y <= std::min(height - block_height, middle_y + 1); ++y)
        for (int x = std::max(0, middle_x - 1); x <= std::min(width - block_width, middle_x + 1); ++x)
            smallest =
                std::min(smallest,
                         block_difference(before.data() + static_cast<std::ptrdiff_t>(y) * width + x, block));
    return smallest;
}

// The part of the pictures that is compared, in px of the detail.
cv::Rect compared_part(const FrameFeatures& before, const FrameFeatures& after) {
    const cv::Rect part = common_part(before, after);
    return {2 * part.x, 2 * part.y, 2 * part.width, 2 * part.height};
}

struct Tone {
    double mean = 0;
    double variance = 0;
};

Tone tone(const FrameFeatures& features, const cv::Rect& part) {
    if (part.area() == width * height)
        return {.mean = features.mean, .variance = features.deviation * features.deviation};
    std::uint32_t sum = 0;
    std::uint32_t squares = 0;
    for (int y = part.y; y < part.br().y; ++y) {
        const std::uint8_t* row = features.detail.data() + static_cast<std::ptrdiff_t>(y) * width;
        for (int x = part.x; x < part.br().x; ++x) {
            sum += row[x];
            squares += std::uint32_t{row[x]} * row[x];
        }
    }
    const double mean = static_cast<double>(sum) / part.area();
    return {.mean = mean,
            .variance = std::max(0.0, static_cast<double>(squares) / part.area() - mean * mean)};
}

// The mean square of the difference of two unrelated pictures of such tones.
double unrelated(const FrameFeatures& before, const FrameFeatures& after, const cv::Rect& part) {
    const Tone a = tone(before, part);
    const Tone b = tone(after, part);
    return std::max(a.variance + b.variance + (b.mean - a.mean) * (b.mean - a.mean), min_block_contrast);
}

// Says if a block tells something: it is not black, and in a picture without bars not in the outermost rows,
// as bars may move in there.
bool is_inner(int x, int y, const cv::Rect& part) {
    const cv::Rect block(x, y, block_width, block_height);
    if (2 * (block & part).area() < block.area()) return false;
    return part.height < height || (y > 0 && y < height - block_height);
}

}  // namespace

Unexplained unexplained(const FrameFeatures& before, const FrameFeatures& after) {
    const Matches matches = coarse_matches(before.detail, after.detail);
    const cv::Rect part = compared_part(before, after);
    double left = 0;
    double still = 0;
    int changed = 0;
    int inner = 0;
    auto match = matches.begin();
    for (int y = 0; y < height; y += block_height) {
        for (int x = 0; x < width; x += block_width, ++match) {
            const int difference = smallest_difference(before.detail, after.detail, x, y, *match);
            left += difference;
            const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(y) * width + x;
            still += block_difference(before.detail.data() + place, after.detail.data() + place);
            if (!is_inner(x, y, part)) continue;
            ++inner;
            if (difference > noise * block_width * block_height) ++changed;
        }
    }
    const double whole = part.area() * unrelated(before, after, part);
    return {.share = left / whole,
            .area = static_cast<double>(changed) / std::max(1, inner),
            .still = still / whole};
}

}  // namespace vitrine::analyzer
