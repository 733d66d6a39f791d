#pragma once

#include "base/state/record.hpp"
#include "player/scene/frame.hpp"

#include <string>

namespace vitrine::player {

/// Asks for a shot's source, or for another size of one that plays.
struct ShotRequest {
    SourceId source = 0;
    std::string path;  // relative to the media root
    MediaKind kind = MediaKind::photo;
    Shot shot;
    int width = 0;  // px of the upright picture: as large as it is shown, at most
                    // its own size
    int height = 0;

    bool operator==(const ShotRequest&) const = default;
};

}  // namespace vitrine::player
