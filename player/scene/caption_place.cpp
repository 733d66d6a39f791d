#include "player/scene/caption_place.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr std::array letter_sizes{1.0 / 26, 1.0 / 32, min_caption_letters * 1.001};  // of the canvas' height
constexpr double margin_share = 0.006;  // of the canvas' height, around the caption
constexpr int steps_across = 24;
constexpr int steps_down = 32;

bool is_inside(std::span<const Vec2> outline, Vec2 point) {
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2 a = outline[i], b = outline[j];
        if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

/// True if a part of the line from a to b lies inside the box (Liang and Barsky).
bool crosses(const Box& box, Vec2 a, Vec2 b) {
    const Vec2 way = b - a;
    double from = 0, to = 1;
    const auto cut = [&](double step, double room) {
        if (step == 0) return room > 0;
        const double at = room / step;
        if (step < 0)
            from = std::max(from, at);
        else
            to = std::min(to, at);
        return from < to;
    };
    return cut(-way.x, a.x - box.min.x) && cut(way.x, box.max.x - a.x) && cut(-way.y, a.y - box.min.y) &&
           cut(way.y, box.max.y - a.y);
}

/// True if the box lies inside the outline.
bool contains(std::span<const Vec2> outline, const Box& box) {
    if (!is_inside(outline, box.centre())) return false;
    for (std::size_t i = 0; i < outline.size(); ++i)
        if (crosses(box, outline[i], outline[(i + 1) % outline.size()])) return false;
    return true;
}

/// The part of a cell that holds the I-Region. On another part a caption would seem to belong to a neighbour.
/// Null: the cell is empty.
const Polygon* main_part(const Cell& cell) {
    return cell.parts.empty() ? nullptr : &cell.parts.front();
}

/// A size on the canvas with a margin around it, px.
struct Room {
    Vec2 size;
    double margin = 0;
    double grid = 0;  // its corner lies on multiples of this; 0: anywhere
};

Vec2 on_grid(Vec2 at, double grid) {
    return grid > 0 ? Vec2{std::round(at.x / grid) * grid, std::round(at.y / grid) * grid} : at;
}

bool touches_any(const Box& box, std::span<const Box> others) {
    return std::ranges::any_of(others,
                               [&](const Box& other) { return !intersection(box, other).is_empty(); });
}

std::optional<Box> place_in(const Polygon& part, const CaptionRoom& room, const Room& wanted,
                            const Box& taken) {
    const auto [size, margin, grid] = wanted;
    const Box all = bounding_box(part);
    const Vec2 first = all.min + Vec2{margin, margin};
    const Vec2 way = all.max - size - Vec2{margin, margin} - first;
    if (way.x < 0 || way.y < 0) return std::nullopt;
    for (int down = steps_down; down >= 0; --down)
        for (int across = 0; across <= steps_across; ++across) {
            const Vec2 at =
                on_grid(first + Vec2{way.x * across / steps_across, way.y * down / steps_down}, grid);
            const Box wide{at - Vec2{margin, margin}, at + size + Vec2{margin, margin}};
            if (intersection(wide, taken).is_empty() && !touches_any(wide, room.avoided) &&
                contains(part, wide) && clipped(room.region, wide).empty())
                return Box{at, at + size};
        }
    return std::nullopt;
}

/// The I-Region of a shot wherever its photo drifts.
Polygon drifting_region(const PlacedShot& placed) {
    Polygon still = placed_region(placed.shot.item, placed.placement);
    if (placed.drift.from == placed.drift.to) return still;
    Polygon all;
    for (const Vec2 by : {placed.drift.from, placed.drift.to})
        for (const Vec2 corner : still)
            all.push_back(corner + by);
    return convex_hull(all);
}

/// The bezels, and the faces and lines of text of a shot wherever its photo drifts, canvas px.
std::vector<Box> avoided_by(const PlacedShot& placed, std::span<const Box> bezels) {
    std::vector<Box> avoided(bezels.begin(), bezels.end());
    const auto& [scale, offset] = placed.placement;
    for (const Box& mark : placed.shot.shot.marks) {
        const Box still{mark.min * scale + offset, mark.max * scale + offset};
        avoided.push_back(united(moved(still, placed.drift.from), moved(still, placed.drift.to)));
    }
    return avoided;
}

}  // namespace

std::vector<CaptionRoom> caption_rooms(std::span<const PlacedShot> wall, std::span<const Box> bezels) {
    std::vector<CaptionRoom> rooms;
    for (const PlacedShot& placed : wall)
        if (placed.cell)
            rooms.push_back({.source = placed.shot.source,
                             .path = placed.shot.key.path,
                             .cell = placed.cell,
                             .region = drifting_region(placed),
                             .avoided = avoided_by(placed, bezels)});
    return rooms;
}

std::vector<CaptionRoom> kept_caption_rooms(std::span<const PlacedShot> shown,
                                            std::span<const PlacedShot> incoming,
                                            std::span<const Box> bezels) {
    std::vector<CaptionRoom> rooms;
    for (const PlacedShot& after : incoming) {
        const PlacedShot* const now = find_source(shown, after.shot.source);
        if (now == nullptr || !now->cell || !after.cell || now->placement != after.placement) continue;
        Polygon region = drifting_region(*now);
        const Polygon later = drifting_region(after);
        region.insert(region.end(), later.begin(), later.end());
        rooms.push_back({.source = now->shot.source,
                         .path = now->shot.key.path,
                         .cell = now->cell,
                         .next = after.cell,
                         .region = convex_hull(region),
                         .avoided = avoided_by(after, bezels)});
    }
    return rooms;
}

bool keeps_place(const Box& caption, const CaptionRoom& room, std::span<const DrawItem> items) {
    const auto holds = [&](const Cell& cell) {
        const Polygon* const part = main_part(cell);
        return part != nullptr && contains(*part, caption);
    };
    const auto touches = [&](const Polygon& part) { return area(clipped(part, caption)) > 1; };
    const auto covers = [&](const DrawItem& item) {
        if (item.source == room.source || item.alpha <= 0) return false;
        return !item.cell || std::ranges::any_of(item.cell->parts, touches) ||
               std::ranges::any_of(item.cell->filler, touches);
    };
    return holds(*room.cell) && (!room.next || holds(*room.next)) && clipped(room.region, caption).empty() &&
           std::ranges::none_of(items, covers);
}

std::optional<CaptionPlace> caption_place(const CaptionRoom& room, std::span<const CaptionSize> forms,
                                          Vec2 canvas, const Box& taken) {
    const Polygon* const part = main_part(*room.cell);
    if (part == nullptr) return std::nullopt;
    const double margin = canvas.y * margin_share;
    for (const double letters : letter_sizes)
        for (std::size_t form = 0; form < forms.size(); ++form) {
            const double height = letters * canvas.y / forms[form].letters;
            const Vec2 size{height * forms[form].aspect, height};
            if (const auto box = place_in(*part, room, {size, margin}, taken))
                return CaptionPlace{*box, form};
        }
    return std::nullopt;
}

std::optional<Box> code_place(const CaptionRoom& room, int modules, Vec2 canvas, const Box& taken) {
    const Polygon* const part = main_part(*room.cell);
    if (part == nullptr) return std::nullopt;
    const double least = std::max(min_code_module, std::ceil(min_code_side * canvas.y / modules));
    for (double module = std::max(least, std::floor(max_code_side * canvas.y / modules)); module >= least;
         --module)
        if (const auto box = place_in(
                *part, room,
                {.size = {module * modules, module * modules}, .margin = canvas.y * margin_share, .grid = 1},
                taken))
            return box;
    return std::nullopt;
}

Box idle_code_place(int modules, Vec2 canvas) {
    const double module = std::max(min_code_module, std::floor(max_code_side * canvas.y / modules));
    const double side = module * modules;
    const double margin = std::round(canvas.y / 20);
    const Vec2 end{std::floor(canvas.x) - margin, std::floor(canvas.y) - margin};
    return {end - Vec2{side, side}, end};
}

Box idle_words_place(double aspect, Vec2 canvas) {
    constexpr double max_width = 0.6;  // share of the canvas: the QR code stands beside
    const double margin = std::round(canvas.y / 20);
    const double height = std::min(canvas.y / 14, max_width * canvas.x / aspect);
    const Vec2 begin{margin, canvas.y - margin - height};
    return {begin, begin + Vec2{height * aspect, height}};
}

}  // namespace vitrine::player
