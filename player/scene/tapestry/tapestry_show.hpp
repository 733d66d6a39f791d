#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"
#include "player/scene/tapestry/strip_finger.hpp"
#include "player/scene/tapestry/tapestry_moment.hpp"
#include "player/scene/tapestry/tapestry_motion.hpp"
#include "player/scene/tapestry/tapestry_picture.hpp"
#include "player/scene/tapestry/tapestry_preview.hpp"
#include "player/scene/tapestry/woven_strips.hpp"

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::player {

struct TapestrySettings {
    SourceId first_source = 0;                              // its sources are numbered from here on
    std::optional<std::chrono::nanoseconds> patience;       // time without a touch until it ends; none: never
    std::int64_t max_tile_bytes = std::int64_t{128} << 20;  // limit of the tiles' memory as RGBA textures
    TapestryPace pace;
    bool plays_at_once = false;              // the preview plays from first_seen on at once
    std::chrono::nanoseconds first_seen{0};  // the first time in the middle, as far as the film's ends allow
    std::optional<KeyframeChoice> edited{};  // touches change these keyframes; none: touches change none
};

/// The work of one frame, besides drawing it.
struct TapestryStep {
    Frame frame;
    std::vector<TileId> missing;  // tiles to be read, the most urgent first; replaces the last list
    std::vector<TileId> coming;   // the same of the newer tapestry that is to be shown; before `missing`
    std::vector<ShotRequest> requests;  // parts of the film to play
    std::vector<SourceId> retired;      // tiles and parts, no longer needed; requested again if needed later
    TapestryMoment seen;                // the frame as other boxes need it
};

/// A film's tapestry. Its strip in the lower part of the canvas is dragged, flung and zoomed. A tap plays the
/// touched picture in place, and the film from there in the preview above; a finger that drags sees the
/// moment under it there (strip_finger.hpp). The strip goes along with the film. At the film's end the
/// tapestry is over. Without a touch the strip moves through the film by itself. Knows no clock, files or
/// textures: tiles and parts of the film are sources, and the caller reports when they are ready. Source:
/// Video Tapestries 5 and 6 (preview above, zoom in 0.6 s); animated tapestries: 7, future work. Zooms follow
/// the film's zoom fields (4.3) if it has any; else one level fades into the other. A film that is not woven
/// yet has an empty strip; a newer tapestry of the film fades in over the one that is shown.
class TapestryShow {
  public:
    TapestryShow(Tapestry tapestry, PreviewedFilm film, const TapestryRoom& room,
                 const TapestrySettings& settings);

    void set_room(const TapestryRoom& room);

    /// Call when the film's record has come or has changed: the store may have more of its shots.
    void set_film(PreviewedFilm film);

    const PreviewedFilm& film() const { return spans_.film(); }

    void handle_gesture(const Gesture& gesture);

    /// The tapestry that is shown, and a newer one that comes.
    WovenStrips& strips() { return strips_; }

    const WovenStrips& strips() const { return strips_; }

    /// The keyframes that a technician has chosen, if that has changed since the last call.
    std::optional<KeyframeChoice> take_choice() { return edit_ ? edit_->take_changed() : std::nullopt; }

    /// Retires everything and returns the sources.
    std::vector<SourceId> close();

    /// Ends the show, because its film has changed.
    void end() { is_over_ = true; }

    void source_ready(SourceId source) { preview_.source_ready(source); }

    void source_failed(SourceId source) { preview_.source_failed(source); }

    /// @param now   never goes back
    /// @param seen  the moment of another box that is shown here, in this show's time; nullptr: the show goes
    ///              by itself and by touches
    TapestryStep step(std::chrono::nanoseconds now, const TapestryMoment* seen = nullptr);

    /// True once a visitor has closed the tapestry, nobody has touched it for `patience`, the film is over,
    /// or end() was called. Without `patience` the film begins anew at its end.
    bool is_over() const { return is_over_; }

    const TapestrySources& sources() const { return strips_.shown().sources(); }

    const TapestryView& view() const { return motion_.view(); }

    const Tapestry& tapestry() const { return strips_.shown().tapestry(); }

    /// The strip's place on the canvas. Borrows the tapestry.
    TapestryPlace place() const { return strip_place(tapestry(), boxes_); }

  private:
    void go_on(std::chrono::nanoseconds now);
    void follow(const TapestryMoment& seen, std::chrono::nanoseconds now);

    WovenStrips strips_;
    std::optional<std::chrono::nanoseconds> patience_;  // see TapestrySettings
    TapestryBoxes boxes_;
    TapestryMotion motion_;
    FilmSpans spans_;
    TapestryPreview preview_;  // refers to spans_
    StripFinger finger_;
    std::optional<KeyframeEdit> edit_;                 // none: touches change no keyframes
    std::optional<std::chrono::nanoseconds> touched_;  // the last touch; none: since the last step
    std::chrono::nanoseconds played_{0};               // time at which the preview last started by itself
    bool is_over_ = false;
};

}  // namespace vitrine::player
