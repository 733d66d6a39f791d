#include "player/scene/pan/pan_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds max_step = 100ms;  // longer pauses are not made up for
constexpr double fling_time = 0.6;                    // seconds until a fling has a third of its speed
constexpr std::chrono::nanoseconds back_time = 30s;   // after a drag, in which the view may go back

}  // namespace

void PanMotion::handle_gesture(const Gesture& gesture) {
    using Kind = Gesture::Kind;
    const bool is_mine = touch_ == 0 || touch_ == gesture.touch;
    if (!is_mine) return;
    if (gesture.kind == Kind::drag) {
        dragged_ -= touch_ == 0 ? gesture.at.x - gesture.from.x : gesture.moved.x;
        touch_ = gesture.touch;
        flung_ = 0;
        last_drag_ = last_;
    } else if (gesture.kind == Kind::drop || gesture.kind == Kind::flick || gesture.kind == Kind::lost) {
        if (touch_ != 0 && gesture.kind == Kind::flick) flung_ = -gesture.velocity.x;
        touch_ = 0;
    }
}

double PanMotion::next_way(std::chrono::nanoseconds now) {
    const auto passed = std::min<std::chrono::nanoseconds>(now - last_.value_or(now), max_step);
    last_ = now;
    const double seconds = std::chrono::duration<double>(passed).count();
    double way = std::exchange(dragged_, 0);
    if (touch_ != 0) return way;
    const double kept = std::exp(-seconds / fling_time);
    way += flung_ * fling_time * (1 - kept);
    flung_ *= kept;
    if (std::abs(flung_) < 1) flung_ = 0;
    return way + (is_paused_ ? 0 : speed_ * seconds);
}

void PanMotion::stop() {
    touch_ = 0;
    dragged_ = flung_ = 0;
}

bool PanMotion::may_go_back(std::chrono::nanoseconds now) const {
    return touch_ != 0 || (last_drag_ && now - *last_drag_ < back_time);
}

}  // namespace vitrine::player
