#include "player/layout/cells/far_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double reach = 0.5;      // canvas px: parts that are so near touch one another
constexpr double min_touch = 1;    // canvas px of a border
constexpr int rounds = 2;          // a neighbour may get its border with a part from another one
constexpr double min_area = 0.01;  // canvas px^2; a smaller part is an error of rounding

/// True if another area borders on a part. @param grown_part  the part, grown by `reach`
bool touches(const Loops& grown_part, const Loops& other) {
    return area_of(intersection_of(grown_part, other)) >= min_touch * reach;
}

bool has_hole(const Loops& loops) {
    return std::ranges::any_of(loops, [](const Loop& loop) { return twice_area(loop) < 0; });
}

/// Adds a part to a cell, as one piece unless that would enclose a hole: to cut it open might cut a region.
void add_part(Loops& shown, const Loops& part) {
    Loops whole = union_of(shown, part);
    if (has_hole(whole))
        shown.insert(shown.end(), part.begin(), part.end());
    else
        shown = std::move(whole);
}

/// Takes the loops that have nothing of a region out of a cell.
std::vector<Loop> taken_far_parts(Loops& shown, const Polygon& region) {
    const Loops own{to_grid(region)};
    std::vector<Loop> far;
    const auto is_far = [&](const Loop& loop) { return area_of(intersection_of({loop}, own)) < min_area; };
    const auto begin =
        std::stable_partition(shown.begin(), shown.end(), [&](const Loop& l) { return !is_far(l); });
    if (begin == shown.begin()) return far;  // the region lies beyond the canvas
    far.assign(std::make_move_iterator(begin), std::make_move_iterator(shown.end()));
    shown.erase(begin, shown.end());
    return far;
}

/// Gives a part to the neighbours. The one with the nearest region comes first: in a motion distances change
/// little from frame to frame, while the lengths of borders jump. @return what is left
Loops given_away(Loops part, std::vector<Loops>& shown, const ItemAreas& items) {
    const Vec2 middle = centroid(from_grid(part.front()));
    const Loops grown_part = grown(part, reach);
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t j = 0; j < shown.size(); ++j)
        others.emplace_back(distance_to(items.regions[j], middle), j);
    std::ranges::sort(others);
    for (const auto& [distance, j] : others) {
        if (!touches(grown_part, shown[j])) continue;
        Loops given = intersection_of(part, items.cores[j]);
        if (area_of(given) < min_area || !touches(grown(given, reach), shown[j])) continue;
        part = difference_of(part, items.cores[j]);
        add_part(shown[j], given);
        if (area_of(part) < min_area) return {};
    }
    return part;
}

}  // namespace

void give_far_parts(std::vector<Loops>& shown, const ItemAreas& items) {
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < shown.size(); ++i) {
            if (shown[i].size() < 2 || has_hole(shown[i])) continue;
            for (Loop& far : taken_far_parts(shown[i], items.regions[i])) {
                const Loops rest = given_away({std::move(far)}, shown, items);
                shown[i].insert(shown[i].end(), rest.begin(), rest.end());
            }
        }
}

}  // namespace vitrine::player
