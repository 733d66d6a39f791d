#pragma once

#include "base/settings/settings.hpp"
#include "player/scene/show.hpp"

#include <memory>

namespace vitrine::player {

/// A kind of wall, chosen by `layout.mode`. A calm wall does not pan.
struct ShowMode {
    using Factory = std::unique_ptr<Show> (*)(const Settings& settings, const Canvas& canvas,
                                              SourceId last_source);

    WallMode mode = WallMode::fit;
    bool has_turns = true;  // shots take turns in numbered slots, so they can be asked for and pinned
    Factory make;           // the show's sources are numbered from `last_source` on
};

/// The mode that the settings name.
const ShowMode& show_mode(const Settings& settings);

}  // namespace vitrine::player
