#pragma once

#include "player/scene/tapestry/film_spans.hpp"
#include "player/scene/tapestry/scrubbed_picture.hpp"
#include "player/scene/tapestry/tapestry_moment.hpp"

#include <chrono>
#include <optional>

namespace vitrine::player {

/// The parts of the film that are shown beside a tapestry's strip: one plays in the preview above it, which
/// the next one follows without a gap; one plays in place, within the strip; and while a finger looks for a
/// moment, its picture stands in the preview. Knows no clock.
class TapestryPreview {
  public:
    /// @param spans  outlives this
    explicit TapestryPreview(FilmSpans& spans) : spans_(spans), scrubbed_(spans) {}

    /// Plays the film from this time above the strip, as soon as the source is ready.
    /// @param width  px of the picture within its bars
    void play(std::chrono::nanoseconds from, double width);

    void play_in_place(const FilmSpan& span, double width);

    /// Prepares the next span of the preview in time, and shows it once the last one has ended.
    void play_on(std::chrono::nanoseconds now, double width);

    /// Shows the film's picture at this moment above the strip, as soon as there is one. Call with each frame
    /// while a finger looks for it; play() or stop_preview() ends that.
    void look_at(std::chrono::nanoseconds moment, double width);

    /// Plays what plays on another box, at the same time. Above the strip kept frames are drawn for what
    /// cannot be played.
    /// @param seen         in this show's time
    /// @param width        px of the picture within its bars, above the strip
    /// @param brick_width  the same in place
    void follow(const TapestryMoment& seen, std::chrono::nanoseconds now, double width, double brick_width);

    /// Closes the preview. A span that was requested to play in place still starts.
    void stop_preview();

    void stop_in_place();

    /// Call when the canvas has changed: drops the spans that were requested for another size.
    void stop_outdated();

    void stop_all();

    void source_ready(SourceId source);
    void source_failed(SourceId source);

    /// Starts the spans whose sources are ready, with this frame.
    void start_ready(std::chrono::nanoseconds now);

    /// The span above the strip; none: the preview is closed.
    const std::optional<PlayingSpan>& above() const { return above_; }

    /// Time since the start of the span above. It stops just before the span's end if another span follows,
    /// and at the film's end.
    /// @pre the span above has started
    std::chrono::nanoseconds time_above(std::chrono::nanoseconds now) const;

    /// The film's time that the preview shows; none: the preview is closed.
    std::optional<std::chrono::nanoseconds> playhead(std::chrono::nanoseconds now) const;

    /// The time at which the film has come to its end above the strip; none: it has not.
    std::optional<std::chrono::nanoseconds> ended(std::chrono::nanoseconds now) const;

    /// The film's time from which play() was asked for; none: nothing is awaited.
    std::optional<std::chrono::nanoseconds> awaited() const;

    const std::optional<PlayingSpan>& in_place() const { return in_place_; }

    const ScrubbedPicture& scrubbed() const { return scrubbed_; }

  private:
    FilmSpans& spans_;  // outlives this
    std::optional<PlayingSpan> above_;
    std::optional<PlayingSpan> next_above_;  // replaces above_ once it is ready
    std::optional<PlayingSpan> in_place_;
    ScrubbedPicture scrubbed_;
};

}  // namespace vitrine::player
