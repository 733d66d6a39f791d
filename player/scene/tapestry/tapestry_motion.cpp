#include "player/scene/tapestry/tapestry_motion.hpp"

#include "player/scene/crossfade.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr double min_speed = 8;  // canvas px per second; a slower strip stops
constexpr double key_way = 0.3;  // share of the box' width
// Shares of the screen's width between which what plays goes through a strip that rests: more is seen of what
// comes.
constexpr double first_stand = 0.1;
constexpr double last_stand = 0.7;

double seconds(nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

/// True: a finger is on the strip after this gesture.
bool is_held_after(Gesture::Kind kind, bool was_held) {
    using Kind = Gesture::Kind;
    if (kind == Kind::hold || kind == Kind::drag || kind == Kind::pinch) return true;
    return was_held && (kind == Kind::wheel || kind == Kind::key);
}

}  // namespace

void TapestryMotion::handle_gesture(const Gesture& gesture, const TapestryPlace& place) {
    touch();
    if (is_held_after(gesture.kind, hold_ == Hold::held))
        hold_ = Hold::held;
    else if (hold_ == Hold::held)
        hold_ = Hold::away;  // until what plays is seen
    switch (gesture.kind) {
    case Gesture::Kind::drag:
        speed_ = 0;
        zoom_.reset();
        view_ = place.moved(view_, gesture.moved.x);
        return;
    case Gesture::Kind::drop:
    case Gesture::Kind::lost:
    case Gesture::Kind::flick:
        if (gesture.kind == Gesture::Kind::flick) speed_ = gesture.velocity.x;
        return settle(gesture.at.x);
    case Gesture::Kind::pinch:
        speed_ = 0;
        zoom_.reset();
        pinched_at_ = gesture.at.x;
        view_ = place.moved(view_, gesture.moved.x);
        view_ =
            place.zoomed(view_, view_.level + place.levels_for(view_.level, gesture.factor), gesture.at.x);
        return;
    case Gesture::Kind::pinch_end:
        return settle(pinched_at_);
    case Gesture::Kind::wheel:
        return zoom_by_one(gesture.factor > 1, gesture.at.x);
    case Gesture::Kind::key:
        if (gesture.key == Key::nearer || gesture.key == Key::farther)
            return zoom_by_one(gesture.key == Key::nearer, place.screen().centre().x);
        if (gesture.key == Key::left || gesture.key == Key::right)
            speed_ =
                (gesture.key == Key::left ? 1 : -1) * key_way * place.box().width() / seconds(pace_.glide);
        return;
    default:
        return;
    }
}

void TapestryMotion::move_to(const TapestryPlace& to, const TapestryPlace& from) {
    const auto level_of = [&](double level) {
        return view_like(to, from, {.centre = view_.centre, .level = level}).level;
    };
    if (zoom_) {
        zoom_->from = level_of(zoom_->from);
        zoom_->to = std::round(level_of(zoom_->to));
    }
    view_ = view_like(to, from, view_);
    if (!zoom_ && hold_ != Hold::held) settle(to.screen().centre().x);
}

void TapestryMotion::zoom_to(double level, double at) {
    zoom_ = Zoom{.from = view_.level, .to = level, .at = at, .began = {}};
}

void TapestryMotion::zoom_by_one(bool is_nearer, double at) {
    zoom_to((zoom_ ? zoom_->to : std::round(view_.level)) + (is_nearer ? 1 : -1), at);
}

/// Starts a zoom to the nearest whole level, which is the sharpest.
void TapestryMotion::settle(double at) {
    if (view_.level != std::round(view_.level)) zoom_to(std::round(view_.level), at);
}

const TapestryView& TapestryMotion::advance(nanoseconds now, const TapestryPlace& place) {
    const nanoseconds passed = last_ ? now - *last_ : nanoseconds(0);
    last_ = now;
    if (!touched_) {
        touched_ = now;
        reached_level_.reset();
    }
    if (!reached_level_ && hold_ != Hold::held && now - *touched_ >= pace_.patience) reached_level_ = now;
    if (reached_level_) go_by_itself(now, passed, place);
    go_on_zooming(now, place);
    glide(passed, place);
    view_ = place.bounded(view_);
    keep_in_view(passed, place);
    return view_;
}

void TapestryMotion::keep_in_view(nanoseconds passed, const TapestryPlace& place) {
    if (!followed_) return;
    const Box& box = place.box();
    const double x = place.canvas_x(view_, *followed_);
    const bool is_seen = x >= box.min.x && x <= box.max.x;
    const bool is_moved = hold_ == Hold::held || speed_ != 0 || (zoom_ && !is_by_itself());
    if (hold_ != Hold::held && (is_moved || is_seen)) hold_ = is_seen ? Hold::free : Hold::away;
    if (is_moved || hold_ == Hold::away) return;
    const Box& screen = place.screen();
    const double beyond = x - std::clamp(x, screen.min.x + first_stand * screen.width(),
                                         screen.min.x + last_stand * screen.width());
    if (beyond != 0)
        view_ = place.moved(view_, -beyond * (1 - std::exp(-seconds(passed) / seconds(pace_.glide))));
}

void TapestryMotion::go_on_zooming(nanoseconds now, const TapestryPlace& place) {
    if (!zoom_) return;
    if (!zoom_->began) {
        zoom_->began = now;
        zoom_->to = std::clamp(zoom_->to, 0.0, place.max_level());
    }
    const double progress = seconds(now - *zoom_->began) / seconds(pace_.zoom);
    const double level =
        progress >= 1 ? zoom_->to : zoom_->from + (zoom_->to - zoom_->from) * eased(progress);
    view_ = place.zoomed(view_, level, zoom_->at);
    if (progress >= 1) zoom_.reset();
}

/// Slows a flung strip down exponentially. It stops at its ends.
void TapestryMotion::glide(nanoseconds passed, const TapestryPlace& place) {
    if (speed_ == 0) return;
    const double time = seconds(pace_.glide);
    const double kept = std::exp(-seconds(passed) / time);
    const TapestryView before = view_;
    view_ = place.moved(view_, speed_ * time * (1 - kept));
    speed_ *= kept;
    const bool stands = view_ == before && passed.count() > 0;
    if (std::abs(speed_) < min_speed || stands) speed_ = 0;
}

void TapestryMotion::go_by_itself(nanoseconds now, nanoseconds passed, const TapestryPlace& place) {
    const TapestryView before = view_;
    view_ = place.moved(view_, -way_ * pace_.drift * place.box().width() * seconds(passed));
    if (view_ == before && passed.count() > 0) way_ = -way_;
    if (zoom_ || now - *reached_level_ < pace_.dwell) return;
    reached_level_ = now;
    const double level = std::round(view_.level) + level_step_;
    if (level < 0 || level > place.max_level()) level_step_ = -level_step_;
    const Box& box = place.box();
    const double at =
        followed_ ? place.canvas_x(view_, *followed_) : place.screen().centre().x;  // stays in view
    zoom_to(std::round(view_.level) + level_step_, std::clamp(at, box.min.x, box.max.x));
}

double TapestryMotion::direction() const {
    if (speed_ != 0) return -speed_;
    return is_by_itself() ? way_ : 0;
}

}  // namespace vitrine::player
