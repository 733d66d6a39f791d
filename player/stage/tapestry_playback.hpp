#pragma once

#include "player/playback/tile_loader.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/show.hpp"
#include "player/scene/tapestry/tapestry_show.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace vitrine::player {

struct TapestryPlaybackOptions {
    SourceId first_source = 0;                         // its sources are numbered from here on
    std::optional<std::chrono::nanoseconds> patience;  // time without a touch until it ends; none: never
    bool awaits_tiles = false;                         // each frame waits for all its tiles
    bool rests = false;                                // it never moves by itself
    RecordList::Record film;                           // none: the film has no record
    std::chrono::nanoseconds first_seen{0};            // film time in the middle of the first view
};

/// True: the tapestry was woven from the present content of the film.
bool is_woven_from(const Tapestry& tapestry, const MediaRecord& film);

/// Shows a film's tapestry with its tiles. They are read in the background and a few of them are given to the
/// renderer with each frame, so that neither reading nor uploading delays a frame.
class TapestryPlayback {
  public:
    /// @param directory  the tapestry's directory
    /// @throws std::runtime_error, std::system_error  naming the index that cannot be read
    TapestryPlayback(std::filesystem::path directory, Vec2 canvas, TapestryPlaybackOptions options);

    void set_canvas(Vec2 canvas) { show_.set_canvas(canvas); }

    void handle_gesture(const Gesture& gesture) { show_.handle_gesture(gesture); }

    void source_ready(SourceId source) { show_.source_ready(source); }

    void source_failed(SourceId source) { show_.source_failed(source); }

    /// Updates the film's record. If the film has changed, the tapestry is over.
    void set_catalogue(const RecordList& records);

    bool is_over() const { return show_.is_over(); }

    /// The next frame. Gives the tiles that it needs to the renderer.
    WallStep step(std::chrono::nanoseconds now, Renderer& renderer);

    /// Call after the renderer was replaced: all pictures must be uploaded again.
    void forget_uploads();

    /// Ends the tapestry. @return the sources that it used
    std::vector<SourceId> close() { return show_.close(); }

    const TapestryShow& show() const { return show_; }

    /// Limit of the tiles that the renderer gets in one frame, unless frames wait for tiles.
    static constexpr std::size_t max_uploads = 2;

  private:
    std::vector<TileFile> files(const std::vector<TileId>& tiles);
    bool give_tiles(const std::vector<TileId>& missing, Renderer& renderer);
    void give(const LoadedTile& tile, Renderer& renderer);

    std::filesystem::path directory_;
    TapestryPlaybackOptions options_;
    TapestryShow show_;
    std::set<TileId> unreadable_;  // tiles that are not asked for again
    std::vector<TileId> asked_;    // the last tiles that the loader was asked for
    bool has_mark_ = false;        // the renderer has the white picture for drawing lines
    TileLoader loader_;
};

}  // namespace vitrine::player
