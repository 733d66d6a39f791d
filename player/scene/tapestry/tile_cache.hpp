#pragma once

#include "player/scene/tapestry/tapestry_view.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace vitrine::player {

/// Lists the tiles to load, the most urgent first: those in view; the coarsest level, which is drawn in place
/// of missing tiles; those beside the view, first in the direction of its motion; those in view on the
/// neighbouring levels. Source: Video Tapestries 4.2, "in a small neighborhood of the user's current position
/// in the x direction and in scale space".
/// @param direction  > 0: the view moves to the right, < 0: to the left, 0: it rests
/// @param max_tiles  limit of the list
std::vector<TileId> wanted_tiles(const TapestryPlace& place, const TapestryView& view, double direction,
                                 std::size_t max_tiles);

/// The meshes for drawing a tile between its own level and the next ones. A tile without meshes is drawn only
/// at its own level.
struct TileZooms {
    std::shared_ptr<const ZoomMesh> to_coarser;  // shared with the frames under way
    std::shared_ptr<const ZoomMesh> to_finer;    // shared with the frames under way
};

/// The loaded tiles, up to a limit. The least recently wanted tile is dropped first.
class TileCache {
  public:
    /// @param max_tiles  >= 1
    explicit TileCache(std::size_t max_tiles) : max_tiles_(max_tiles) {}

    /// Sets the tiles wanted now, the most urgent first. Ignores those beyond max_tiles().
    void set_wanted(std::span<const TileId> wanted);

    /// The wanted tiles that are not loaded, the most urgent first.
    std::vector<TileId> missing() const;

    /// Adds a tile that has been loaded.
    /// @return the tiles dropped for it; the tile itself if it is no longer wanted
    std::vector<TileId> add(const TileId& tile, TileZooms zooms = {});

    bool has(const TileId& tile) const { return tiles_.contains(tile); }

    /// The mesh of a loaded tile; nullptr if it has none.
    std::shared_ptr<const ZoomMesh> zoom(const TileId& tile, bool is_to_finer) const;

    std::size_t size() const { return tiles_.size(); }

    std::size_t max_tiles() const { return max_tiles_; }

    /// Drops all tiles and returns them.
    std::vector<TileId> clear();

  private:
    struct Entry {
        std::uint64_t turn = 0;  // the last call of set_wanted() with this tile
        TileZooms zooms;
    };

    std::size_t max_tiles_;
    std::uint64_t turn_ = 0;
    std::vector<TileId> wanted_;
    std::map<TileId, Entry> tiles_;
};

}  // namespace vitrine::player
