#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <optional>
#include <vector>

namespace vitrine::player {

/// A film above its photo as it plays there: all that it is drawn from.
struct FilmMoment {
    WallShot shot;
    Placement placement;
    std::chrono::nanoseconds began = never;  // `never`: it does not play yet
    std::chrono::nanoseconds ends = never;   // it is invisible from then on

    bool operator==(const FilmMoment&) const = default;
};

/// Draws a film above all else in a frame, at the frame's time.
void draw_film(Frame& frame, const FilmMoment& film);

/// The film of a Live Photo or motion photo that a visitor has tapped: it plays once above its photo, while
/// that is as large as the screen. Knows no clock.
class TouchedFilm {
  public:
    /// The photo begins to become large.
    /// @param photo   where it will be; it has a film
    /// @param source  of the film, new
    void begin(const PlacedShot& photo, SourceId source, std::chrono::nanoseconds now);

    /// The photo begins to return: the film fades out.
    void end(std::chrono::nanoseconds now);

    void source_ready(SourceId source);
    void source_failed(SourceId source);

    /// Lets the film begin once it is ready and its photo is large, and end.
    void advance(std::chrono::nanoseconds now);

    /// The film at its place, whose source is needed; empty: none.
    std::vector<PlacedShot> shots() const;

    /// The film whose source is needed; none: no photo with a film is large.
    const std::optional<FilmMoment>& moment() const { return film_; }

  private:
    std::optional<FilmMoment> film_;
    bool is_ready_ = false;
    std::chrono::nanoseconds earliest_{0};  // its photo is large from then on
};

}  // namespace vitrine::player
