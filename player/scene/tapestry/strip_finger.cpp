#include "player/scene/tapestry/strip_finger.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr double closing_pinch = 0.75;  // factor of a pinch at the coarsest level that closes the tapestry
constexpr double grip = 0.04;           // share of the screen's height: a finger so near to the line takes it
constexpr double edge = 0.08;           // share of the strip's width in which it comes towards the finger
constexpr double edge_speed = 0.8;      // of its width a second, at the very edge

bool contains(const Box& box, Vec2 point) {
    return point.x >= box.min.x && point.x <= box.max.x && point.y >= box.min.y && point.y <= box.max.y;
}

/// True for the strip and what is below it on its screen.
bool is_on_strip(const Gesture& gesture, const TouchedStrip& strip) {
    return gesture.from.y >= strip.boxes.strip.min.y && gesture.from.y <= strip.boxes.room.screen.max.y;
}

/// The way that the strip comes towards a finger near an edge, canvas px to the right.
double way_at_edge(double x, const Box& box, nanoseconds passed) {
    const double room = edge * box.width();
    const double depth = std::max(0.0, box.min.x + room - x) - std::max(0.0, x - (box.max.x - room));
    const double speed = std::clamp(depth / room, -1.0, 1.0) * edge_speed * box.width();
    return speed * std::chrono::duration<double>(passed).count();
}

/// The chosen or struck moment whose mark is nearest to a place, within reach.
std::optional<nanoseconds> mark_at(double x, const TapestryPlace& place, const TapestryView& view,
                                   const KeyframeChoice& choice, double reach) {
    std::optional<nanoseconds> nearest;
    for (const auto* moments : {&choice.keyframes, &choice.struck}) {
        for (const nanoseconds moment : *moments) {
            const double away = std::abs(place.canvas_x(view, moment) - x);
            if (away > reach) continue;
            reach = away;
            nearest = moment;
        }
    }
    return nearest;
}

}  // namespace

void StripFinger::handle_gesture(const Gesture& gesture, const TouchedStrip& strip) {
    switch (gesture.kind) {
    case Gesture::Kind::tap:
        strip.motion.handle_gesture(gesture, strip.place);
        return tap(gesture, strip);
    case Gesture::Kind::hold:
        has_rested_ = true;
        if (is_on_strip(gesture, strip)) play_in_place(gesture.at, strip);
        break;
    case Gesture::Kind::drag:
        if (is_on_strip(gesture, strip)) return drag(gesture, strip);
        break;
    case Gesture::Kind::drop:
    case Gesture::Kind::flick:
    case Gesture::Kind::lost:
        return let_go(gesture, strip);
    case Gesture::Kind::key:
        press(gesture.key, strip);
        break;
    case Gesture::Kind::pinch:
        pinch(gesture, strip);
        break;
    case Gesture::Kind::pinch_end:
        pinched_ = 1;
        break;
    case Gesture::Kind::release:
        has_rested_ = false;
        break;
    default:
        break;
    }
    strip.motion.handle_gesture(gesture, strip.place);
}

void StripFinger::press(Key key, const TouchedStrip& strip) {
    if (key == Key::back) has_closed_ = true;
    if (key != Key::select) return;
    has_chosen_ = true;
    standing_.reset();
    strip.preview.play(strip.motion.view().centre, strip.boxes.preview.width());
}

/// On the strip a tap plays the picture there, on the preview it closes the preview, elsewhere the tapestry.
void StripFinger::tap(const Gesture& tap, const TouchedStrip& strip) {
    if (strip.edit != nullptr) return edit(tap, strip);
    if (is_on_strip(tap, strip)) {
        has_chosen_ = true;
        const StripPicture picture = strip.place.picture_at(strip.motion.view(), tap.at);
        strip.preview.play(picture.time, strip.boxes.preview.width());
        return play_in_place(tap.at, strip);
    }
    if (!strip.preview.above() || !contains(strip.boxes.preview, tap.at)) has_closed_ = true;
    strip.preview.stop_preview();
}

void StripFinger::edit(const Gesture& tap, const TouchedStrip& strip) {
    const TapestryView& view = strip.motion.view();
    if (is_on_strip(tap, strip) && tap.at.y > strip.boxes.strip.max.y) {
        const KeyframeChoice& choice = strip.edit->choice();
        const auto mark =
            mark_at(tap.at.x, strip.place, view, choice, grip * strip.boxes.room.screen.height());
        if (mark) strip.edit->take_back(*mark);
    } else if (is_on_strip(tap, strip)) {
        has_chosen_ = true;
        strip.edit->touch_picture(strip.place.picture_at(view, tap.at).time);
    } else if (contains(strip.boxes.preview, tap.at)) {
        if (!shown_) return;
        has_chosen_ = true;
        strip.edit->choose(*shown_);
        standing_.reset();
        strip.preview.play(strip.spans.possible_begin(*shown_), strip.boxes.preview.width());
    } else {
        has_closed_ = true;
        strip.preview.stop_preview();
    }
}

void StripFinger::play_in_place(Vec2 at, const TouchedStrip& strip) {
    touched_ = strip.place.picture_at(strip.motion.view(), at);
    const Box brick = strip.place.brick(strip.motion.view(), touched_, strip.spans.film().picture);
    strip.preview.play_in_place(strip.spans.span_in_place(touched_.time), brick.width());
}

void StripFinger::drag(const Gesture& drag, const TouchedStrip& strip) {
    if (!dragged_to_) goes_over_strip_ = goes_over(drag, strip);
    dragged_to_ = drag.at;
    standing_.reset();
    has_chosen_ = true;
    strip.preview.stop_in_place();
    Gesture moving = drag;
    if (goes_over_strip_) moving.moved = {};
    strip.motion.handle_gesture(moving, strip.place);
}

bool StripFinger::goes_over(const Gesture& drag, const TouchedStrip& strip) const {
    const bool is_whole = strip.place.width(strip.motion.view().level) <= strip.boxes.strip.width() + 1;
    const bool takes_line =
        line_x_ && std::abs(drag.from.x - *line_x_) <= grip * strip.boxes.room.screen.height();
    return has_rested_ || is_whole || takes_line;
}

void StripFinger::let_go(const Gesture& end, const TouchedStrip& strip) {
    Gesture last = end;
    if (dragged_to_) {
        if (goes_over_strip_) last.kind = Gesture::Kind::drop;
        const nanoseconds moment =
            strip.spans.possible_begin(strip.place.time_at(strip.motion.view(), dragged_to_->x));
        if (strip.edit != nullptr)
            standing_ = moment;
        else
            strip.preview.play(moment, strip.boxes.preview.width());
    }
    strip.motion.handle_gesture(last, strip.place);
    dragged_to_.reset();
    has_rested_ = false;
}

void StripFinger::pinch(const Gesture& pinch, const TouchedStrip& strip) {
    strip.preview.stop_in_place();
    pinched_ = strip.motion.view().level > 0 ? 1 : pinched_ * pinch.factor;
    if (pinched_ < closing_pinch) has_closed_ = true;
}

void StripFinger::advance(nanoseconds now, const TouchedStrip& strip) {
    const nanoseconds passed = last_ ? now - *last_ : nanoseconds(0);
    last_ = now;
    if (dragged_to_) {
        if (goes_over_strip_)
            strip.motion.handle_gesture(
                {.kind = Gesture::Kind::drag,
                 .moved = {way_at_edge(dragged_to_->x, strip.boxes.strip, passed), 0}},
                strip.place);
        strip.preview.look_at(strip.place.time_at(strip.motion.view(), dragged_to_->x),
                              strip.boxes.preview.width());
    } else if (standing_) {
        strip.preview.look_at(*standing_, strip.boxes.preview.width());
    }
    shown_ = strip.preview.playhead(now);
    line_x_.reset();
    if (shown_) line_x_ = strip.place.canvas_x(strip.motion.view(), *shown_);
}

}  // namespace vitrine::player
