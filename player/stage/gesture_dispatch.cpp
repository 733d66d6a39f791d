#include "player/stage/gesture_dispatch.hpp"

#include <array>
#include <optional>
#include <utility>
#include <variant>

namespace vitrine::player {

namespace {

constexpr auto wish_time = std::chrono::seconds(2);  // then a wish for a tapestry is forgotten
constexpr double parted_enough = 1.25;               // factor of a pinch that opens a tapestry

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
    open_wanted(now);
}

bool GestureDispatch::give_to_tapestry(const Gesture& gesture) {
    if (shows_.tapestry() == nullptr) return false;
    shows_.tapestry()->handle_gesture(gesture);
    return true;
}

/// Two fingers that part on a film, or two taps on it, open its tapestry if there is one. The first tap has
/// changed the wall already, so the tapestry may have to wait a moment.
bool GestureDispatch::open_tapestry(const Gesture& gesture) {
    if (gesture.kind == Gesture::Kind::pinch_end) parted_.erase(gesture.touch);
    const bool is_pinch = gesture.kind == Gesture::Kind::pinch && gesture.subject != no_subject;
    const double parted =
        is_pinch ? parted_.try_emplace(gesture.touch, 1).first->second *= gesture.factor : 1;
    if (gesture.kind != Gesture::Kind::double_tap && parted < parted_enough) return false;
    const std::optional<SeenShot> shot = shows_.wall().shot_at(gesture.at);
    if (!shot) return false;
    const RecordList::Record film = files_.all().find(shot->key.path);
    if (!film) return false;
    const auto number = static_cast<std::size_t>(shot->key.shot);
    const Wish wish{.film = film, .shot = number, .at = gesture.at, .since = {}};
    const Opening opening = open(wish);
    if (opening == Opening::later) wish_ = wish;
    return opening != Opening::never;
}

/// Opens the tapestry that a visitor waits for, as soon as that may be.
void GestureDispatch::open_wanted(std::chrono::nanoseconds now) {
    if (!wish_) return;
    if (!wish_->since) wish_->since = now;
    const bool is_over = now - *wish_->since > wish_time || shows_.tapestry() != nullptr;
    if (is_over || open(*wish_) != Opening::later) wish_.reset();
}

/// Opens a tapestry. A key lets a shot return that one of the taps has made large, so that none is large
/// above the wall once the tapestry is closed.
Opening GestureDispatch::open(const Wish& wish) {
    const Opening opening = shows_.open_tapestry(wish.film, wish.shot, wish.at);
    if (opening == Opening::opened)
        shows_.wall().handle_gesture({.kind = Gesture::Kind::key, .key = Key::select});
    return opening;
}

bool GestureDispatch::give_to_wall(const Gesture& gesture) {
    shows_.wall().handle_gesture(gesture);
    return true;
}

}  // namespace vitrine::player
