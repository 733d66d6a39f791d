#pragma once

#include "player/scene/shot_request.hpp"

#include <chrono>
#include <deque>
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

    bool contains(std::chrono::nanoseconds time) const { return time >= begin && time < end; }

    bool operator==(const FilmSpan&) const = default;
};

/// A part of the film that plays in a loop.
struct PlayingSpan {
    SourceId source = 0;
    FilmSpan span;
    std::optional<std::chrono::nanoseconds> began;  // none: not ready yet; < 0: starts with the next frame
    bool continues = false;                         // it starts when the span before it has ended
};

/// True: it is there and has a time at which it started.
inline bool has_begun(const std::optional<PlayingSpan>& playing) {
    return playing && playing->began && playing->began->count() >= 0;
}

/// Asks for parts of a film. Each is a source of its own. Any moment can be asked for: within a stored shot
/// it is played from the store, elsewhere (titles, fades, a shot that is not stored) from the film.
class FilmSpans {
  public:
    /// @param last_source  the sources are numbered from here on
    FilmSpans(PreviewedFilm film, SourceId last_source);
    FilmSpans(const FilmSpans&) = delete;
    FilmSpans& operator=(const FilmSpans&) = delete;
    FilmSpans(FilmSpans&&) = delete;
    FilmSpans& operator=(FilmSpans&&) = delete;
    ~FilmSpans() = default;

    const PreviewedFilm& film() const { return film_; }

    /// Call when the film's record has come or has changed: the store may have more of its shots.
    void set_film(PreviewedFilm film) {
        film_ = std::move(film);
        failed_.clear();
    }

    /// The moment nearest to a time from which the film can be played.
    std::chrono::nanoseconds possible_begin(std::chrono::nanoseconds from) const;

    /// Plays from the store alone from now on, because the film itself is on another box.
    void use_store_alone() { has_store_alone_ = true; }

    /// Call when the source of a span has failed.
    void note_failed(const FilmSpan& span);

    /// True if the part from this time on is there, as far as is known.
    bool can_play(std::chrono::nanoseconds from) const;

    /// The span that plays in place from this time on: to the end of its shot, because the next shot has
    /// another place on the tapestry, but no shorter than a second and no longer than four.
    FilmSpan span_in_place(std::chrono::nanoseconds from) const;

    /// Asks for a span from its begin on. In a stored shot it ends with the shot; elsewhere it ends where a
    /// stored shot begins.
    /// @param width  px of the picture within its bars
    PlayingSpan request(const FilmSpan& wanted, double width);

    void retire(std::optional<PlayingSpan>& playing);

    struct Changes {
        std::vector<ShotRequest> requests;
        std::vector<SourceId> retired;
    };

    /// Removes and returns the requests and the retired sources since the last call.
    Changes take_changes();

  private:
    PreviewedFilm film_;
    SourceId last_source_;
    Changes changes_;
    std::deque<FilmSpan> failed_;  // the last ones whose sources have failed
    bool has_store_alone_ = false;
};

}  // namespace vitrine::player
