#pragma once

#include "base/settings/settings.hpp"
#include "player/scene/show.hpp"

#include <cstdint>
#include <memory>

namespace vitrine::player {

/// A kind of wall, chosen by `layout.mode`. A calm wall does not pan.
struct ShowMode {
    using Factory = std::unique_ptr<Show> (*)(const Settings& settings, const Canvas& canvas,
                                              SourceId last_source);

    WallMode mode = WallMode::fit;
    bool has_turns = true;       // shots take turns in numbered slots, so they can be asked for and pinned
    Factory make;                // the show's sources are numbered from `last_source` on
    Factory make_led = nullptr;  // the same, of a box that leads a wall of several boxes; null: it cannot
};

/// The wall of a stage as the settings want it. A box of a wall of several boxes leads or follows with its
/// first stage.
/// @param owner  of the show's sources; 0: the first stage
std::unique_ptr<Show> make_show(const Settings& settings, const Canvas& canvas, std::uint64_t owner);

/// True if a wall of this mode can lead others.
bool can_lead(const Settings& settings);

/// The mode that the settings name.
const ShowMode& show_mode(const Settings& settings);

}  // namespace vitrine::player
