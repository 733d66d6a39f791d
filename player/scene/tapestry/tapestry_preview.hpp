#pragma once

#include "player/scene/shot_request.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// The data of a film that are needed to play its parts.
struct PreviewedFilm {
    std::string path;  // relative to the media folder
    std::chrono::nanoseconds duration{0};
    Vec2 picture;                // size of the upright picture within its bars, px; only its shape counts
    Box active{{0, 0}, {1, 1}};  // that part of the whole picture, in shares of its sides
    std::vector<Shot> shots;     // the shots of the film's record; none: they are not known
};

/// The size of the whole picture, with its bars, if the picture within them has this size.
inline Vec2 whole_picture(const PreviewedFilm& film, Vec2 active) {
    return {active.x / film.active.width(), active.y / film.active.height()};
}

/// A part of the film, half-open [begin, end).
struct FilmSpan {
    std::chrono::nanoseconds begin{0};
    std::chrono::nanoseconds end{0};

    std::chrono::nanoseconds length() const { return end - begin; }
};

/// A part of the film that plays in a loop.
struct PlayingSpan {
    SourceId source = 0;
    FilmSpan span;
    std::optional<std::chrono::nanoseconds> began;  // none: not ready yet; < 0: starts with the next frame
    bool continues = false;                         // it starts when the span before it has ended
};

/// The parts of the film that play beside a tapestry's strip: one in the preview above it, which the next one
/// follows without a gap, and one in place, within the strip. Each is a source of its own. Knows no clock.
class TapestryPreview {
  public:
    /// @param last_source  its sources are numbered from here on
    TapestryPreview(PreviewedFilm film, SourceId last_source);

    const PreviewedFilm& film() const { return film_; }

    /// Call when the film's record has changed: the store may have more of its shots.
    void set_shots(std::vector<Shot> shots) { film_.shots = std::move(shots); }

    /// Plays the film from this time above the strip, as soon as the source is ready.
    /// @param width  px of the picture within its bars
    void play(std::chrono::nanoseconds from, double width);

    /// The span that plays in place after a tap on this time. It lies within one shot, because the next shot
    /// has another place on the tapestry.
    FilmSpan span_in_place(std::chrono::nanoseconds from) const;

    void play_in_place(const FilmSpan& span, double width);

    /// Prepares the next span of the preview in time, and shows it once the last one has ended.
    void play_on(std::chrono::nanoseconds now, double width);

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

    /// Time since the start of the span above. It stops just before the span's end if another span follows.
    /// @pre the span above has started
    std::chrono::nanoseconds time_above(std::chrono::nanoseconds now) const;

    const std::optional<PlayingSpan>& in_place() const { return in_place_; }

    struct Changes {
        std::vector<ShotRequest> requests;
        std::vector<SourceId> retired;
    };

    /// Removes and returns the requests and the retired sources since the last call.
    Changes take_changes();

  private:
    PlayingSpan request(const FilmSpan& wanted, double width);
    void retire(std::optional<PlayingSpan>& playing);

    PreviewedFilm film_;
    SourceId last_source_;
    std::optional<PlayingSpan> above_;
    std::optional<PlayingSpan> next_above_;  // replaces above_ once it is ready
    std::optional<PlayingSpan> in_place_;
    Changes changes_;
};

}  // namespace vitrine::player
