#include "player/input/gestures.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr std::size_t max_contacts = 10;  // followed at the same time

}  // namespace

GestureRules gesture_rules(Vec2 canvas) {
    const double side = std::min(canvas.x, canvas.y);
    return {.slop = std::max(3.0, side / 60), .fast = side * 0.9};
}

void Gestures::handle_input(const InputEvent& event, Subject subject) {
    std::visit([&](const auto& one) { handle(one, subject); }, event);
}

std::vector<Gesture> Gestures::next_gestures(std::chrono::nanoseconds now) {
    advance(now);
    return std::exchange(gestures_, {});
}

void Gestures::handle(const Contact& contact, Subject subject) {
    advance(contact.time);
    if (contact.kind == Contact::Kind::down) return put_down(contact, subject);
    const auto found = fingers_.find(contact.finger);
    if (found == fingers_.end()) return;
    TouchRecogniser& touch = touches_.at(found->second.owner);
    if (contact.kind == Contact::Kind::move) return touch.move(contact, gestures_);
    const std::size_t before = gestures_.size();
    touch.lift(contact, gestures_);
    if (gestures_.size() > before && gestures_.back().kind == Gesture::Kind::tap)
        find_double_tap(found->second.since, contact.time);
    drop_lifted();
}

void Gestures::handle(const Wheel& wheel, Subject subject) {
    gestures_.push_back({.kind = Gesture::Kind::wheel,
                         .subject = subject,
                         .at = wheel.at,
                         .from = wheel.at,
                         .factor = std::pow(rules_.notch, wheel.notches)});
}

void Gestures::handle(const KeyPress& press, Subject /*subject*/) {
    gestures_.push_back({.kind = Gesture::Kind::key, .key = press.key});
}

void Gestures::put_down(const Contact& contact, Subject subject) {
    if (fingers_.contains(contact.finger))  // its release was lost
        handle(Contact{.kind = Contact::Kind::cancel, .finger = contact.finger, .time = contact.time},
               subject);
    if (fingers_.size() >= max_contacts) return;
    const Owner owner{subject, subject == no_subject ? contact.finger : 0};
    const auto found = touches_.find(owner);
    TouchRecogniser& touch =
        found != touches_.end()
            ? found->second
            : touches_.emplace(owner, TouchRecogniser(rules_, subject, ++last_touch_)).first->second;
    touch.put_down(contact, gestures_);
    if (touch.has_finger(contact.finger)) fingers_[contact.finger] = {owner, contact.time};
}

/// Notes a tap that was just recognised, and adds a double tap if it is the second one.
/// @param since, now  when the finger came down and when it was lifted
void Gestures::find_double_tap(std::chrono::nanoseconds since, std::chrono::nanoseconds now) {
    std::erase_if(taps_, [&](const Tap& tap) { return since - tap.time > rules_.twice; });
    Gesture gesture = gestures_.back();
    const auto first = std::ranges::find_if(
        taps_, [&](const Tap& tap) { return length(gesture.at - tap.at) <= 3 * rules_.slop; });
    if (first == taps_.end()) return taps_.push_back({gesture.at, now});
    taps_.erase(first);
    gesture.kind = Gesture::Kind::double_tap;
    gestures_.push_back(gesture);
}

void Gestures::advance(std::chrono::nanoseconds now) {
    for (auto& [owner, touch] : touches_)
        touch.advance(now, gestures_);
    drop_lifted();
}

void Gestures::drop_lifted() {
    std::erase_if(fingers_, [&](const auto& entry) {
        return !touches_.at(entry.second.owner).has_finger(entry.first);
    });
    std::erase_if(touches_, [](const auto& entry) { return !entry.second.has_fingers(); });
}

}  // namespace vitrine::player
