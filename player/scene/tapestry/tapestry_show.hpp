#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"
#include "player/scene/tapestry/tapestry_motion.hpp"
#include "player/scene/tapestry/tile_cache.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

struct TapestrySettings {
    SourceId first_source = 0;                               // its own are numbered from there on
    std::optional<std::chrono::nanoseconds> patience;        // without a touch, then it is over; none: never
    std::int64_t most_tile_bytes = std::int64_t{128} << 20;  // of tiles as textures, RGBA
    TapestryPace pace;
    std::vector<Shot> shots;                 // of the film, as its record has them; none: they are not known
    bool plays_at_once = false;              // what is in the middle at first
    std::chrono::nanoseconds first_seen{0};  // in the middle at first, as far as the film's ends allow
};

/// A tile's ways to the levels next to its own; where there are none it is only shown at its own.
struct TileZooms {
    std::shared_ptr<const ZoomMesh> to_coarser;  // shared: with the frames under way
    std::shared_ptr<const ZoomMesh> to_finer;    // likewise
};

/// What is to be done in this frame, beside drawing it.
struct TapestryStep {
    Frame frame;
    std::vector<TileId> missing;  // to be read, the most urgent first; replaces what was asked for before
    std::vector<ShotRequest> requests;  // stretches of the film to be played
    std::vector<SourceId>
        retired;  // tiles and stretches, not in this frame and not before they are asked for anew
};

/// A film's tapestry in the lower part of the canvas, to be dragged, flung and zoomed; a tap plays the film
/// from there in the upper part, and the part below the finger plays in place for a while. By itself it goes
/// through the film. Knows no clock, files or textures: tiles and stretches of film are sources, told when
/// they are there. Source: Video Tapestries 5 and 6 (preview above, zoom in 0.6 s); animated tapestries: 7,
/// future work. From level to level it goes as its zoom fields say (4.3), where there are any; else one level
/// fades into the other.
class TapestryShow {
  public:
    /// @param picture  size of the film's upright picture, px; only its shape counts
    /// @param canvas   px
    TapestryShow(Tapestry tapestry, Vec2 picture, Vec2 canvas, const TapestrySettings& settings);

    void set_canvas(Vec2 canvas);

    /// Of the film, as its record has them by now: more of them are stored.
    void set_shots(std::vector<Shot> shots) { settings_.shots = std::move(shots); }

    void handle_gesture(const Gesture& gesture);

    /// A tile can be drawn from now on.
    void tile_ready(const TileId& tile, TileZooms zooms = {});

    /// It is given up: all that it had asked for.
    std::vector<SourceId> close();

    /// The film is not what it was.
    void end() { is_over_ = true; }

    /// All tiles have been lost, with the renderer that had them.
    void forget_tiles();

    void source_ready(SourceId source);
    void source_failed(SourceId source);

    /// @param now  never goes back
    TapestryStep step(std::chrono::nanoseconds now);

    /// A visitor has had enough of it, or nobody has touched it for long.
    bool is_over() const { return is_over_; }

    SourceId source_of(const TileId& tile) const;

    /// Of a picture of one white pixel, which lines are drawn with.
    SourceId mark() const { return settings_.first_source; }

    const TapestryView& view() const { return motion_.view(); }

    const Tapestry& tapestry() const { return tapestry_; }

    const Box& box() const { return box_; }

    const Box& preview() const { return preview_; }

    std::size_t tiles() const { return cache_.size(); }

  private:
    /// A stretch of the film that plays.
    struct Playing {
        SourceId source = 0;
        std::chrono::nanoseconds begin{0};
        std::chrono::nanoseconds end{0};
        std::optional<std::chrono::nanoseconds> began;  // none: not ready yet; < 0: with the next picture
        bool follows = false;                           // comes once what is shown has ended

        std::chrono::nanoseconds length() const { return end - begin; }
    };

    TapestryPlace place() const { return {tapestry_, box_}; }

    void lay_out(Vec2 canvas);
    void close_or_end(Vec2 at);
    void pinch_shut(const Gesture& gesture);
    void play(std::chrono::nanoseconds from);
    void play_in_place(std::chrono::nanoseconds from);
    Playing stretch(std::chrono::nanoseconds from, std::chrono::nanoseconds length, double width);
    const Shot* shot_at(std::chrono::nanoseconds time) const;
    void play_on(std::chrono::nanoseconds now);
    void retire(std::optional<Playing>& playing);
    void play_by_itself(std::chrono::nanoseconds now);
    Frame picture(std::chrono::nanoseconds now);
    void draw_levels(Frame& frame) const;
    void draw_level(Frame& frame, std::size_t level, double alpha) const;
    void draw_zoom(Frame& frame, std::size_t level, bool is_to_finer) const;
    const ZoomMesh* zoom_of(const TileId& tile, bool is_to_finer) const;
    bool is_whole(std::size_t level) const;
    bool goes_over_whole(std::size_t coarse) const;
    void cover(Frame& frame) const;
    void draw_in_place(Frame& frame);
    void draw_preview(Frame& frame);
    void draw_playhead(Frame& frame, const Playing& playing) const;
    Box brick(std::chrono::nanoseconds time) const;

    Tapestry tapestry_;
    Vec2 picture_;
    Vec2 canvas_;
    TapestrySettings settings_;
    Box box_;      // of the strip, canvas px
    Box preview_;  // canvas px
    TapestryMotion motion_;
    TileCache cache_;
    std::map<TileId, TileZooms> zooms_;  // of those in the cache
    std::optional<Playing> shown_;       // above the strip
    std::optional<Playing> incoming_;    // takes its place once it is ready
    std::optional<Playing> in_place_;
    SourceId last_source_;
    std::vector<ShotRequest> requests_;
    std::vector<SourceId> retired_;
    double pinched_ = 1;  // by how much, at the coarsest level
    bool is_touched_ = true;
    std::chrono::nanoseconds touched_{0};
    std::chrono::nanoseconds played_{0};  // when it last played by itself
    bool is_over_ = false;
};

}  // namespace vitrine::player
