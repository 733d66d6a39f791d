// The frames of a change as they are drawn: between cells that move nothing shows through, and at their
// borders nothing of a bar or of a scan's border.

#include "player/scene/transition_frame.hpp"
#include "tests/player/render/drawn_wall.hpp"
#include "tests/player/scene/changing_wall.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Colour light{200, 200, 200};
constexpr Vec2 canvas{640, 360};

/// True if a point is farther than `edge` from a box.
bool is_beside(const Box& box, Vec2 p, double edge) {
    return p.x < box.min.x - edge || p.x > box.max.x + edge || p.y < box.min.y - edge ||
           p.y > box.max.y + edge;
}

/// True if a point lies in filler or at its edge.
bool is_near_filler(const Frame& frame, Vec2 p) {
    constexpr double edge = 1.5;  // px
    for (const DrawItem& item : frame.items)
        for (const auto& t : item.cell->filler_triangles) {
            if (is_beside(bounding_box(t), p, edge)) continue;
            bool is_left = true;
            bool is_right = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2 a = t[k];
                const Vec2 b = t[(k + 1) % 3];
                if (distance_to_segment(p, a, b) <= edge) return true;
                (cross(b - a, p - a) >= 0 ? is_right : is_left) = false;
            }
            if (is_left || is_right) return true;
        }
    return false;
}

/// The pixels of a frame, away from filler, that do not have the one colour of all pictures.
int odd_pixels(DrawnWall& drawn, const Frame& frame) {
    int count = 0;
    drawn.frame = frame;
    const Picture picture = drawn.shown();
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (!is_near(at(picture, x, y), light, 6) && !is_near_filler(frame, {x + 0.5, y + 0.5})) ++count;
    return count;
}

int odd_pixels(DrawnWall& drawn, const Transition& made) {
    int count = 0;
    for (int k = 0; k < 10; ++k)
        count += odd_pixels(drawn, transition_frame(made, made.duration * (2 * k + 1) / 20, {}, 0s));
    return count;
}

/// Gives all shots of a wall, now and later, the same picture.
void upload_all(DrawnWall& drawn, const Still& picture) {
    for (SourceId source = 1; source < 40; ++source)
        drawn.renderer.upload(source, picture.sample);
}

}  // namespace

TEST_CASE("no pixel in a frame of a change or a drag is of no picture, but in filler") {
    for (const std::size_t count : {5, 9}) {
        DrawnWall drawn(640, 360);
        ChangingWall wall(canvas, count, count);
        upload_all(drawn, plain(light));
        const auto look_at = [&](const std::vector<PlacedShot>& next) {
            CHECK(odd_pixels(drawn, transition(canvas, wall.shown(), next, {})) == 0);
        };
        for (int change = 0; change < 3; ++change) {
            auto next = change == 0   ? wall.turned()
                        : change == 1 ? wall.with_one_more()
                                      : wall.with_one_less();
            look_at(next);
            wall.show(std::move(next));
        }
        for (const int hands : {1, 2})
            wall.drag(hands, [&](const TouchedHouse&, const Frame& frame) {
                if (frame.time.count() % 4 == 0) CHECK(odd_pixels(drawn, frame) == 0);
            });
    }
}

TEST_CASE("no frame of a change shows anything of bars, at no border of a cell") {
    constexpr int bar = 240;
    const Still barred = still(1920, 1080, [&](int x, int y) {
        return x < bar || y < bar ? Colour{20, 0, 0} : light;
    });
    const DrawItems draw = [&](Random& random) {
        const Box core{{bar, bar}, {1920, 1080}};
        const Vec2 half = (core.max - core.min) * (0.2 + 0.2 * uniform(random));
        return LayoutItem{.region = to_polygon({core.centre() - half, core.centre() + half}), .core = core};
    };
    DrawnWall drawn(640, 360);
    ChangingWall wall(canvas, 7, 1, draw);
    upload_all(drawn, barred);
    auto next = wall.turned();
    CHECK(odd_pixels(drawn, transition(canvas, wall.shown(), next, {})) == 0);
    wall.show(std::move(next));
    CHECK(odd_pixels(drawn, transition(canvas, wall.shown(), wall.with_one_more(), {})) == 0);
}
