#pragma once

#include "player/scene/tapestry/coming_strip.hpp"
#include "player/scene/tapestry/tapestry_motion.hpp"
#include "player/scene/tapestry/tapestry_strip.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The tapestries of one film, which is woven better and better: the one that is shown, and a newer one that
/// comes. Each has a generation, which its sources tell.
class WovenStrips {
  public:
    /// @param max_tile_bytes  limit of the tiles' memory as RGBA textures
    WovenStrips(Tapestry tapestry, SourceId first_source, std::int64_t max_tile_bytes);

    const TapestryStrip& shown() const { return shown_; }

    TapestryStrip& shown() { return shown_; }

    const std::optional<ComingStrip>& coming() const { return coming_; }

    /// One of both; nullptr: that generation is neither.
    const TapestryStrip* find(unsigned generation) const;

    /// Shows a newer tapestry of the film from the moment on at which all of it that is in view can be drawn.
    void take_over(Tapestry newer);

    /// The newer one is not shown, because it cannot be read.
    void drop_coming();

    /// Call when a tile of one of them can be drawn. Tiles of others are ignored.
    void add(unsigned generation, const TileId& tile, TileZooms zooms);

    /// Call with each frame. Once the newer one covers the older one, it is the one that is shown.
    /// @param now  never goes back
    void advance(std::chrono::nanoseconds now, const TapestryBoxes& boxes, TapestryMotion& motion);

    /// Call when all tiles have been lost with the renderer.
    void forget_tiles();

    /// Drops everything. The sources are among take_retired().
    void clear();

    /// Removes and returns the sources that are not needed any more.
    std::vector<SourceId> take_retired() { return std::exchange(retired_, {}); }

  private:
    void retire(const std::vector<SourceId>& sources);

    std::int64_t max_tile_bytes_;
    TapestryStrip shown_;
    std::optional<ComingStrip> coming_;
    unsigned generation_ = 0;  // the newest
    std::vector<SourceId> retired_;
};

}  // namespace vitrine::player
