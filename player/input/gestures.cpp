#include "player/input/gestures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double min_spread = 1;        // px between two fingers
constexpr std::size_t max_fingers = 2;  // more fingers are a palm

}  // namespace

GestureRules gesture_rules(Vec2 canvas) {
    const double side = std::min(canvas.x, canvas.y);
    return {.slop = std::max(3.0, side / 60), .fast = side * 0.9};
}

void Gestures::handle_input(const InputEvent& event) {
    std::visit([this](const auto& one) { handle(one); }, event);
}

std::vector<Gesture> Gestures::next_gestures(std::chrono::nanoseconds now) {
    recognise_hold(now);
    return std::exchange(gestures_, {});
}

void Gestures::handle(const Contact& contact) {
    recognise_hold(contact.time);
    switch (contact.kind) {
    case Contact::Kind::down:
        return put_down(contact);
    case Contact::Kind::move:
        return move(contact);
    case Contact::Kind::up:
    case Contact::Kind::cancel:
        return lift(contact);
    }
}

void Gestures::handle(const Wheel& wheel) {
    gestures_.push_back({.kind = Gesture::Kind::wheel,
                         .at = wheel.at,
                         .from = wheel.at,
                         .factor = std::pow(rules_.notch, wheel.notches)});
}

void Gestures::handle(const KeyPress& press) {
    gestures_.push_back({.kind = Gesture::Kind::key, .key = press.key});
}

void Gestures::put_down(const Contact& contact) {
    if (fingers_.size() >= max_fingers || fingers_.contains(contact.finger)) return;
    const Finger finger{
        .from = contact.at, .at = contact.at, .since = contact.time, .trail = {{contact.at, contact.time}}};
    if (fingers_.empty()) {
        state_ = State::pressed;
    } else if (state_ != State::over) {
        end_hold_or_drag(fingers_.begin()->second, contact.time, false);
        state_ = State::pinching;
    }
    fingers_.emplace(contact.finger, finger);
    middle_ = middle();
    spread_ = spread();
}

void Gestures::move(const Contact& contact) {
    const auto found = fingers_.find(contact.finger);
    if (found == fingers_.end()) return;
    Finger& finger = found->second;
    const Vec2 before = std::exchange(finger.at, contact.at);
    finger.trail.push_back({contact.at, contact.time});
    while (finger.trail.size() > 2 && contact.time - finger.trail.front().time > rules_.trail)
        finger.trail.pop_front();
    if (state_ == State::pinching) return pinch();
    if (state_ != State::over) drag(finger, before);
}

void Gestures::drag(Finger& finger, Vec2 before) {
    if (state_ != State::dragging) {
        if (length(finger.at - finger.from) < rules_.slop) return;
        state_ = State::dragging;
        before = finger.from;
    }
    gestures_.push_back(
        {.kind = Gesture::Kind::drag, .at = finger.at, .from = finger.from, .moved = finger.at - before});
}

void Gestures::pinch() {
    const Vec2 before = std::exchange(middle_, middle());
    const double apart = std::exchange(spread_, spread());
    gestures_.push_back({.kind = Gesture::Kind::pinch,
                         .at = middle_,
                         .from = fingers_.begin()->second.from,
                         .moved = middle_ - before,
                         .factor = spread_ / apart});
}

void Gestures::lift(const Contact& contact) {
    const auto found = fingers_.find(contact.finger);
    if (found == fingers_.end()) return;
    if (state_ == State::pinching)
        gestures_.push_back({.kind = Gesture::Kind::pinch_end, .at = middle_, .from = middle_});
    else if (state_ == State::pressed && contact.kind == Contact::Kind::up)
        tap(found->second, contact.time);
    else
        end_hold_or_drag(found->second, contact.time, contact.kind == Contact::Kind::up);
    fingers_.erase(found);
    state_ = fingers_.empty() ? State::idle : State::over;
}

void Gestures::tap(const Finger& finger, std::chrono::nanoseconds time) {
    Gesture gesture{.kind = Gesture::Kind::tap, .at = finger.at, .from = finger.from};
    gestures_.push_back(gesture);
    const bool is_second = tapped_ && finger.since - tapped_->time <= rules_.twice &&
                           length(finger.at - tapped_->at) <= 3 * rules_.slop;
    tapped_ = Point{finger.at, time};
    if (!is_second) return;
    tapped_.reset();
    gesture.kind = Gesture::Kind::double_tap;
    gestures_.push_back(gesture);
}

/// Ends the hold or the drag of a finger.
void Gestures::end_hold_or_drag(const Finger& finger, std::chrono::nanoseconds time, bool may_flick) {
    if (state_ == State::holding)
        gestures_.push_back({.kind = Gesture::Kind::release, .at = finger.at, .from = finger.from});
    if (state_ != State::dragging) return;
    const Vec2 speed = velocity(finger, time);
    const bool is_flick = may_flick && length(speed) >= rules_.fast;
    gestures_.push_back({.kind = is_flick ? Gesture::Kind::flick : Gesture::Kind::drop,
                         .at = finger.at,
                         .from = finger.from,
                         .velocity = is_flick ? speed : Vec2{}});
}

void Gestures::recognise_hold(std::chrono::nanoseconds now) {
    if (state_ != State::pressed) return;
    const Finger& finger = fingers_.begin()->second;
    if (now - finger.since < rules_.hold) return;
    state_ = State::holding;
    gestures_.push_back({.kind = Gesture::Kind::hold, .at = finger.at, .from = finger.from});
}

/// The speed in the last moment before `now`, px a second; 0 if the finger has stopped since.
Vec2 Gestures::velocity(const Finger& finger, std::chrono::nanoseconds now) const {
    if (now - finger.trail.back().time > rules_.trail) return {};
    const double passed =
        std::chrono::duration<double>(finger.trail.back().time - finger.trail.front().time).count();
    if (passed <= 0) return {};
    return (finger.trail.back().at - finger.trail.front().at) * (1 / passed);
}

Vec2 Gestures::middle() const {
    Vec2 sum;
    for (const auto& [number, finger] : fingers_)
        sum = sum + finger.at;
    return sum * (1.0 / static_cast<double>(fingers_.size()));
}

double Gestures::spread() const {
    if (fingers_.size() < max_fingers) return min_spread;
    return std::max(min_spread, length(fingers_.begin()->second.at - fingers_.rbegin()->second.at));
}

}  // namespace vitrine::player
