#include "player/scene/caption_place.hpp"

#include "base/geometry/convex_hull.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

using namespace vitrine;
using namespace vitrine::player;

namespace {

constexpr Vec2 canvas{1280, 720};
constexpr std::array forms{CaptionSize{.aspect = 8, .letters = 64.0 / 90},
                           CaptionSize{.aspect = 2.2, .letters = 64.0 / 170}};

/// Random regions in a grid, with the cells between them.
struct RandomWall {
    std::vector<LayoutItem> items;
    Layout layout{.canvas = canvas};

    explicit RandomWall(std::mt19937& chance) {
        const auto share = [&](double from, double to) {
            return from + (to - from) * static_cast<double>(chance() % 1000) / 1000;
        };
        for (int x = 0; x < 4; ++x)
            for (int y = 0; y < 3; ++y) {
                std::vector<Vec2> points;
                for (int i = 0; i < 9; ++i)
                    points.push_back({320 * (x + share(0.1, 0.8)), 240 * (y + share(0.1, 0.7))});
                items.push_back({.region = convex_hull(points), .core = {{0, 0}, canvas}});
                layout.placements.push_back({});
            }
    }
};

/// True if a point of a fine grid over the box lies in the polygon.
bool covers(const Polygon& convex, const Box& box) {
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j)
            if (is_inside_convex(convex,
                                 {box.min.x + box.width() * i / 20, box.min.y + box.height() * j / 20}, 0))
                return true;
    return false;
}

}  // namespace

TEST_CASE("captions lie inside their cells, over no region, and can be read") {
    std::mt19937 chance(3);
    int placed = 0;
    for (int wall = 0; wall < 10; ++wall) {
        const RandomWall random(chance);
        const std::vector<Cell> all = cells(random.items, random.layout);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const CaptionRoom room{.cell = std::make_shared<const Cell>(all[i]),
                                   .region = random.items[i].region};
            const auto place = caption_place(room, forms, canvas);
            if (!place) continue;
            ++placed;
            const CaptionSize& size = forms.at(place->form);
            CHECK(place->box.height() * size.letters >= canvas.y / 40);
            CHECK(place->box.width() == doctest::Approx(place->box.height() * size.aspect));
            for (const LayoutItem& item : random.items)
                CHECK(!covers(item.region, place->box));
            for (const Vec2 corner : to_polygon(place->box)) {
                const bool is_on_canvas =
                    corner.x >= 0 && corner.x <= canvas.x && corner.y >= 0 && corner.y <= canvas.y;
                CHECK(is_on_canvas);
            }
            for (std::size_t other = 0; other < all.size(); ++other)
                if (other != i)
                    for (const auto& triangle : all[other].triangles)
                        CHECK(!covers(convex_hull(triangle), place->box));
        }
    }
    MESSAGE(placed << " of 120 captions have room");
    CHECK(placed > 60);
}

TEST_CASE("a caption keeps its place while nothing of another shot is drawn there and its cell goes on") {
    const auto cell = [](Vec2 from, Vec2 to) {
        return std::make_shared<const Cell>(Cell{.parts = {to_polygon({from, to})}});
    };
    CaptionRoom room{.source = 1,
                     .cell = cell({0, 0}, {400, 300}),
                     .next = cell({0, 0}, {400, 250}),
                     .region = to_polygon({{10, 10}, {390, 100}})};
    const Box caption{{100, 150}, {200, 200}};
    CHECK(keeps_place(caption, room, {}));
    CHECK(!keeps_place({{100, 210}, {200, 260}}, room, {}));
    CHECK(!keeps_place({{100, 80}, {200, 130}}, room, {}));
    std::vector<DrawItem> items{{.source = 1, .cell = room.cell},
                                {.source = 2, .cell = cell({400, 0}, {800, 300})}};
    CHECK(keeps_place(caption, room, items));
    items[1].cell = cell({150, 0}, {800, 300});
    CHECK(!keeps_place(caption, room, items));
}

TEST_CASE("there is no room in a cell that its region fills, nor for a photo that drifts over all of it") {
    Cell cell{.parts = {to_polygon({{0, 0}, {400, 300}})}};
    CaptionRoom room{.cell = std::make_shared<const Cell>(cell),
                     .region = to_polygon({{10, 10}, {390, 290}})};
    CHECK(!caption_place(room, forms, canvas));
    room.region = to_polygon({{10, 10}, {390, 200}});
    CHECK(caption_place(room, forms, canvas));

    PlacedShot shot{.cell = room.cell};
    shot.shot.item = {.region = room.region, .core = {{0, 0}, canvas}};
    shot.drift = {.from = {0, -80}, .to = {0, 80}};
    CHECK(!caption_place(caption_rooms(std::vector{shot}).front(), forms, canvas));
}

TEST_CASE("captions and QR codes stand where the region is, not on a part of the cell that lies apart") {
    const Polygon apart = to_polygon({{500, 0}, {1000, 600}});
    CaptionRoom room{
        .cell = std::make_shared<const Cell>(Cell{.parts = {to_polygon({{0, 0}, {400, 300}}), apart}}),
        .region = to_polygon({{10, 10}, {390, 290}})};
    CHECK(!caption_place(room, forms, canvas));
    CHECK(!code_place(room, 29, canvas));
    CHECK(!keeps_place({{600, 100}, {700, 150}}, room, {}));
    room.region = to_polygon({{10, 10}, {390, 100}});
    const auto place = caption_place(room, forms, canvas);
    REQUIRE(place);
    CHECK(place->box.max.x <= 400);
    const auto code = code_place(room, 29, canvas);
    REQUIRE(code);
    CHECK(code->max.x <= 400);
}

TEST_CASE("captions and QR codes keep off bezels, and off faces and lines of text wherever a photo drifts") {
    PlacedShot shot{.cell = std::make_shared<const Cell>(Cell{.parts = {to_polygon({{0, 0}, {400, 300}})}})};
    shot.placement = {.scale = 0.5, .offset = {10, 0}};
    shot.shot.item = {.region = to_polygon({{20, 20}, {700, 60}}), .core = {{0, 0}, {800, 600}}};
    const auto room_beside = [&](std::vector<Box> marks, const std::vector<Box>& bezels) {
        shot.shot.shot.marks = std::move(marks);
        return caption_rooms(std::vector{shot}, bezels).front();
    };
    const Box text{{0, 300}, {800, 590}};  // on the canvas from 150 to 295
    const auto free = caption_place(room_beside({}, {}), forms, canvas);
    REQUIRE(free);
    CHECK(free->box.max.y > 200);
    const auto above = caption_place(room_beside({text}, {}), forms, canvas);
    REQUIRE(above);
    CHECK(above->box.max.y <= 150);
    CHECK(!caption_place(room_beside({text}, {{{0, 30}, {400, 160}}}), forms, canvas));
    CHECK(!code_place(room_beside({text}, {{{0, 30}, {400, 160}}}), 29, canvas));
    shot.drift = {.from = {0, -120}, .to = {0, 0}};
    CHECK(!caption_place(room_beside({text}, {}), forms, canvas));
}

TEST_CASE("a QR code stands on whole pixels, in its cell, beside region and caption, and can be read") {
    std::mt19937 chance(4);
    const Box caption{{0, 600}, {1280, 640}};
    int placed = 0;
    for (int wall = 0; wall < 20; ++wall) {
        const RandomWall random(chance);
        const std::vector<Cell> all = cells(random.items, random.layout);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const CaptionRoom room{.cell = std::make_shared<const Cell>(all[i]),
                                   .region = random.items[i].region};
            const int modules = 29 + 4 * static_cast<int>(chance() % 3);
            const auto box = code_place(room, modules, canvas, caption);
            if (!box) continue;
            ++placed;
            const double module = box->width() / modules;
            CHECK(box->width() == box->height());
            CHECK(module == std::floor(module));
            CHECK(module >= min_code_module);
            CHECK(box->height() >= min_code_side * canvas.y);
            CHECK(box->min.x == std::floor(box->min.x));
            CHECK(box->min.y == std::floor(box->min.y));
            CHECK((box->max.y <= caption.min.y || box->min.y >= caption.max.y));
            for (const LayoutItem& item : random.items)
                CHECK(!covers(item.region, *box));
        }
    }
    MESSAGE(placed << " of 240 codes have room");
    CHECK(placed > 20);
}

TEST_CASE("a QR code that is too small to be read is left out") {
    const CaptionRoom room{
        .cell = std::make_shared<const Cell>(Cell{.parts = {to_polygon({{0, 0}, {100, 100}})}})};
    CHECK(code_place(room, 29, canvas));
    CHECK(!code_place(room, 37, canvas));
}

TEST_CASE("the wall's QR code on the idle picture lies on the canvas") {
    for (const int modules : {29, 45, 73}) {
        const Box box = idle_code_place(modules, canvas);
        CHECK(box.width() >= min_code_module * modules);
        CHECK(box.max.x <= canvas.x);
        CHECK(box.max.y <= canvas.y);
        CHECK(box.min.y >= 0);
    }
}
