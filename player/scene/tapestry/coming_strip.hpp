#pragma once

#include "player/scene/tapestry/tapestry_picture.hpp"
#include "player/scene/tapestry/tapestry_strip.hpp"

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::player {

/// A newer tapestry of the film that is shown. What the view shows of it is loaded beside the older one; then
/// it fades in over the older one, with the same moment in the middle and about the same scale.
class ComingStrip {
  public:
    explicit ComingStrip(TapestryStrip strip) : strip_(std::move(strip)) {}

    const TapestryStrip& strip() const { return strip_; }

    /// Call with each frame. @param now  never goes back
    /// @param shown  the older strip's place, and its view
    void advance(std::chrono::nanoseconds now, const TapestryPlace& shown, const TapestryView& view);

    /// True: it covers the older one.
    bool is_there(std::chrono::nanoseconds now) const;

    /// @return  the strip as it is drawn over the older one; nothing while it is not loaded
    std::optional<OverlaidStrip> drawn(std::chrono::nanoseconds now) const;

    std::vector<SourceId> add(const TileId& tile, TileZooms zooms) {
        return strip_.add(tile, std::move(zooms));
    }

    std::vector<SourceId> clear() { return strip_.clear(); }

    /// Hands the strip over. It is not shown by this any more.
    TapestryStrip take() { return std::move(strip_); }

  private:
    TapestryStrip strip_;
    TapestryView view_;
    std::optional<std::chrono::nanoseconds> began_;  // to fade in; none: it is not loaded yet
};

}  // namespace vitrine::player
