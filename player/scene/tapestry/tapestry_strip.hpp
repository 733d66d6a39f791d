#pragma once

#include "base/state/tapestry.hpp"
#include "player/scene/tapestry/tapestry_picture.hpp"
#include "player/scene/tapestry/tapestry_view.hpp"
#include "player/scene/tapestry/tile_cache.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace vitrine::player {

/// One woven tapestry of a film with its loaded pictures: tiles, sheets of kept frames and digits. While a
/// film is woven better and better, several follow each other; their sources differ.
class TapestryStrip {
  public:
    /// @param max_bytes  limit of the tiles' memory as RGBA textures
    TapestryStrip(Tapestry tapestry, TapestrySources sources, std::int64_t max_bytes);

    const Tapestry& tapestry() const { return tapestry_; }

    const TapestrySources& sources() const { return sources_; }

    const TileCache& tiles() const { return tiles_; }

    /// Sheets of frames, digits.
    const TileCache& kept() const { return kept_; }

    /// @param direction  see wanted_tiles()
    /// @param moment     under a finger that looks for it
    void want_all(const TapestryPlace& place, const TapestryView& view, double direction,
                  std::optional<std::chrono::nanoseconds> moment);

    /// Wants no more than the pictures that a view shows.
    void want_seen(const TapestryPlace& place, const TapestryView& view);

    /// Lists the tiles that are wanted and not loaded, the most urgent first.
    /// @param is_looking  a finger looks for a moment
    std::vector<TileId> missing(bool is_looking) const;

    /// Call when a picture can be drawn. @return the sources of those that went for it
    std::vector<SourceId> add(const TileId& tile, TileZooms zooms);

    /// Drops everything. @return the sources
    std::vector<SourceId> clear();

  private:
    Tapestry tapestry_;
    TapestrySources sources_;
    TileCache tiles_;
    TileCache kept_;
};

}  // namespace vitrine::player
