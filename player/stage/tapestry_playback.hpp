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

struct StripStageOptions {
    SourceId first_source = 0;                         // as TapestrySettings
    std::optional<std::chrono::nanoseconds> patience;  // likewise
    bool awaits_tiles = false;                         // every picture is whole, however long it takes
    std::optional<MediaRecord> film;                   // what is known of it; none: nothing
    std::chrono::nanoseconds first_seen{0};            // as TapestrySettings
};

/// Whether a tapestry is of the film as it is now.
bool is_woven_from(const Tapestry& tapestry, const MediaRecord& film);

/// A film's strip with its tiles: read in the background, and given to the renderer a few a frame, so that
/// neither reading nor uploading holds a frame up.
class StripStage {
  public:
    /// @param directory  of the tapestry
    /// @throws std::runtime_error, std::system_error  naming the index that cannot be read
    StripStage(std::filesystem::path directory, Vec2 canvas, StripStageOptions options);

    void set_canvas(Vec2 canvas) { strip_.set_canvas(canvas); }

    void take(const Gesture& gesture) { strip_.handle_gesture(gesture); }

    void source_ready(SourceId source) { strip_.source_ready(source); }

    void source_failed(SourceId source) { strip_.source_failed(source); }

    /// What is known of the files is another: where it is another film by now, the strip is over.
    void set_catalogue(const RecordList& records);

    bool is_over() const { return strip_.is_over(); }

    /// The next picture; tiles that it needs are given to the renderer.
    WallStep step(std::chrono::nanoseconds now, Renderer& renderer);

    /// Another renderer is used from now on.
    void forget_uploads();

    /// It is given up: the sources that it used.
    std::vector<SourceId> close() { return strip_.close(); }

    const TapestryShow& strip() const { return strip_; }

    /// Tiles given to the renderer in one frame, at most, unless they are awaited.
    static constexpr std::size_t most_uploads = 2;

  private:
    std::vector<TileFile> files(const std::vector<TileId>& tiles);
    bool give_tiles(const std::vector<TileId>& missing, Renderer& renderer);
    void give(const LoadedTile& tile, Renderer& renderer);

    std::filesystem::path directory_;
    StripStageOptions options_;
    TapestryShow strip_;
    std::set<TileId> unreadable_;
    std::vector<TileId> asked_;
    bool has_mark_ = false;
    TileLoader loader_;
};

}  // namespace vitrine::player
