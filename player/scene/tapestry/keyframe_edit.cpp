#include "player/scene/tapestry/keyframe_edit.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

using std::chrono::nanoseconds;

void KeyframeEdit::touch_picture(nanoseconds keyframe) {
    const bool was_chosen = forget(choice_.keyframes, keyframe);
    const bool was_struck = forget(choice_.struck, keyframe);
    if (!was_chosen && !was_struck) add(choice_.struck, keyframe);
}

void KeyframeEdit::choose(nanoseconds moment) {
    take_back(moment);
    add(choice_.keyframes, moment);
}

void KeyframeEdit::take_back(nanoseconds moment) {
    forget(choice_.keyframes, moment);
    forget(choice_.struck, moment);
}

std::optional<KeyframeChoice> KeyframeEdit::take_changed() {
    return std::exchange(has_changed_, false) ? std::optional(choice_) : std::nullopt;
}

/// True: there was one.
bool KeyframeEdit::forget(std::vector<nanoseconds>& moments, nanoseconds beside) {
    const bool had = std::erase_if(moments, [&](nanoseconds moment) {
                         return std::chrono::abs(moment - beside) <= strike_reach;
                     }) > 0;
    has_changed_ = has_changed_ || had;
    return had;
}

void KeyframeEdit::add(std::vector<nanoseconds>& moments, nanoseconds moment) {
    if (moments.size() == max_moments_of_a_choice) return;
    moments.insert(std::ranges::lower_bound(moments, moment), moment);
    has_changed_ = true;
}

}  // namespace vitrine::player
