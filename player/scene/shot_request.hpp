#pragma once

#include "base/state/record.hpp"
#include "player/scene/frame.hpp"

#include <string>

namespace vitrine::player {

/// Asks for a shot to be made ready for showing, or for one that plays to change its size.
struct ShotRequest {
    SourceId source = 0;
    std::string path;  // relative to the media root
    MediaKind kind = MediaKind::photo;
    Shot shot;
    int width = 0;  // px that the upright picture shall have: what it is shown at, at most its own
    int height = 0;

    bool operator==(const ShotRequest&) const = default;
};

}  // namespace vitrine::player
