#include "analyzer/words/steady_lines.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {
namespace {

constexpr double same_line = 0.5;  // intersection over union of one line in two searches

bool has_line(const LineSearch& search, const Box& line) {
    return std::ranges::any_of(search.lines,
                               [&](const Box& other) { return overlap(line, other) >= same_line; });
}

/// Says if a search next to this one has found the line again.
/// @param drift  that the line goes along with, per second
bool is_seen_again(std::span<const LineSearch> searches, std::size_t at, const Box& line, Vec2 drift) {
    const auto in = [&](std::size_t other) {
        const double passed = searches[other].time - searches[at].time;
        return has_line(searches[other], moved(line, drift * passed));
    };
    return (at > 0 && in(at - 1)) || (at + 1 < searches.size() && in(at + 1));
}

}  // namespace

std::vector<Box> steady_lines(std::span<const LineSearch> searches, Vec2 drift) {
    std::vector<Box> steady;
    for (std::size_t i = 0; i < searches.size(); ++i)
        for (const Box& line : searches[i].lines)
            if (searches.size() == 1 || is_seen_again(searches, i, line, {}) ||
                is_seen_again(searches, i, line, drift))
                steady.push_back(moved(line, drift * -searches[i].time));
    return steady;
}

bool has_caption(std::span<const LineSearch> searches, Vec2 drift) {
    for (std::size_t i = 0; i + 1 < searches.size(); ++i) {
        const double way = length(drift) * (searches[i + 1].time - searches[i].time);
        for (const Box& line : searches[i].lines)
            if (2 * way > std::min(line.width(), line.height()) && has_line(searches[i + 1], line))
                return true;
    }
    return false;
}

}  // namespace vitrine::analyzer
