#pragma once

#include "base/hints/keyframe_choice.hpp"
#include "player/scene/tapestry/film_spans.hpp"
#include "player/scene/tapestry/tapestry_view.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace vitrine::player {

/// A part of the film that plays, and the show's time at its begin.
struct SeenSpan {
    FilmSpan span;
    std::chrono::nanoseconds began{0};

    bool operator==(const SeenSpan&) const = default;
};

/// A film's tapestry as it is seen at one moment: all that another box needs to draw the same, beside the
/// files of the film.
struct TapestryMoment {
    std::string path;    // of the film
    std::string folder;  // of its tiles, which is another one each time it is woven; empty: not woven yet
    int levels = 0;      // their number, which grows while it is woven
    TapestryRoom room;
    std::chrono::nanoseconds opened{0};  // the show's time
    TapestryView view;
    double width = 0;                                    // canvas px of the whole film at the view's level
    std::optional<SeenSpan> above;                       // in the preview above the strip
    std::optional<SeenSpan> in_place;                    // within the strip
    StripPicture touched;                                // the picture whose place that is
    std::optional<std::chrono::nanoseconds> looked_for;  // the film's time that a finger looks for
    std::optional<KeyframeChoice> edited;  // its moments have marks; none: keyframes are not edited

    bool operator==(const TapestryMoment&) const = default;
};

/// The moment with all times of the show moved. @param by  from a clock of the show to another clock
TapestryMoment moved(TapestryMoment seen, std::chrono::nanoseconds by);

}  // namespace vitrine::player
