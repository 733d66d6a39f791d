#include "player/scene/tapestry/coming_strip.hpp"

#include "player/scene/crossfade.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr auto strip_fade = std::chrono::milliseconds(300);

}  // namespace

void ComingStrip::advance(nanoseconds now, const TapestryPlace& shown, const TapestryView& view) {
    const TapestryPlace place(strip_.tapestry(), shown.box(), shown.screen());
    view_ = view_like(place, shown, view);
    strip_.want_seen(place, view_);
    if (!began_ && strip_.missing(false).empty()) began_ = now;
}

bool ComingStrip::is_there(nanoseconds now) const {
    return began_ && now - *began_ >= strip_fade;
}

std::optional<OverlaidStrip> ComingStrip::drawn(nanoseconds now) const {
    if (!began_) return std::nullopt;
    const double progress =
        std::chrono::duration<double>(now - *began_) / std::chrono::duration<double>(strip_fade);
    return OverlaidStrip{.tapestry = &strip_.tapestry(),
                         .tiles = &strip_.tiles(),
                         .view = view_,
                         .sources = strip_.sources(),
                         .alpha = eased(progress)};
}

}  // namespace vitrine::player
