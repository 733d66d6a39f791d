#pragma once

#include "player/input/gestures.hpp"
#include "player/layout/cells/grid.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/wall_touch.hpp"
#include "tests/player/scene/packed_wall.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace vitrine::player {

/// A wall of shots that fingers touch, frame by frame. Ways are made at once and take their time.
struct TouchedHouse {
    std::vector<PlacedShot> wall;
    WallTouch touch{{.edits = {.budget = 10'000}, .idle = std::chrono::seconds(10)}};
    Gestures gestures{gesture_rules(packed_canvas)};
    std::chrono::nanoseconds now{0};
    std::shared_ptr<const WallWay> way = {};  // that the wall goes now
    std::vector<PlacedShot> before = {};      // the wall at its begin
    std::chrono::nanoseconds way_begins{0};
    std::chrono::nanoseconds way_takes{0};
    std::vector<Gesture> recognised = {};
    std::set<SourceId> dismissed = {};

    explicit TouchedHouse(int count = 6) : wall(packed_wall(count)) {}

    TouchedWall touched() const { return {.shots = wall, .canvas = packed_canvas}; }

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

    /// The next frame, 25 ms later.
    Frame frame(std::chrono::nanoseconds later = std::chrono::milliseconds(25)) {
        now += later;
        recognised = gestures.next_gestures(now);
        for (const Gesture& gesture : recognised)
            touch.handle_gesture(gesture, touched());
        if (way && now - way_begins >= way_takes) way.reset();
        touch.advance(now, touched(), true);
        for (const SourceId source : touch.take_needs().dismissed)
            dismissed.insert(source);
        if (!way) begin_way();
        Frame frame = standing_frame(packed_canvas, wall, now);
        show_way(frame);
        touch.draw(frame);
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

    /// The picture that is drawn last of a shot.
    static const DrawItem& top_of(const Frame& frame, SourceId source) {
        const auto found = std::find_if(frame.items.rbegin(), frame.items.rend(),
                                        [&](const DrawItem& item) { return item.source == source; });
        return *found;
    }

  private:
    void begin_way() {
        const auto next = touch.next_way(touched());
        if (!next) return;
        before = wall;
        way = std::make_shared<const WallWay>(way_to(next->request));
        way_begins = now;
        way_takes = next->duration;
        for (std::size_t i = 0; i < wall.size(); ++i) {
            wall[i].placement = way->keys.back().placements[i];
            wall[i].cell = way->keys.back().cells[i];
        }
        touch.way_taken(*way, touched());
    }

    void show_way(Frame& frame) const {
        if (!way) return;
        const double share =
            std::chrono::duration<double>(now - way_begins) / std::chrono::duration<double>(way_takes);
        const auto passed = static_cast<std::size_t>(share * static_cast<double>(way->keys.size()));
        for (std::size_t i = 0; i < wall.size(); ++i) {
            const bool is_old = passed == 0 || !way->is_free;
            frame.items[i].placement = is_old ? before[i].placement : way->keys[passed - 1].placements[i];
            frame.items[i].cell = is_old ? before[i].cell : way->keys[passed - 1].cells[i];
        }
    }
};

/// The part of the I-Regions that cells of other shots on the wall cover, canvas px^2. Lifted shots are not
/// counted: they are drawn after the wall's.
inline double covered_by_others(const Frame& frame, const std::vector<PlacedShot>& wall) {
    double covered = 0;
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const Loops region{to_grid(placed_region(wall[i].shot.item, frame.items[i].placement))};
        for (std::size_t j = 0; j < wall.size(); ++j) {
            Loops parts;
            for (const Polygon& part : frame.items[j].cell->parts)
                parts.push_back(to_grid(part));
            if (j != i) covered += area_of(intersection_of(region, parts));
        }
    }
    return covered;
}

}  // namespace vitrine::player
