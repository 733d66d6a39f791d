#include "player/scene/tapestry/tapestry_view.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr int halvings = 60;  // bisection steps from a film's length to less than a nanosecond

/// The levels on both sides of a fractional level, and the position between them.
struct Between {
    std::size_t coarse = 0;
    std::size_t fine = 0;
    double share = 0;
};

Between between(double level, std::size_t levels) {
    const double last = static_cast<double>(levels - 1);
    const double within = std::clamp(level, 0.0, last);
    const auto coarse = static_cast<std::size_t>(within);
    return {coarse, std::min(coarse + 1, levels - 1), within - static_cast<double>(coarse)};
}

/// The level at which a film is so wide, canvas px. Bisects: finer levels are wider.
double level_of_width(const TapestryPlace& place, double wanted) {
    constexpr int level_halvings = 30;
    double low = 0;
    double high = place.max_level();
    if (wanted <= place.width(low)) return low;
    if (wanted >= place.width(high)) return high;
    for (int k = 0; k < level_halvings; ++k) {
        const double middle = (low + high) / 2;
        (place.width(middle) <= wanted ? low : high) = middle;
    }
    return low;
}

/// True if the view lies between this level and a neighbouring one, and zoom fields connect the two.
bool is_zooming(const Tapestry& tapestry, const TapestryView& view, std::size_t level) {
    const Between at = between(view.level, tapestry.levels.size());
    return at.share > 0 && (level == at.coarse || level == at.fine) && tapestry.levels[at.fine].has_zoom;
}

}  // namespace

double TapestryPlace::strip_x(double level, nanoseconds time) const {
    const Between at = between(level, tapestry_.levels.size());
    const double coarse = tapestry_.x_at(at.coarse, time);
    if (at.share == 0) return coarse;
    return coarse + at.share * (tapestry_.x_at(at.fine, time) - coarse);
}

/// Bisects: at every level, x grows with time.
nanoseconds TapestryPlace::time_of(double level, double x) const {
    const Between at = between(level, tapestry_.levels.size());
    if (at.share == 0) return tapestry_.time_at(at.coarse, x);
    nanoseconds low{0};
    nanoseconds high = tapestry_.duration;
    for (int k = 0; k < halvings && high - low > nanoseconds(1); ++k) {
        const nanoseconds middle = low + (high - low) / 2;
        (strip_x(level, middle) <= x ? low : high) = middle;
    }
    return low;
}

Placement TapestryPlace::zoom_placement(const TapestryView& view, const ZoomMesh& mesh) const {
    const Between at = between(view.level, tapestry_.levels.size());
    const double origin = mesh.coarse_origin + at.share * (mesh.fine_origin - mesh.coarse_origin);
    return {
        .scale = scale(),
        .offset = {screen_.centre().x + scale() * (origin - strip_x(view.level, view.centre)), box_.min.y}};
}

double TapestryPlace::width(double level) const {
    return scale() * strip_x(level, tapestry_.duration);
}

double TapestryPlace::canvas_x(const TapestryView& view, nanoseconds time) const {
    return screen_.centre().x + scale() * (strip_x(view.level, time) - strip_x(view.level, view.centre));
}

nanoseconds TapestryPlace::time_at(const TapestryView& view, double canvas_x) const {
    return time_of(view.level, strip_x(view.level, view.centre) + (canvas_x - screen_.centre().x) / scale());
}

TapestryView TapestryPlace::bounded(TapestryView view) const {
    view.level = std::clamp(view.level, 0.0, max_level());
    const double whole = strip_x(view.level, tapestry_.duration);
    const double before = (screen_.centre().x - box_.min.x) / scale();  // room of the strip
    const double after = (box_.max.x - screen_.centre().x) / scale();
    const double half = std::min(whole, screen_.width() / scale()) / 2;
    const bool fills = whole >= before + after;
    const double least = fills ? before : std::max(half, whole - after);
    const double most = fills ? whole - after : std::min(whole - half, before);
    const double x = strip_x(view.level, view.centre);
    const double within = std::clamp(x, least, std::max(least, most));
    if (within != x) view.centre = time_of(view.level, within);
    return view;
}

TapestryView TapestryPlace::moved(const TapestryView& view, double by) const {
    const double x = strip_x(view.level, view.centre) - by / scale();
    const double whole = strip_x(view.level, tapestry_.duration);
    return bounded({.centre = time_of(view.level, std::clamp(x, 0.0, whole)), .level = view.level});
}

TapestryView TapestryPlace::zoomed(const TapestryView& view, double level, double canvas_x) const {
    const nanoseconds kept = time_at(view, canvas_x);
    TapestryView next{.centre = view.centre, .level = std::clamp(level, 0.0, max_level())};
    next.centre = time_of(next.level, strip_x(next.level, kept) - (canvas_x - screen_.centre().x) / scale());
    return bounded(next);
}

double TapestryPlace::levels_for(double level, double factor) const {
    const Between at = between(level, tapestry_.levels.size());
    const std::size_t other = at.coarse == at.fine && at.coarse > 0 ? at.coarse - 1 : at.coarse;
    const double ratio = static_cast<double>(tapestry_.levels[at.fine].width) /
                         static_cast<double>(tapestry_.levels[other].width);
    return ratio > 1 ? std::log(factor) / std::log(ratio) : 0;
}

/// Cuts a tile at the keyframes of the next level: between two of them, the tile's way to that level is
/// linear.
std::vector<TilePiece> TapestryPlace::pieces(const TapestryView& view, std::size_t level, double left,
                                             double right) const {
    std::vector<TilePiece> pieces;
    const Between at = between(view.level, tapestry_.levels.size());
    const bool is_still = at.share == 0 && level == at.coarse;
    const std::size_t bent = std::max(level, at.fine);
    const auto& bends = tapestry_.levels[bent].keyframes;
    for (const auto& [id, middle] : tiles(view, level, left, right)) {
        const TileId tile = id;
        const double first = static_cast<double>(tile.tile) * tapestry_.tile_width;
        const double last = std::min<double>(first + tapestry_.tile_width, tapestry_.levels[level].width);
        const auto add = [&](double from, double to) {
            const double a = canvas_x(view, tapestry_.time_at(level, from));
            const double b = canvas_x(view, tapestry_.time_at(level, to));
            if (to > from && b > left && a < right)
                pieces.push_back(
                    {tile, (from - first) / (last - first), (to - first) / (last - first), a, b});
        };
        double from = first;
        if (!is_still) {
            const auto begin = std::ranges::upper_bound(bends, tapestry_.time_at(level, first));
            for (auto bend = begin; bend != bends.end(); ++bend) {
                const auto number = static_cast<std::size_t>(bend - bends.begin());
                const double x = tapestry_.x_at(level, tapestry_.keyframe_time(bent, number));
                if (x >= last) break;
                add(from, x);
                from = x;
            }
        }
        add(from, last);
    }
    return pieces;
}

/// Bricks stand half a brick apart, even numbers in the upper row and odd ones in the lower. A half brick at
/// an end shows its neighbour in the row. A single keyframe stands in both rows.
StripPicture TapestryPlace::picture_at(const TapestryView& view, Vec2 point) const {
    const auto level = static_cast<std::size_t>(std::lround(view.level));
    const int count = static_cast<int>(tapestry_.levels[level].keyframes.size());
    const int row = point.y < (box_.min.y + box_.max.y) / 2 ? 0 : 1;
    const double width = tapestry_.brick_width;
    const double x = tapestry_.x_at(level, time_at(view, point.x)) - row * width / 2;
    const int last = count - 1 - (count - 1 - row) % 2;  // the last one of the row
    const int nearest = 2 * static_cast<int>(std::floor(x / width)) + row;
    const int keyframe = count == 1 ? 0 : std::clamp(nearest, row, last);
    return {.time = tapestry_.keyframe_time(level, static_cast<std::size_t>(keyframe)), .is_lower = row == 1};
}

Box TapestryPlace::brick(const TapestryView& view, const StripPicture& picture, Vec2 shape) const {
    const double width = std::min(brick_width(), box_.height() * shape.x / shape.y);
    const double height = width * shape.y / shape.x;
    const double top = picture.is_lower ? box_.max.y - height : box_.min.y;
    double middle = canvas_x(view, picture.time);
    const auto level = static_cast<std::size_t>(std::lround(view.level));
    if (tapestry_.levels[level].keyframes.size() == 1)  // it stands twice, on both sides of the middle
        middle += (picture.is_lower ? 1 : -1) * brick_width() / 4;
    return {{middle - width / 2, top}, {middle + width / 2, top + height}};
}

std::vector<std::pair<TileId, double>> TapestryPlace::tiles(const TapestryView& view, std::size_t level,
                                                            double left, double right) const {
    std::vector<std::pair<TileId, double>> tiles;
    const int count = tapestry_.tiles(level);
    const bool is_zoom = is_zooming(tapestry_, view, level);
    const bool is_coarse = static_cast<double>(level) < view.level;
    const double more = is_zoom && is_coarse ? tapestry_.brick_width : 0;  // px of the strip
    const double reach = is_zoom && !is_coarse ? brick_width() : 0;        // canvas px
    const auto tile_at = [&](double x, double by) {
        const double strip = tapestry_.x_at(level, time_at(view, x)) + by;
        return std::clamp(static_cast<int>(strip / tapestry_.tile_width), 0, count - 1);
    };
    for (int tile = tile_at(left - reach, -more); tile <= tile_at(right + reach, more); ++tile) {
        const double middle = (tile + 0.5) * tapestry_.tile_width;
        const double x = canvas_x(view, tapestry_.time_at(level, middle));
        tiles.push_back({{level, tile}, x});
    }
    return tiles;
}

TapestryRoom tapestry_room(const Canvas& canvas, Vec2 at) {
    if (canvas.bands.empty()) return Vec2(canvas);
    return {canvas, output_at(canvas, at)};
}

TapestryView view_like(const TapestryPlace& to, const TapestryPlace& from, const TapestryView& view) {
    const double level = level_of_width(to, from.width(view.level));
    const bool is_whole = view.level == std::round(view.level);
    return to.bounded({.centre = view.centre, .level = is_whole ? std::round(level) : level});
}

TapestryView view_of_width(const TapestryPlace& place, const TapestryView& view, double width) {
    constexpr double same_width = 1e-3;  // px; another processor rounds otherwise
    const bool is_same =
        view.level <= place.max_level() && std::abs(place.width(view.level) - width) < same_width;
    return is_same ? view : place.bounded({.centre = view.centre, .level = level_of_width(place, width)});
}

}  // namespace vitrine::player
