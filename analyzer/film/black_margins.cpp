#include "analyzer/film/black_margins.hpp"

#include <algorithm>
#include <cstddef>

namespace vitrine::analyzer {

namespace {

constexpr int black = 40;     // grey level: tapes have black bars of up to 35 or so
constexpr int same = 12;      // grey levels within a bar: noise of a coder
constexpr int unequal = 1;    // places by which opposite bars may differ
constexpr double part = .45;  // share of the picture's side that a bar may take

// The darkest and the brightest cell of some.
struct Reach {
    int darkest = 255;
    int brightest = 0;

    void add(std::uint8_t value) {
        darkest = std::min<int>(darkest, value);
        brightest = std::max<int>(brightest, value);
    }

    bool is_black() const { return brightest <= black && brightest - darkest <= same; }
};

// A picture's cells along one direction.
struct Lines {
    std::span<const std::uint8_t> grey;
    int count = 0;   // lines
    int length = 0;  // cells of a line
    int line_step = 0;
    int cell_step = 0;

    void add(int line, Reach& reach) const {
        for (int i = 0; i < length; ++i)
            reach.add(grey[static_cast<std::size_t>(line) * static_cast<std::size_t>(line_step) +
                           static_cast<std::size_t>(i) * static_cast<std::size_t>(cell_step)]);
    }

    // The black lines from one end on, in places.
    int margin(bool from_end) const {
        Reach reach;
        int lines = 0;
        for (; lines < count; ++lines) {
            add(from_end ? count - 1 - lines : lines, reach);
            if (!reach.is_black()) break;
        }
        return lines / 2;
    }
};

struct Pair {
    std::uint8_t first = 0;
    std::uint8_t second = 0;
};

Pair opposite(const Lines& lines) {
    const int places = lines.count / 2;
    const int first = lines.margin(false);
    if (first == 0) return {};
    if (first == places)
        return {static_cast<std::uint8_t>(places / 2), static_cast<std::uint8_t>(places - places / 2)};
    const int second = lines.margin(true);
    const bool are_bars =
        second > 0 && std::abs(first - second) <= unequal && std::max(first, second) <= part * places;
    if (!are_bars) return {};
    return {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)};
}

}  // namespace

BlackMargins black_margins(std::span<const std::uint8_t> grey, cv::Size size) {
    const Pair rows = opposite({grey, size.height, size.width, size.width, 1});
    const Pair columns = opposite({grey, size.width, size.height, 1, size.width});
    return {.left = columns.first, .top = rows.first, .right = columns.second, .bottom = rows.second};
}

cv::Rect common_part(const BlackMargins& a, const BlackMargins& b, cv::Size size) {
    const int left = std::min(a.left, b.left);
    const int top = std::min(a.top, b.top);
    const cv::Rect inner(left, top, size.width - left - std::min(a.right, b.right),
                         size.height - top - std::min(a.bottom, b.bottom));
    return inner.empty() ? cv::Rect({0, 0}, size) : inner;
}

}  // namespace vitrine::analyzer
