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
    SourceId first_source = 0;                         // its sources are numbered from there on
    std::optional<std::chrono::nanoseconds> patience;  // time without a touch until it is over; none: never
    bool awaits_tiles = false;                         // every frame is whole, however long its tiles take
    RecordList::Record film;                           // none: nothing is known of the film
    std::chrono::nanoseconds first_seen{0};            // film time in the middle of the first view
};

/// True: the tapestry was woven from the film as it is now.
bool is_woven_from(const Tapestry& tapestry, const MediaRecord& film);

/// Shows a film's tapestry with its tiles. They are read in the background and given to the renderer a few a
/// frame, so that neither reading nor uploading holds a frame up.
class TapestryPlayback {
  public:
    /// @param directory  the tapestry's directory
    /// @throws std::runtime_error, std::system_error  naming the index that cannot be read
    TapestryPlayback(std::filesystem::path directory, Vec2 canvas, TapestryPlaybackOptions options);

    void set_canvas(Vec2 canvas) { show_.set_canvas(canvas); }

    void handle_gesture(const Gesture& gesture) { show_.handle_gesture(gesture); }

    void source_ready(SourceId source) { show_.source_ready(source); }

    void source_failed(SourceId source) { show_.source_failed(source); }

    /// Follows the record of its film. If the film has changed, the tapestry is over.
    void set_catalogue(const RecordList& records);

    bool is_over() const { return show_.is_over(); }

    /// The next frame. The tiles that it needs are given to the renderer.
    WallStep step(std::chrono::nanoseconds now, Renderer& renderer);

    /// Another renderer is used from now on.
    void forget_uploads();

    /// Ends it. @return the sources that it used
    std::vector<SourceId> close() { return show_.close(); }

    const TapestryShow& show() const { return show_; }

    /// Tiles that the renderer is given in one frame, unless they are awaited.
    static constexpr std::size_t max_uploads = 2;

  private:
    std::vector<TileFile> files(const std::vector<TileId>& tiles);
    bool give_tiles(const std::vector<TileId>& missing, Renderer& renderer);
    void give(const LoadedTile& tile, Renderer& renderer);

    std::filesystem::path directory_;
    TapestryPlaybackOptions options_;
    TapestryShow show_;
    std::set<TileId> unreadable_;  // tiles that are not asked for again
    std::vector<TileId> asked_;    // tiles that the loader was told of last
    bool has_mark_ = false;        // the renderer has the white picture that lines are drawn with
    TileLoader loader_;
};

}  // namespace vitrine::player
