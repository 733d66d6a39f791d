#include "player/scene/folders/folder_names.hpp"

#include "base/hints/hint_words.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int columns = 192;  // of fields of the canvas that are looked at
constexpr int rows = 108;
constexpr std::array heights{0.045, 0.04, 0.035, 0.03,
                             0.026};   // of a line, as shares of the canvas' shorter side
constexpr double letter_width = 0.55;  // mean, as a share of a line's height
constexpr double least_letters = 3;    // a shorter name has this width

/// A folder's path and slot. A folder that is repeated has several slots.
using PlacedFolder = std::pair<std::string, int>;

PlacedFolder folder_of(const PlacedShot& placed) {
    return {placed.shot.folder, placed.shot.slot};
}

/// The number of a field.
std::size_t field_at(int x, int y) {
    return static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x);
}

/// The fields of a canvas, each with the number of the shot that is seen there outside its I-Region; none:
/// -1.
std::vector<int> seen_fields(std::span<const PlacedShot> wall, Vec2 field) {
    std::vector<int> seen(std::size_t{columns} * rows, -1);
    for (std::size_t i = 0; i < wall.size(); ++i) {
        if (!wall[i].cell || wall[i].cell->parts.empty()) continue;
        const Polygon region = placed_region(wall[i].shot.item, wall[i].placement);
        for (const Polygon& part : wall[i].cell->parts) {
            const Box bounds = bounding_box(part);
            const int left = std::max(0, static_cast<int>(bounds.min.x / field.x));
            const int top = std::max(0, static_cast<int>(bounds.min.y / field.y));
            for (int y = top; y < rows && y * field.y < bounds.max.y; ++y)
                for (int x = left; x < columns && x * field.x < bounds.max.x; ++x) {
                    const Vec2 middle{(x + 0.5) * field.x, (y + 0.5) * field.y};
                    if (!is_inside_convex(region, middle) && is_at(wall[i], middle))
                        seen[field_at(x, y)] = static_cast<int>(i);
                }
        }
    }
    return seen;
}

/// For each field the number of a folder's fields above and to the left of it.
class FreeFields {
  public:
    FreeFields(std::span<const PlacedShot> wall, const PlacedFolder& folder, std::span<const int> seen)
        : sums_(std::size_t{columns + 1} * (rows + 1), 0) {
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                const int shot = seen[field_at(x, y)];
                const bool is_free = shot >= 0 && folder_of(wall[static_cast<std::size_t>(shot)]) == folder;
                at(x + 1, y + 1) = at(x, y + 1) + at(x + 1, y) - at(x, y) + (is_free ? 1 : 0);
            }
    }

    bool is_all_free(int x, int y, int wide, int high) {
        return at(x + wide, y + high) - at(x, y + high) - at(x + wide, y) + at(x, y) == wide * high;
    }

  private:
    int& at(int x, int y) {
        return sums_[static_cast<std::size_t>(y) * (columns + 1) + static_cast<std::size_t>(x)];
    }

    std::vector<int> sums_;
};

bool touches_region(const Box& box, std::span<const PlacedShot> wall) {
    return std::ranges::any_of(wall, [&](const PlacedShot& placed) {
        return std::abs(signed_area(clipped(placed_region(placed.shot.item, placed.placement), box))) > 0;
    });
}

/// The largest place for a line of text on free fields.
std::optional<Box> text_box(FreeFields& free, std::span<const PlacedShot> wall, Vec2 canvas, double aspect,
                            const Box& taken) {
    const Vec2 field{canvas.x / columns, canvas.y / rows};
    for (const double share : heights) {
        const Vec2 size = Vec2{aspect, 1} * (share * std::min(canvas.x, canvas.y));
        const int wide =
            static_cast<int>(std::ceil(size.x / field.x)) + 1;  // the middles of all fields are known
        const int high = static_cast<int>(std::ceil(size.y / field.y)) + 1;
        for (int y = rows - high; y >= 0; --y)
            for (int x = 0; x + wide <= columns; ++x) {
                if (!free.is_all_free(x, y, wide, high)) continue;
                const Vec2 corner{(x + 0.5) * field.x, (y + 0.5) * field.y};
                const Box box{corner, corner + size};
                if (intersection(box, taken).is_empty() && !touches_region(box, wall)) return box;
            }
    }
    return std::nullopt;
}

/// The width of a line of text, as a multiple of its height.
double aspect_of(const std::string& text) {
    const auto is_begin = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; };  // UTF-8
    return std::max(least_letters, static_cast<double>(std::ranges::count_if(text, is_begin))) * letter_width;
}

}  // namespace

std::vector<FrameName> folder_names(std::span<const PlacedShot> wall, Vec2 canvas, const Box& taken) {
    std::vector<FrameName> names;
    std::set<PlacedFolder> folders;
    for (const PlacedShot& placed : wall)
        if (!placed.shot.folder.empty()) folders.insert(folder_of(placed));
    if (folders.empty()) return names;
    const std::vector<int> seen = seen_fields(wall, {canvas.x / columns, canvas.y / rows});
    for (const PlacedFolder& folder : folders) {
        const std::string text = shown_folder_name(folder.first);
        if (text.empty()) continue;
        FreeFields free(wall, folder, seen);
        if (const auto box = text_box(free, wall, canvas, aspect_of(text), taken))
            names.push_back({.text = text, .box = *box});
    }
    return names;
}

}  // namespace vitrine::player
