#include "tests/player/render/random_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int smallest = 48;  // texels of a picture's side; in smaller ones no picture is smooth

double between(Dice& dice, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
}

bool happens(Dice& dice, double share) {
    return between(dice, 0, 1) < share;
}

int side_up_to(Dice& dice, int max_side) {
    return static_cast<int>(std::lround(std::exp(between(dice, std::log(100), std::log(max_side)))));
}

/// A wall's items on a canvas, in one style of cells.
class RandomWall {
  public:
    /// @param frame  gets the pictures. @param first  the number of the first source
    RandomWall(Dice& dice, RandomFrame& frame, SourceId first) : dice_(dice), made_(frame), source_(first) {
        const auto columns = static_cast<int>(1 + dice_() % 4);
        const auto rows = static_cast<int>(1 + dice_() % 3);
        const Vec2 canvas = made_.frame.canvas;
        layout_.canvas = canvas;
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                add_item({{canvas.x * column / columns, canvas.y * row / rows},
                          {canvas.x * (column + 1) / columns, canvas.y * (row + 1) / rows}});
    }

    /// The items of this wall. @param alpha  their opacity
    std::vector<DrawItem> items(double alpha) {
        CellStyle style;
        if (happens(dice_, 0.3)) style.gutter = between(dice_, 1, 12);
        if (happens(dice_, 0.3)) style.corner_radius = between(dice_, 2, 20);
        if (happens(dice_, 0.3)) style.feather = between(dice_, 3, 40);
        const std::vector<Cell> shapes = cells(items_, layout_, style);
        std::vector<DrawItem> all;
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            DrawItem item{.source = source_++,
                          .cell = std::make_shared<const Cell>(shapes[i]),
                          .placement = layout_.placements[i],
                          .picture = pictures_[i],
                          .alpha = alpha};
            if (happens(dice_, 0.3)) {
                const Vec2 bars{item.picture.x * between(dice_, 0, 0.3),
                                item.picture.y * between(dice_, 0, 0.3)};
                item.active = {bars, item.picture - bars};
            }
            Vec2 slide;
            if (happens(dice_, 0.2)) slide = {between(dice_, -4, 4), between(dice_, -4, 4)};
            if (!happens(dice_, 0.02)) {
                add_picture(item);
                made_.pictures.at(item.source).still.sample.slide = slide;
                item.slide_share = std::abs(slide.x) / 4;
            }
            all.push_back(item);
        }
        return all;
    }

  private:
    /// Adds an item whose region lies in a box of the canvas and whose picture reaches beyond it.
    void add_item(const Box& box) {
        const Vec2 half{box.width() * between(dice_, 0.2, 0.47), box.height() * between(dice_, 0.2, 0.47)};
        const Vec2 centre = box.centre();
        const double reach = between(dice_, 0, 1.2);
        const double scale = std::exp(between(dice_, std::log(0.2), std::log(2.0)));
        Vec2 corner = centre - half * (1 + reach);
        if (happens(dice_, 0.3)) corner = {std::round(corner.x), std::round(corner.y)};
        const Placement at{scale, corner};
        const Vec2 picture = half * (2 * (1 + reach) / scale);
        LayoutItem item{.region = {}, .core = {{0, 0}, picture}};
        const auto count = 3 + dice_() % 6;
        for (std::size_t k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + between(dice_, 0, 0.8)) /
                                 static_cast<double>(count);
            const Vec2 p = centre + Vec2{half.x * std::cos(angle), half.y * std::sin(angle)};
            item.region.push_back((p - at.offset) * (1 / scale));
        }
        items_.push_back(std::move(item));
        layout_.placements.push_back(at);
        pictures_.push_back(picture);
    }

    void add_picture(const DrawItem& item) {
        const Vec2 shown = item.picture * item.placement.scale;
        const double texels =
            happens(dice_, 0.4) ? 1 : std::exp(between(dice_, std::log(0.3), std::log(5.0)));
        const auto extent = [&](double px) {
            return std::clamp(static_cast<int>(std::lround(px * texels)), smallest, 1500);
        };
        made_.pictures[item.source] = random_picture(dice_, extent(shown.x), extent(shown.y), made_);
    }

    Dice& dice_;         // outlives this
    RandomFrame& made_;  // outlives this
    SourceId source_;
    Layout layout_;
    std::vector<LayoutItem> items_;
    std::vector<Vec2> pictures_;
};

void append(Frame& frame, std::vector<DrawItem> items) {
    frame.items.insert(frame.items.end(), items.begin(), items.end());
}

/// A wall, alone or in a change.
void add_walls(RandomFrame& made, Dice& dice) {
    Frame& frame = made.frame;
    const double alpha = happens(dice, 0.1) ? 0.999 : between(dice, 0.01, 1);
    switch (dice() % 6) {
    case 0:  // stands
        return append(frame, RandomWall(dice, made, 1).items(1));
    case 1:  // over the idle picture, or with it
        frame.idle = 1;
        return append(frame, RandomWall(dice, made, 1).items(alpha));
    case 2:  // each at its own time
        frame.idle = 1;
        append(frame, RandomWall(dice, made, 1).items(1));
        for (DrawItem& item : frame.items)
            item.alpha = happens(dice, 0.3) ? 1 : between(dice, 0, 1);
        return;
    case 3:  // one wall fades out, another in
        frame.is_fade = happens(dice, 0.5);
        frame.idle = frame.is_fade ? alpha : 1;
        append(frame, RandomWall(dice, made, 1).items(1 - alpha));
        return append(frame, RandomWall(dice, made, 100).items(alpha));
    default:  // one wall fades in over another
        append(frame, RandomWall(dice, made, 1).items(1));
        return append(frame, RandomWall(dice, made, 100).items(alpha));
    }
}

/// A tile of a tapestry between two levels.
ZoomMesh random_mesh(Dice& dice, Vec2 size, bool is_whole) {
    constexpr int columns = 5;
    constexpr int rows = 4;
    ZoomMesh mesh{.vertices = {}, .triangles = {}, .is_whole = is_whole};
    const auto number = [](double value) { return static_cast<float>(value); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double u = static_cast<double>(column) / (columns - 1);
            const double v = static_cast<double>(row) / (rows - 1);
            const auto moved = [&](double share, double extent) {
                return number(extent * (share + between(dice, -0.04, 0.04)));
            };
            mesh.vertices.push_back({.coarse_x = moved(u, size.x),
                                     .coarse_y = moved(v, size.y),
                                     .fine_x = moved(u, size.x * 1.4),
                                     .fine_y = moved(v, size.y),
                                     .u = number(u),
                                     .v = number(v),
                                     .growth = is_whole ? -1 : number(between(dice, 0.1, 2))});
        }
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const int a = row * columns + column;
            for (const int corner : {a, a + 1, a + columns + 1, a, a + columns + 1, a + columns})
                mesh.triangles.push_back(static_cast<std::uint16_t>(corner));
        }
    return mesh;
}

void add_zooms(RandomFrame& made, Dice& dice) {
    made.has_planes = false;  // tiles are colours
    const Vec2 canvas = made.frame.canvas;
    const double share = between(dice, 0, 1);
    const double alpha = happens(dice, 0.5) ? 1 : between(dice, 0.05, 1);
    const Vec2 strip = canvas * between(dice, 0.4, 1.2);
    for (SourceId source = 1; source <= 3; ++source) {
        const double scale = between(dice, 0.5, 1.5);
        DrawItem item{
            .source = source,
            .zoom = std::make_shared<const ZoomMesh>(random_mesh(dice, strip * (1 / scale), source < 3)),
            .share = share,
            .placement = {scale, {canvas.x * between(dice, -0.3, 0.5), canvas.y * between(dice, -0.1, 0.3)}},
            .picture = strip * (1 / scale),
            .alpha = alpha};
        const double texels = between(dice, 0.7, 2);
        const auto extent = [&](double px) {
            return std::clamp(static_cast<int>(std::lround(px * texels)), smallest, 1500);
        };
        made.pictures[source] = random_picture(dice, extent(strip.x), extent(strip.y), made);
        made.frame.items.push_back(std::move(item));
    }
}

View random_view(Dice& dice, int width, int height) {
    View view{.rotation = static_cast<Rotation>(dice() % 4)};
    if (!happens(dice, 0.3)) return view;
    const auto margin = [&](int side) {
        return static_cast<int>(dice() % static_cast<std::uint64_t>(side / 5));
    };
    view.left = margin(width);
    view.right = margin(width);
    view.top = margin(height);
    view.bottom = margin(height);
    return view;
}

}  // namespace

RandomFrame random_frame(std::uint64_t seed, int max_side) {
    Dice dice(seed);
    RandomFrame made;
    made.width = side_up_to(dice, max_side);
    made.height = std::min(side_up_to(dice, max_side), std::max(100, 3'000'000 / made.width));
    made.view = random_view(dice, made.width, made.height);
    made.is_noise = happens(dice, 0.25);
    made.has_planes = happens(dice, 0.5);
    made.frame.time = std::chrono::milliseconds(dice() % 3'000'000);
    made.frame.canvas = canvas_size(made.width, made.height, made.view);
    if (happens(dice, 0.25)) {  // a canvas of another size, as on the second screen of a stage
        const double larger = between(dice, 0.6, 1.6);
        made.frame.canvas = {std::round(made.frame.canvas.x * larger),
                             std::round(made.frame.canvas.y * larger)};
    }
    if (happens(dice, 0.1))
        add_zooms(made, dice);
    else
        add_walls(made, dice);
    if (happens(dice, 0.15)) made.frame.view = {between(dice, -40, 40), happens(dice, 0.5) ? 0.0 : 7.0};
    return made;
}

}  // namespace vitrine::player
