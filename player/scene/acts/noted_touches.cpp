#include "player/scene/acts/noted_touches.hpp"

#include "player/input/touch_recogniser.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>

namespace vitrine::player {

namespace {

constexpr std::size_t max_moves = 200;  // between two calls; then only other touches are noted
constexpr std::size_t max_touches = 2 * max_moves;
constexpr auto move_pause = std::chrono::milliseconds(40);  // of a finger's moves in it, the last is told

bool has_contact_of(std::span<const InputEvent> events, int finger) {
    return std::ranges::any_of(events, [finger](const InputEvent& event) {
        const auto* const contact = std::get_if<Contact>(&event);
        return contact != nullptr && contact->finger == finger;
    });
}

}  // namespace

void NotedTouches::note(const InputEvent& event) {
    const auto* const contact = std::get_if<Contact>(&event);
    auto* const last = touches_.empty() ? nullptr : std::get_if<Contact>(&touches_.back());
    const bool is_move = contact != nullptr && contact->kind == Contact::Kind::move;
    if (is_move && last != nullptr && last->kind == Contact::Kind::move && last->finger == contact->finger &&
        last->time / move_pause == contact->time / move_pause)
        *last = *contact;
    else if (touches_.size() < (is_move ? max_moves : max_touches))
        touches_.push_back(event);
    if (contact != nullptr) follow(*contact);
}

void NotedTouches::follow(const Contact& contact) {
    if (contact.kind == Contact::Kind::down || contact.kind == Contact::Kind::move)
        fingers_[contact.finger] = contact;
    else
        fingers_.erase(contact.finger);
}

std::vector<InputEvent> NotedTouches::take(std::chrono::nanoseconds now) {
    std::vector<InputEvent> touches = std::exchange(touches_, {});
    for (const auto& [finger, last] : fingers_) {
        const bool rests = now > last.time && now - last.time <= GestureRules{}.rest;
        if (!rests || has_contact_of(touches, finger)) continue;
        touches.emplace_back(
            Contact{.kind = Contact::Kind::move, .finger = finger, .at = last.at, .time = now});
    }
    return touches;
}

}  // namespace vitrine::player
