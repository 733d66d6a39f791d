#include "player/scene/transition.hpp"

#include "tests/player/scene/changing_wall.hpp"
#include "tests/player/scene/frame_faults.hpp"

#include <doctest/doctest.h>

#include <map>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Vec2 canvas{400, 200};
const TransitionStyle style{.duration = 1000ms};

PlacedShot shot(SourceId source, int slot, Vec2 offset, double scale = 1) {
    PlacedShot placed{.shot = {.source = source, .slot = slot, .picture = {100, 100}}};
    placed.shot.item = {.region = to_polygon({{30, 30}, {70, 70}}), .core = {{0, 0}, {100, 100}}};
    placed.placement = {scale, offset};
    return placed;
}

std::vector<PlacedShot> wall(std::vector<PlacedShot> shots) {
    give_cells(shots, canvas, {});
    return shots;
}

const DrawItem* find_item(const Frame& frame, SourceId source) {
    const auto found = std::ranges::find(frame.items, source, &DrawItem::source);
    return found == frame.items.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("where no shot moves, the new shot fades in over the one that leaves") {
    const Transition made = transition(canvas, wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})}),
                                       wall({shot(1, 0, {0, 0}), shot(3, 1, {100, 0})}), style);
    CHECK(made.motion.kind == Motion::Kind::still);
    const Frame middle = transition_frame(made, 500ms, {}, 0s);
    CHECK(find_item(middle, 2)->alpha == 1);
    CHECK(find_item(middle, 3)->alpha == doctest::Approx(0.5));
}

TEST_CASE("a shot comes while the others move, and the one that leaves stays below until it is covered") {
    const auto last = wall({shot(1, 0, {0, 50}), shot(3, 1, {110, 0})});
    const Transition made = transition(canvas, wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})}), last, style);
    const Frame middle = transition_frame(made, 500ms, {}, 0s);
    CHECK(find_item(middle, 1)->placement.offset.y == doctest::Approx(25));
    CHECK(find_item(middle, 1)->alpha == 1);
    CHECK(find_item(middle, 2)->alpha == 1);
    CHECK(find_item(middle, 2)->placement.offset.x == 100);
    CHECK(middle.items.back().source == 3);
    CHECK(middle.items.back().alpha == doctest::Approx(0.5));
    CHECK(find_item(transition_frame(made, 0ms, {}, 0s), 3) == nullptr);
    const Frame end = transition_frame(made, 1000ms, {}, 0s);
    CHECK(find_item(end, 2) == nullptr);
    CHECK(find_item(end, 3)->alpha == 1);
    CHECK(find_item(end, 1)->placement == last[0].placement);
}

TEST_CASE("a shot that leaves without a successor is gone when the others have taken its room") {
    const Transition made = transition(canvas, wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})}),
                                       wall({shot(1, 0, {40, -60}, 2.4)}), style);
    REQUIRE(made.motion.kind == Motion::Kind::straight);
    CHECK(made.fade_end < 1);
    for (int k = 0; k <= 20; ++k)
        CHECK(faults_of(made, k / 20.0).covered < 0.01);
    const Frame late = transition_frame(made, 990ms, {}, 0s);
    const DrawItem* rest = find_item(late, 2);
    CHECK((rest == nullptr || area_of(grid_loops(rest->cell->parts)) < 0.01 * canvas.x * canvas.y));
    CHECK(find_item(transition_frame(made, 1000ms, {}, 0s), 2) == nullptr);
}

TEST_CASE("a shot that moves is not seen at its old or its new place, too") {
    // Shot 1 goes to the other end below a large shot, which gives way to another.
    const Transition made = transition(canvas, wall({shot(1, 0, {0, 150}, 0.5), shot(2, 1, {100, -50}, 3)}),
                                       wall({shot(1, 0, {350, 150}, 0.5), shot(3, 1, {0, -50}, 3)}), style);
    REQUIRE(made.motion.kind == Motion::Kind::straight);
    for (int k = 0; k <= 20; ++k) {
        CAPTURE(k);
        const FrameFaults faults = faults_of(made, k / 20.0);
        CHECK(faults.twice < 0.05);
        CHECK(faults.covered < 0.05);
        CHECK(faults.bare < 0.5);
    }
}

TEST_CASE("only the shots that have no free way fade from place to place") {
    constexpr Vec2 narrow{400, 50};
    std::vector<PlacedShot> first{shot(1, 0, {0, -25}), shot(2, 1, {50, -25}), shot(3, 2, {200, -25})};
    std::vector<PlacedShot> last{shot(1, 0, {50, -25}), shot(2, 1, {0, -25}), shot(3, 2, {260, -25})};
    give_cells(first, narrow, {});
    give_cells(last, narrow, {});
    const Transition made = transition(narrow, first, last, style);
    for (int k = 0; k <= 20; ++k)
        CHECK(faults_of(made, k / 20.0).covered < 0.01);
    CHECK(wayless_count(made) == 1);
    CHECK(made.old_wall[2].moving);
}

TEST_CASE("a shot whose seat another one takes keeps a place in the corner that is covered last") {
    const Transition made =
        transition(canvas, wall({shot(1, 0, {25, -25}, 2.5), shot(2, 1, {130, -25}, 2.5)}),
                   wall({shot(2, 1, {25, -25}, 2.5), shot(3, 0, {130, -25}, 2.5)}), style);
    CHECK(wayless_count(made) == 0);
    CHECK(made.fade_end - made.fade_begin >= 0.5);
}

TEST_CASE("no shot darts: a long way between two keys gets more time than a short one") {
    constexpr int frames = 24;
    // A motion at one speed has 1, and a straight way that is eased has 1.5.
    constexpr double max_step = 2.4;
    int seen = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        ChangingWall changing({960, 540}, 12, seed);
        const Transition made = transition(changing.canvas(), changing.shown(), changing.turned(), style);
        if (made.motion.keys.size() < 4) continue;
        CAPTURE(seed);
        ++seen;
        const auto farthest = [&](std::span<const Placement> from, std::span<const Placement> to) {
            double way = 0;
            for (const ChangingShot& moved : made.old_wall)
                for (const Vec2 corner : moved.placed.shot.item.region)
                    if (moved.moving) {
                        const Placement &a = from[*moved.moving], &b = to[*moved.moving];
                        way = std::max(way, length(corner * (b.scale - a.scale) + b.offset - a.offset));
                    }
            return way;
        };
        double whole = 0;
        for (std::size_t key = 0; key + 1 < made.motion.keys.size(); ++key)
            whole += farthest(made.motion.keys[key], made.motion.keys[key + 1]);
        double longest = 0;
        for (int k = 0; k < frames; ++k)
            longest = std::max(longest, farthest(placements_at(made, k / double{frames}),
                                                 placements_at(made, (k + 1) / double{frames})));
        CHECK(longest < max_step * whole / frames);
    }
    MESSAGE(seen << " motions with three or more parts");
    CHECK(seen >= 3);
}

namespace {

/// Collects the parts of the canvas that each shot covers with full opacity in a frame.
std::map<SourceId, Loops> shown_in(const Frame& frame) {
    std::map<SourceId, Loops> shown;
    for (const DrawItem& item : frame.items)
        if (item.alpha >= 1) shown[item.source] = union_of(shown[item.source], grid_loops(item.cell->parts));
    return shown;
}

double difference_area(const Loops& a, const Loops& b) {
    return area_of(difference_of(a, b)) + area_of(difference_of(b, a));
}

}  // namespace

TEST_CASE("no cell takes another form for one frame of a change") {
    constexpr int frames = 24;
    constexpr double max_area = 800;  // canvas px^2 that come and go
    const CellStyle taut{.is_taut = true};
    for (const std::uint64_t seed : {4, 8, 28, 33}) {
        ChangingWall changing({960, 540}, 6 + seed % 12, seed, random_item, taut);
        for (const bool is_turn : {true, false}) {
            const auto next = is_turn ? changing.turned() : changing.with_one_more();
            const Transition made = transition(changing.canvas(), changing.shown(), next, style);
            std::vector<std::map<SourceId, Loops>> seen;
            for (int k = 0; k <= frames; ++k)
                seen.push_back(shown_in(transition_frame(made, made.duration * k / frames, taut, {})));
            for (std::size_t k = 1; k + 1 < seen.size(); ++k)
                for (const auto& [source, now] : seen[k]) {
                    CAPTURE(seed);
                    CAPTURE(k);
                    const double comes = difference_area(seen[k - 1][source], now);
                    const double goes = difference_area(now, seen[k + 1][source]);
                    const double both = difference_area(seen[k - 1][source], seen[k + 1][source]);
                    CHECK(std::min(comes, goes) - both < max_area);
                }
            changing.show(next);
        }
    }
}

TEST_CASE("where nothing shall move, all that changes fades at its place") {
    const auto first = wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})});
    const auto last = wall({shot(1, 0, {200, 0}), shot(2, 1, {100, 0})});
    TransitionStyle still = style;
    still.moves = false;
    const Frame middle = transition_frame(transition(canvas, first, last, still), 500ms, {}, 0s);
    CHECK(middle.items[0].placement == first[0].placement);
    CHECK(middle.items[0].alpha == 1);
    CHECK(middle.items.back().alpha == doctest::Approx(0.5));
}

namespace {

/// No frame of any change covers an I-Region that stays, is bare, or has new filler.
/// @return  shots without a free way
std::size_t check_changes(std::uint64_t seeds, const CellStyle& cells) {
    std::size_t wayless = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        ChangingWall changing({960, 540}, 5 + 3 * seed, seed, random_item, cells);
        for (int change = 0; change < 3; ++change) {
            CAPTURE(seed);
            CAPTURE(change);
            const auto next = change == 0   ? changing.turned()
                              : change == 1 ? changing.with_one_more()
                                            : changing.with_one_less();
            const Transition made = transition(changing.canvas(), changing.shown(), next, style);
            wayless += wayless_count(made);
            for (int k = 0; k <= 12; ++k) {
                const FrameFaults faults = faults_of(made, k / 12.0, cells);
                CHECK(faults.covered < 0.05);
                CHECK(faults.bare < 0.5);
                CHECK(faults.dark < 0.5);
            }
            changing.show(next);
        }
    }
    return wayless;
}

}  // namespace

TEST_CASE("few shots take places to which they have a way, so that few fade") {
    int changes = 0;
    int faded = 0;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        ChangingWall changing({1920, 1080}, 6, seed);
        for (int change = 0; change < 4; ++change) {
            const auto next = change == 0 ? changing.with_one_less() : changing.turned();
            const Transition made = transition(changing.canvas(), changing.shown(), next, style);
            ++changes;
            if (wayless_count(made) > 0) ++faded;
            changing.show(next);
        }
    }
    CHECK(faded <= changes / 20);
}

TEST_CASE("no frame of a change covers an I-Region that stays, is bare, or has new filler") {
    CHECK(check_changes(4, {}) <= 2);
}

TEST_CASE("no frame of a change with taut seams covers an I-Region that stays, is bare, or has new filler") {
    CHECK(check_changes(3, {.is_taut = true}) <= 2);
    CHECK(check_changes(1, {.is_taut = true, .corner_radius = 24}) <= 2);
}

namespace {

/// The part of the canvas where no cell is opaque, canvas px^2.
double bare_area(const Frame& frame) {
    Loops drawn;
    for (const DrawItem& item : frame.items)
        if (item.alpha >= 1)
            drawn = union_of(union_of(drawn, grid_loops(item.cell->parts)), grid_loops(item.cell->filler));
    return frame.canvas.x * frame.canvas.y - area_of(drawn);
}

}  // namespace

TEST_CASE("no frame of a drag of one hand or two covers an I-Region or is dark, and all ends in its place") {
    for (const int hands : {1, 2}) {
        CAPTURE(hands);
        ChangingWall changing({960, 540}, 8, 5);
        int frames = 0;
        changing.drag(hands, [&](const TouchedHouse& house, const Frame& frame) {
            CAPTURE(frames);
            CHECK(covered_by_others(frame, house.wall) < 0.05);
            CHECK(bare_area(frame) < 0.5);
            const bool is_dragged = frame.items.size() > house.wall.size() && frames > 12 && frames < 20;
            for (std::size_t i = 0; is_dragged && i < house.wall.size(); ++i)
                CHECK(frame.items[i].filler_light > 0.8);
            ++frames;
        });
        CHECK(frames > 25);
        CHECK(frames < 100);
        CHECK(std::ranges::none_of(changing.shown(), &PlacedShot::is_above));
    }
}
