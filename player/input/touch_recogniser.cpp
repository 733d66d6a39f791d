#include "player/input/touch_recogniser.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double min_spread = 1;        // px between two fingers
constexpr std::size_t max_fingers = 2;  // more fingers on one subject are a palm

}  // namespace

void TouchRecogniser::put_down(const Contact& contact, std::vector<Gesture>& gestures) {
    if (fingers_.size() >= max_fingers || fingers_.contains(contact.finger)) return;
    if (fingers_.empty()) {
        state_ = State::pressed;
    } else {
        const Finger& first = fingers_.begin()->second;
        if (state_ == State::holding) gestures.push_back(gesture(Gesture::Kind::release, first));
        if (state_ == State::dragging) gestures.push_back(gesture(Gesture::Kind::drop, first));
        state_ = State::pinching;
    }
    const Point point{contact.at, contact.time};
    fingers_.emplace(contact.finger, Finger{.from = contact.at,
                                            .at = contact.at,
                                            .since = contact.time,
                                            .rested = point,
                                            .trail = {point},
                                            .is_told = contact.is_told});
    middle_ = middle();
    spread_ = spread();
}

void TouchRecogniser::move(const Contact& contact, std::vector<Gesture>& gestures) {
    const auto found = fingers_.find(contact.finger);
    if (found == fingers_.end()) return;
    recognise_hold(contact.time, gestures);
    const Vec2 before = found->second.at;
    follow(found->second, contact);
    if (state_ == State::pinching) return pinch(gestures);
    drag(found->second, before, gestures);
}

void TouchRecogniser::follow(Finger& finger, const Contact& contact) const {
    finger.at = contact.at;
    if (length(contact.at - finger.rested.at) >= rules_.slop) finger.rested = {contact.at, contact.time};
    finger.trail.push_back({contact.at, contact.time});
    while (finger.trail.size() > 2 && contact.time - finger.trail.front().time > rules_.trail)
        finger.trail.pop_front();
}

void TouchRecogniser::drag(Finger& finger, Vec2 before, std::vector<Gesture>& gestures) {
    if (state_ != State::dragging) {
        if (length(finger.at - finger.from) < rules_.slop) return;
        state_ = State::dragging;
        before = finger.from;
    }
    gestures.push_back(gesture(Gesture::Kind::drag, finger));
    gestures.back().moved = finger.at - before;
}

void TouchRecogniser::pinch(std::vector<Gesture>& gestures) {
    const Vec2 before = std::exchange(middle_, middle());
    const double apart = std::exchange(spread_, spread());
    gestures.push_back(gesture(Gesture::Kind::pinch, fingers_.begin()->second));
    gestures.back().at = middle_;
    gestures.back().moved = middle_ - before;
    gestures.back().factor = spread_ / apart;
}

void TouchRecogniser::lift(const Contact& contact, std::vector<Gesture>& gestures) {
    const auto found = fingers_.find(contact.finger);
    if (found == fingers_.end()) return;
    if (contact.kind == Contact::Kind::up) recognise_hold(contact.time, gestures);
    end(found->second, contact, gestures);
    fingers_.erase(found);
    if (fingers_.empty()) return;
    state_ = State::left;
    Finger& other = fingers_.begin()->second;
    other.from = other.at;
}

/// Ends the gesture of a finger that is lifted or lost.
void TouchRecogniser::end(const Finger& finger, const Contact& contact,
                          std::vector<Gesture>& gestures) const {
    using Kind = Gesture::Kind;
    const bool is_lifted = contact.kind == Contact::Kind::up;
    switch (state_) {
    case State::pressed:
        if (is_lifted) gestures.push_back(gesture(Kind::tap, finger));
        return;
    case State::holding:
        return gestures.push_back(gesture(is_lifted ? Kind::release : Kind::lost, finger));
    case State::dragging: {
        const Vec2 speed = velocity(finger, contact.time);
        const bool is_flick = is_lifted && length(speed) >= rules_.fast;
        gestures.push_back(gesture(is_flick ? Kind::flick : is_lifted ? Kind::drop : Kind::lost, finger));
        if (is_flick) gestures.back().velocity = speed;
        return;
    }
    case State::pinching:
        gestures.push_back(gesture(Kind::pinch_end, finger));
        gestures.back().at = gestures.back().from = middle_;
        return;
    case State::left:
        return;
    }
}

void TouchRecogniser::advance(std::chrono::nanoseconds now, std::vector<Gesture>& gestures) {
    if (has_fingers() && !fingers_.begin()->second.is_told) recognise_hold(now, gestures);
    const auto rests = [&](const auto& entry) { return now - entry.second.rested.time >= rules_.rest; };
    for (auto found = std::ranges::find_if(fingers_, rests); found != fingers_.end();
         found = std::ranges::find_if(fingers_, rests))
        lift({.kind = Contact::Kind::cancel, .finger = found->first, .time = now}, gestures);
}

/// Turns a press into a hold once it has lasted long enough. @param known  the finger still touched then
void TouchRecogniser::recognise_hold(std::chrono::nanoseconds known, std::vector<Gesture>& gestures) {
    if (state_ != State::pressed || known - fingers_.begin()->second.since < rules_.hold) return;
    state_ = State::holding;
    gestures.push_back(gesture(Gesture::Kind::hold, fingers_.begin()->second));
}

Gesture TouchRecogniser::gesture(Gesture::Kind kind, const Finger& finger) const {
    return {.kind = kind, .touch = number_, .subject = subject_, .at = finger.at, .from = finger.from};
}

/// The speed in the last moment before `now`, px a second; 0 if the finger has stopped since.
Vec2 TouchRecogniser::velocity(const Finger& finger, std::chrono::nanoseconds now) const {
    if (now - finger.trail.back().time > rules_.trail) return {};
    const double passed =
        std::chrono::duration<double>(finger.trail.back().time - finger.trail.front().time).count();
    if (passed <= 0) return {};
    return (finger.trail.back().at - finger.trail.front().at) * (1 / passed);
}

Vec2 TouchRecogniser::middle() const {
    Vec2 sum;
    for (const auto& [number, finger] : fingers_)
        sum = sum + finger.at;
    return sum * (1.0 / static_cast<double>(fingers_.size()));
}

double TouchRecogniser::spread() const {
    if (fingers_.size() < max_fingers) return min_spread;
    return std::max(min_spread, length(fingers_.begin()->second.at - fingers_.rbegin()->second.at));
}

}  // namespace vitrine::player
