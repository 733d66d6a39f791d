#pragma once

#include "player/scene/tapestry/tapestry_view.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace vitrine::player {

/// Which tiles shall be there, the most urgent first: what is seen; the coarsest level, which stands in for
/// what is not there yet; what lies beside the view, rather where it goes to; what is seen of the
/// neighbouring levels. Source: Video Tapestries 4.2, "in a small neighborhood of the user's current position
/// in the x direction and in scale space".
/// @param direction  > 0: the view goes to the right, < 0: to the left, 0: it rests
/// @param most       tiles
std::vector<TileId> wanted_tiles(const TapestryPlace& place, const TapestryView& view, double direction,
                                 std::size_t most);

/// Which tiles are there, bounded: the one least recently wanted gives way.
class TileCache {
  public:
    /// @param most  tiles, >= 1
    explicit TileCache(std::size_t most) : most_(most) {}

    /// What shall be there now, the most urgent first; at most as many as there is room for count.
    void wish(std::span<const TileId> wanted);

    /// What is wished and not there, the most urgent first.
    std::vector<TileId> missing() const;

    /// A tile has come. What has to give way for it; it itself where nobody wants it any more.
    std::vector<TileId> add(const TileId& tile);

    bool has(const TileId& tile) const { return tiles_.contains(tile); }

    std::size_t size() const { return tiles_.size(); }

    std::size_t most() const { return most_; }

    /// All that there is, which is no more from here on.
    std::vector<TileId> clear();

  private:
    std::size_t most_;
    std::uint64_t turn_ = 0;
    std::vector<TileId> wanted_;
    std::map<TileId, std::uint64_t> tiles_;  // the turn when each was wanted last
};

}  // namespace vitrine::player
