#include "player/stage/gesture_dispatch.hpp"

#include <array>
#include <optional>
#include <utility>
#include <variant>

namespace vitrine::player {

namespace {

constexpr double parted_enough = 1.25;  // factor of a pinch that opens a tapestry

}  // namespace

void GestureDispatch::handle_input(const InputEvent& event) {
    gestures_.handle_input(event, subject_of(event));
}

/// The subject of a finger that comes down, or of a wheel.
Subject GestureDispatch::subject_of(const InputEvent& event) const {
    const auto* contact = std::get_if<Contact>(&event);
    if (contact != nullptr && contact->kind != Contact::Kind::down) return no_subject;
    if (shows_.tapestry() != nullptr) return whole_show;
    const auto place = [](const auto& one) -> std::optional<Vec2> {
        if constexpr (requires { one.at; })
            return one.at;
        else
            return std::nullopt;
    };
    const std::optional<Vec2> at = std::visit(place, event);
    const auto shot = at ? std::as_const(shows_).wall().shot_at(*at) : std::nullopt;
    return shot ? shot->source : no_subject;
}

void GestureDispatch::dispatch(std::chrono::nanoseconds now) {
    using Handler = bool (GestureDispatch::*)(const Gesture&);
    // The handlers are asked in this order. The first one that handles the gesture ends the search.
    static constexpr std::array<Handler, 3> handlers{
        &GestureDispatch::give_to_tapestry, &GestureDispatch::open_tapestry, &GestureDispatch::give_to_wall};
    for (const Gesture& gesture : gestures_.next_gestures(now)) {
        for (const Handler handler : handlers)
            if ((this->*handler)(gesture)) break;
    }
}

bool GestureDispatch::give_to_tapestry(const Gesture& gesture) {
    if (shows_.tapestry() == nullptr) return false;
    shows_.tapestry()->handle_gesture(gesture);
    return true;
}

/// Two fingers that part on a film, or two taps on it, open its tapestry if there is one.
bool GestureDispatch::open_tapestry(const Gesture& gesture) {
    if (gesture.kind == Gesture::Kind::pinch_end) parted_.erase(gesture.touch);
    const bool is_pinch = gesture.kind == Gesture::Kind::pinch && gesture.subject != no_subject;
    const double parted =
        is_pinch ? parted_.try_emplace(gesture.touch, 1).first->second *= gesture.factor : 1;
    if (gesture.kind != Gesture::Kind::double_tap && parted < parted_enough) return false;
    const std::optional<SeenShot> shot = shows_.wall().shot_at(gesture.at);
    if (!shot) return false;
    const RecordList::Record film = files_.all().find(shot->key.path);
    return film && shows_.open_tapestry(film, static_cast<std::size_t>(shot->key.shot));
}

bool GestureDispatch::give_to_wall(const Gesture& gesture) {
    shows_.wall().handle_gesture(gesture);
    return true;
}

}  // namespace vitrine::player
