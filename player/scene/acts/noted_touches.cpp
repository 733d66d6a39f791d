#include "player/scene/acts/noted_touches.hpp"

#include <cstddef>
#include <variant>

namespace vitrine::player {

namespace {

constexpr std::size_t max_touches = 200;  // between two calls

}  // namespace

void NotedTouches::note(const InputEvent& event) {
    const auto* const contact = std::get_if<Contact>(&event);
    auto* const last = touches_.empty() ? nullptr : std::get_if<Contact>(&touches_.back());
    if (contact != nullptr && last != nullptr && contact->kind == Contact::Kind::move &&
        last->kind == Contact::Kind::move && last->finger == contact->finger)
        *last = *contact;
    else if (touches_.size() < max_touches)
        touches_.push_back(event);
}

}  // namespace vitrine::player
