#include "player/layout/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double min_band = 0.5;  // canvas px; outputs nearer to one another touch

bool is_free(const std::vector<Box>& outputs, const Box& box) {
    return std::ranges::all_of(outputs,
                               [&](const Box& output) { return intersection(output, box).is_empty(); });
}

/// The lines of all edges along an axis, in order.
std::vector<double> lines_of(const std::vector<Box>& outputs, double length, double Vec2::*axis) {
    std::vector<double> lines{0, length};
    for (const Box& output : outputs)
        for (const double line : {output.min.*axis, output.max.*axis})
            lines.push_back(std::clamp(line, 0.0, length));
    std::ranges::sort(lines);
    std::vector<double> apart;
    for (const double line : lines)
        if (apart.empty() || line - apart.back() >= min_band) apart.push_back(line);
    apart.back() = length;
    return apart;
}

/// The free boxes between two lines across that reach as far up and down as they can.
void add_between(const std::vector<Box>& outputs, double left, double right, const std::vector<double>& lines,
                 std::vector<Box>& found) {
    for (std::size_t top = 0; top + 1 < lines.size(); ++top) {
        std::size_t bottom = top;
        while (bottom + 1 < lines.size() &&
               is_free(outputs, {{left, lines[top]}, {right, lines[bottom + 1]}}))
            ++bottom;
        if (bottom == top) continue;
        found.push_back({{left, lines[top]}, {right, lines[bottom]}});
        top = bottom;
    }
}

/// True if two outputs overlap, or touch along more than a pixel of their edges.
bool do_touch(const Box& a, const Box& b) {
    constexpr Vec2 half{min_band / 2, min_band / 2};
    const Box shared = intersection({a.min - half, a.max + half}, {b.min - half, b.max + half});
    return !shared.is_empty() && std::max(shared.width(), shared.height()) > 1;
}

double distance_to_box(const Box& box, Vec2 point) {
    return length(Vec2{std::max({box.min.x - point.x, 0.0, point.x - box.max.x}),
                       std::max({box.min.y - point.y, 0.0, point.y - box.max.y})});
}

}  // namespace

double finger_on(int width, int height, Vec2 millimetres) {
    constexpr double target = 15;                       // mm
    constexpr double smallest = 100, largest = 10'000;  // mm of a panel's width
    constexpr double same_shape = 0.1;                  // share by which the pixels may be oblong
    if (millimetres.x < smallest || millimetres.x > largest || millimetres.y <= 0) return usual_finger;
    const double across = width / millimetres.x;
    const double down = height / millimetres.y;
    if (std::abs(across / down - 1) > same_shape) return usual_finger;
    return target * std::max(across, down);
}

Canvas canvas_of(Vec2 size, std::vector<Box> outputs) {
    Canvas canvas(size);
    canvas.outputs = std::move(outputs);
    if (canvas.outputs.empty()) return canvas;
    std::vector<Box> solid;  // without the slack of lines that count as one
    for (const Box& output : canvas.outputs)
        solid.push_back({output.min + Vec2{min_band, min_band}, output.max - Vec2{min_band, min_band}});
    const std::vector<double> across = lines_of(canvas.outputs, size.x, &Vec2::x);
    const std::vector<double> down = lines_of(canvas.outputs, size.y, &Vec2::y);
    std::vector<Box> all;
    for (std::size_t i = 0; i < across.size(); ++i)
        for (std::size_t j = i + 1; j < across.size(); ++j)
            add_between(solid, across[i], across[j], down, all);
    const auto is_inside = [](const Box& inner, const Box& outer) {
        return inner != outer && intersection(inner, outer) == inner;
    };
    for (const Box& box : all)
        if (std::ranges::none_of(all, [&](const Box& other) { return is_inside(box, other); }))
            canvas.bands.push_back(box);
    return canvas;
}

std::size_t count_surfaces(const Canvas& canvas) {
    std::vector<Box> apart = canvas.outputs;  // those of surfaces that are not counted yet
    std::size_t count = 0;
    for (std::vector<Box> surface; !apart.empty(); ++count) {
        surface.assign(1, apart.back());
        apart.pop_back();
        while (!surface.empty()) {
            const Box output = surface.back();
            surface.pop_back();
            const auto touching = std::stable_partition(
                apart.begin(), apart.end(), [&](const Box& other) { return !do_touch(output, other); });
            surface.insert(surface.end(), touching, apart.end());
            apart.erase(touching, apart.end());
        }
    }
    return std::max<std::size_t>(1, count);
}

Placement place_on(const Canvas& canvas, const Canvas& other) {
    if (!canvas.outputs.empty() && !other.outputs.empty())
        return {other.unit / canvas.unit, (canvas.origin - other.origin) * other.unit};
    const double scale = std::min(other.x / canvas.x, other.y / canvas.y);
    return {scale, (other - canvas * scale) * 0.5};
}

Canvas canvas_within(const Canvas& canvas, const Box& box) {
    Canvas part(box.max - box.min);
    const auto take = [&](const std::vector<Box>& from, std::vector<Box>& to) {
        for (const Box& one : from)
            if (const Box cut = intersection(one, box); !cut.is_empty())
                to.push_back(moved(cut, box.min * -1));
    };
    take(canvas.outputs, part.outputs);
    take(canvas.bands, part.bands);
    return part;
}

Box output_at(const Canvas& canvas, Vec2 point) {
    if (canvas.outputs.empty()) return {{0, 0}, canvas};
    return *std::ranges::min_element(canvas.outputs, {},
                                     [&](const Box& output) { return distance_to_box(output, point); });
}

Box output_of(const Canvas& canvas, const Box& box) {
    if (canvas.outputs.empty()) return {{0, 0}, canvas};
    const auto shown = [&](const Box& output) { return intersection(output, box).area(); };
    const Box& most = *std::ranges::max_element(canvas.outputs, {}, shown);
    return shown(most) > 0 ? most : output_at(canvas, box.centre());
}

}  // namespace vitrine::player
