#pragma once

#include "player/input/gestures.hpp"
#include "player/layout/cells/grid.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/wall_change.hpp"
#include "player/scene/wall_touch.hpp"
#include "tests/player/scene/packed_wall.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::player {

/// A wall of shots that fingers touch, frame by frame. It takes a moment until a way is made.
struct TouchedHouse {
    std::vector<PlacedShot> wall;  // as it is, or will be at the end of the way
    Canvas canvas;
    WallTouch touch{{.edits = {.budget = 10'000}, .idle = std::chrono::seconds(10)}};
    Gestures gestures;
    std::chrono::nanoseconds now{0};
    std::optional<WallChange> change = {};  // the way that the wall goes now
    std::vector<PlacedShot> before = {};    // the wall at its begin
    std::optional<TouchedWay> next = {};    // the way that is made now
    std::chrono::nanoseconds next_is_made{0};
    std::vector<Gesture> recognised = {};
    std::set<SourceId> dismissed = {};

    explicit TouchedHouse(int count = 6) : TouchedHouse(packed_wall(count), packed_canvas) {}

    TouchedHouse(std::vector<PlacedShot> shots, Vec2 size)
        : wall(std::move(shots)), canvas(size), gestures(gesture_rules(size)) {}

    TouchedWall touched() const { return {.shots = wall, .canvas = canvas}; }

    void put(Contact::Kind kind, int finger, Vec2 at = {}) {
        Subject subject = no_subject;
        if (kind == Contact::Kind::down)
            if (const PlacedShot* shot = touch.shot_at(at, touched())) subject = shot->shot.source;
        gestures.handle_input(Contact{.kind = kind, .finger = finger, .at = at, .time = now}, subject);
    }

    void tap(Vec2 at, int finger = 90) {
        put(Contact::Kind::down, finger, at);
        put(Contact::Kind::up, finger);
    }

    /// A finger that goes from place to place in a quarter of a second and stays there.
    void drag(int finger, Vec2 from, Vec2 to) {
        put(Contact::Kind::down, finger, from);
        for (int k = 1; k <= 10; ++k) {
            put(Contact::Kind::move, finger, from + (to - from) * (k / 10.0));
            frame();
        }
    }

    /// A finger flicks to the right.
    void flick_right(Vec2 from) {
        put(Contact::Kind::down, 0, from);
        for (int k = 1; k <= 8; ++k) {
            now += std::chrono::milliseconds(5);
            put(Contact::Kind::move, 0, from + Vec2{60.0 * k, 0});
        }
        put(Contact::Kind::up, 0);
    }

    /// The next frame, 25 ms later.
    Frame frame(std::chrono::nanoseconds later = std::chrono::milliseconds(25)) {
        now += later;
        recognised = gestures.next_gestures(now);
        for (const Gesture& gesture : recognised)
            touch.handle_gesture(gesture, touched());
        if (change && now - change->began >= change->duration) change.reset();
        touch.advance(now, touched(), true);
        for (const SourceId source : touch.take_needs().dismissed)
            dismissed.insert(source);
        if (!change && !next) ask_for_way();
        if (next && now >= next_is_made) begin_change();
        Frame frame = change ? change_frame(*change, before, {}, now) : standing_frame(canvas, wall, now);
        touch.lifted().draw(frame);
        return frame;
    }

    Frame run(std::chrono::nanoseconds duration) {
        Frame last = frame();
        for (const auto end = now + duration; now < end;)
            last = frame();
        return last;
    }

    std::vector<Placement> placements() const {
        std::vector<Placement> all;
        for (const PlacedShot& placed : wall)
            all.push_back(placed.placement);
        return all;
    }

    /// The shot's cell on the wall.
    static const DrawItem& below_of(const Frame& frame, SourceId source) {
        return *std::ranges::find(frame.items, source, &DrawItem::source);
    }

    /// The picture that is drawn last of a shot.
    static const DrawItem& top_of(const Frame& frame, SourceId source) {
        const auto found = std::find_if(frame.items.rbegin(), frame.items.rend(),
                                        [&](const DrawItem& item) { return item.source == source; });
        return *found;
    }

  private:
    void ask_for_way() {
        next = touch.next_way(touched());
        next_is_made = now + std::chrono::milliseconds(50);
    }

    void begin_change() {
        before = wall;
        change = WallChange{.canvas = canvas, .wall = wall, .is_by_touch = true, .duration = next->duration};
        const auto way = std::make_shared<const WallWay>(way_to(next->request));
        touch.way_taken(*way, take_way(*change, way));
        begin_way(*change, before, false, now);
        wall = change->wall;
        next.reset();
    }
};

/// The part of the I-Regions that cells of other shots on the wall cover, canvas px^2. Lifted shots are not
/// counted: they are drawn after the wall's. Neither are those that fade from place to place, or are not
/// seen.
/// @param change  the way that the wall goes now
inline double covered_by_others(const Frame& frame, const std::vector<PlacedShot>& wall,
                                const std::optional<WallChange>& change = {}) {
    const auto fades = [&](std::size_t i) {
        return change && change->way &&
               std::ranges::any_of(change->way->keys, [&](const WallKey& key) { return key.alphas[i] < 1; });
    };
    const std::span<const DrawItem> lifted = std::span(frame.items).subspan(wall.size());
    std::vector<const DrawItem*> seats;
    std::vector<bool> is_lifted;
    double light = 0;
    for (const PlacedShot& placed : wall) {
        seats.push_back(&TouchedHouse::below_of(frame, placed.shot.source));
        is_lifted.push_back(std::ranges::find(lifted, placed.shot.source, &DrawItem::source) != lifted.end());
        if (!is_lifted.back()) light = std::max(light, seats.back()->alpha);
    }
    double covered = 0;
    for (std::size_t i = 0; i < wall.size(); ++i) {
        if (is_lifted[i] || seats[i]->alpha < light || seats[i]->alpha <= 0 || fades(i)) continue;
        const Loops region{to_grid(placed_region(wall[i].shot.item, seats[i]->placement))};
        for (std::size_t j = 0; j < wall.size(); ++j) {
            Loops parts;
            for (const Polygon& part : seats[j]->cell->parts)
                parts.push_back(to_grid(part));
            if (j != i && seats[j]->alpha > 0) covered += area_of(intersection_of(region, parts));
        }
    }
    return covered;
}

}  // namespace vitrine::player
