#pragma once

#include "player/scene/tapestry/film_spans.hpp"

#include <chrono>
#include <optional>

namespace vitrine::player {

/// The film's picture at the moment under a finger that looks through the strip. A source is asked for the
/// moment; while it comes, the finger may go on, and the next source is asked for when it is there: one at a
/// time, however fast the finger is. Until then a frame that the tapestry has kept is drawn.
class ScrubbedPicture {
  public:
    /// @param spans  outlives this
    explicit ScrubbedPicture(FilmSpans& spans) : spans_(spans) {}

    /// The finger is at this moment of the film now. Call with each frame.
    /// @param width  px of the picture within its bars
    void look_at(std::chrono::nanoseconds moment, double width);

    /// The same without a source: the kept frame is drawn.
    void look_at_kept(std::chrono::nanoseconds moment) { moment_ = spans_.possible_begin(moment); }

    /// The moment under the finger; none: nobody looks for one.
    const std::optional<std::chrono::nanoseconds>& moment() const { return moment_; }

    /// The newest sharp picture: the first one of its span. None: there is none yet.
    const std::optional<PlayingSpan>& sharp() const { return sharp_; }

    /// Hands over the span of the sharp picture if it shows this moment; it can be played at once.
    std::optional<PlayingSpan> take(std::chrono::nanoseconds moment);

    /// Ends the looking.
    void stop();

    void source_ready(SourceId source);

    /// @return the span of the source; none: it is not of this picture
    std::optional<FilmSpan> source_failed(SourceId source);

  private:
    FilmSpans& spans_;  // outlives this
    std::optional<std::chrono::nanoseconds> moment_;
    std::optional<PlayingSpan> sharp_;
    std::optional<PlayingSpan> coming_;  // replaces sharp_ once it is ready
};

}  // namespace vitrine::player
