#include "player/scene/folders/folder_zoom.hpp"

#include "player/layout/cells/cut_cell.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr int fields = 96;        // of the canvas, across and down, that are looked at
constexpr double faded_in = 0.6;  // share of the way after which only the inner wall is seen in the box

std::size_t number_at(int x, int y) {
    return static_cast<std::size_t>(y) * fields + static_cast<std::size_t>(x);
}

/// The sides of the largest square of fields that ends at each field, in fields.
std::vector<int> square_sizes(const std::vector<char>& is_inside) {
    std::vector<int> sizes(is_inside.size(), 0);
    const auto at = [&](int x, int y) -> int& { return sizes[number_at(x, y)]; };
    for (int y = 0; y < fields; ++y)
        for (int x = 0; x < fields; ++x) {
            if (!is_inside[number_at(x, y)]) continue;
            const bool is_at_edge = x == 0 || y == 0;
            at(x, y) = is_at_edge ? 1 : 1 + std::min({at(x - 1, y), at(x, y - 1), at(x - 1, y - 1)});
        }
    return sizes;
}

bool is_seen(const DrawItem& item, Vec2 canvas) {
    return !intersection(bounds_of(*item.cell), {{0, 0}, canvas}).is_empty();
}

/// The place of the outer wall's canvas: it becomes larger about one point, until the box is the canvas.
Placement outer_placement(Vec2 canvas, const Box& box, double progress) {
    const double largest = canvas.x / box.width();
    const double scale = std::pow(largest, progress);
    const Vec2 fixed = largest > 1 ? box.min * (largest / (largest - 1)) : Vec2{};
    return {scale, fixed * (1 - scale)};
}

}  // namespace

Box box_of_folder(std::span<const PlacedShot> wall, const std::string& folder, Vec2 canvas) {
    std::vector<char> is_inside(std::size_t{fields} * fields, 0);
    const Vec2 field{canvas.x / fields, canvas.y / fields};
    for (const PlacedShot& placed : wall) {
        if (placed.shot.folder != folder || !placed.cell) continue;
        for (std::size_t k = 0; k < is_inside.size(); ++k) {
            const std::size_t row = k / fields;
            const Vec2 middle{(static_cast<double>(k % fields) + 0.5) * field.x,
                              (static_cast<double>(row) + 0.5) * field.y};
            if (is_inside[k] == 0 && is_at(placed, middle)) is_inside[k] = 1;
        }
    }
    const std::vector<int> sizes = square_sizes(is_inside);
    const auto largest = std::ranges::max_element(sizes);
    if (*largest == 0) return {canvas * 0.45, canvas * 0.55};
    const auto last = static_cast<std::size_t>(largest - sizes.begin());
    const std::size_t row = last / fields;
    const Vec2 end{static_cast<double>(last % fields + 1) * field.x, static_cast<double>(row + 1) * field.y};
    return {end - field * *largest, end};
}

Frame placed_frame(const Frame& frame, const Placement& to) {
    Frame placed{.canvas = frame.canvas, .idle = frame.idle, .time = frame.time};
    for (DrawItem item : frame.items) {
        if (!item.cell) continue;
        item.cell = std::make_shared<const Cell>(scaled_cell(*item.cell, to.scale, to.offset));
        if (!is_seen(item, frame.canvas)) continue;
        item.placement = composed(item.placement, to);
        placed.items.push_back(std::move(item));
    }
    return placed;
}

Placement inner_placement(Vec2 canvas, const Box& box, double progress) {
    return composed({box.width() / canvas.x, box.min}, outer_placement(canvas, box, progress));
}

Frame zoom_frame(const Frame& outer, const Frame& inner, const Box& box, double progress) {
    if (progress <= 0) return outer;
    if (progress >= 1) return inner;
    Frame frame = placed_frame(outer, outer_placement(outer.canvas, box, progress));
    const double alpha = eased(progress / faded_in);
    for (DrawItem item : placed_frame(inner, inner_placement(outer.canvas, box, progress)).items) {
        item.alpha = std::min(item.alpha * alpha, max_blended);
        frame.items.push_back(std::move(item));
    }
    return frame;
}

}  // namespace vitrine::player
