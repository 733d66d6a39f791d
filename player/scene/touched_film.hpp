#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <optional>
#include <span>

namespace vitrine::player {

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
    std::span<const PlacedShot> shots() const;

    /// Draws it above all else.
    void draw(Frame& frame) const;

  private:
    std::optional<PlacedShot> film_;  // `began` is `never` until it plays
    bool is_ready_ = false;
    std::chrono::nanoseconds earliest_{0};   // its photo is large from then on
    std::chrono::nanoseconds ends_ = never;  // it is invisible from then on
};

}  // namespace vitrine::player
