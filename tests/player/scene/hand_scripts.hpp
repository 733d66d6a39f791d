#pragma once

#include "player/layout/pack/search_budget.hpp"
#include "tests/player/scene/touched_house.hpp"

#include <doctest/doctest.h>

namespace vitrine::player {

/// A script of up to ten contacts on a wall, some of which are lost or stuck. Checks every frame.
class HandScript {
  public:
    explicit HandScript(std::uint64_t seed)
        : random_(seed), house_(3 + static_cast<int>(uniform_index(random_, 6))), taps_(seed % 2 == 0) {}

    void play() {
        constexpr int frames = 60;
        for (int k = 0; k < frames; ++k) {
            for (int finger = 0; finger < max_fingers; ++finger)
                act(finger);
            check(house_.frame(), k % 4 == 0);
        }
        for (const auto& [finger, contact] : fingers_)
            if (!contact.is_stuck) house_.put(taps_ ? Contact::Kind::up : Contact::Kind::cancel, finger);
        for (int k = 0; k < 60; ++k)
            check(house_.frame(), false);
        for (int k = 0; k < 80; ++k)
            house_.frame(std::chrono::seconds(1));
        check_end();
    }

  private:
    static constexpr int max_fingers = 10;

    struct Finger {
        Vec2 from;
        Vec2 at;
        Vec2 speed;
        bool is_stuck = false;  // it never moves or is lifted again
    };

    Vec2 any_place() {
        const double x = uniform(random_);
        return {packed_canvas.x * x, packed_canvas.y * uniform(random_)};
    }

    void act(int finger) {
        const auto found = fingers_.find(finger);
        const double chance = uniform(random_);
        if (found == fingers_.end()) {
            if (chance < 0.04) put_down(finger);
            return;
        }
        Finger& contact = found->second;
        if (contact.is_stuck) return;
        const bool would_tap = length(contact.at - contact.from) < 20;
        if (chance < 0.04)
            return lift(finger, would_tap && !taps_ ? Contact::Kind::cancel : Contact::Kind::up);
        if (chance < 0.05) return lift(finger, Contact::Kind::cancel);
        if (chance < 0.06) return put_down(finger);  // its release was lost
        contact.at = contact.at + contact.speed;
        if (contact.speed != Vec2{}) house_.put(Contact::Kind::move, finger, contact.at);
    }

    void put_down(int finger) {
        const double kind = uniform(random_);
        const Vec2 speed = (any_place() - packed_canvas * 0.5) * 0.05;
        const bool rests = kind < 0.4;
        const Vec2 at = any_place();
        const Finger contact{at, at, rests ? Vec2{} : speed, kind > 0.92 || kind < 0.06};
        house_.put(Contact::Kind::down, finger, contact.at);
        fingers_[finger] = contact;
        if (taps_ && rests && !contact.is_stuck) lift(finger, Contact::Kind::up);
    }

    void lift(int finger, Contact::Kind kind) {
        house_.put(kind, finger);
        fingers_.erase(finger);
    }

    void check(const Frame& frame, bool is_thorough) {
        using Kind = Gesture::Kind;
        const std::size_t count = house_.wall.size();
        std::set<SourceId> above;
        for (std::size_t i = count; i < frame.items.size(); ++i)
            REQUIRE(above.insert(frame.items[i].source).second);
        for (const Gesture& gesture : house_.recognised) {
            const bool is_on_shot = gesture.subject != no_subject && !taps_;
            if (gesture.kind == Kind::drag || gesture.kind == Kind::hold)
                in_hand_[gesture.touch] = gesture.subject;
            if (gesture.kind == Kind::drag) under_finger_[gesture.subject] = house_.now;
            if (gesture.kind == Kind::drop || gesture.kind == Kind::flick || gesture.kind == Kind::lost ||
                gesture.kind == Kind::release)
                in_hand_.erase(gesture.touch);
            if (gesture.kind == Kind::drag && is_on_shot && in_hand_.contains(gesture.touch))
                CHECK(above.contains(gesture.subject));  // no gesture is lost
        }
        for (const auto& [touch, source] : in_hand_)
            under_finger_[source] = house_.now;
        for (const SourceId source : above)
            if (!taps_) longest_ = std::max(longest_, house_.now - under_finger_[source]);
        if (is_thorough) CHECK(covered_by_others(frame, house_.wall, house_.change) < 1);
    }

    void check_end() {
        CHECK(longest_ <= std::chrono::milliseconds(1200));  // from its release until a shot is in its place
        CHECK_FALSE(house_.gestures.is_touched());
        CHECK_FALSE(house_.touch.is_active());
        const Frame last = house_.frame();
        CHECK(last.items.size() == house_.wall.size());
        CHECK(covered_by_others(last, house_.wall) < 1);
        for (std::size_t i = 0; i < house_.wall.size(); ++i) {
            const Box box = bounding_box(placed_region(house_.wall[i].shot.item, house_.wall[i].placement));
            const double outside =
                std::max({-box.min.x, -box.min.y, box.max.x - packed_canvas.x, box.max.y - packed_canvas.y});
            CHECK(outside < .01);  // px
        }
    }

    Random random_;
    TouchedHouse house_;
    bool taps_;
    std::map<int, Finger> fingers_;
    std::map<std::uint64_t, SourceId> in_hand_;
    std::chrono::nanoseconds longest_{0};
    std::map<SourceId, std::chrono::nanoseconds> under_finger_;
};

inline void play_scripts(std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        CAPTURE(seed);
        HandScript(seed).play();
    }
}

}  // namespace vitrine::player
