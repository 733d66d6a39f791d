#pragma once

#include "base/state/record.hpp"
#include "player/scene/frame.hpp"

#include <string>

namespace vitrine::player {

/// A request for a shot's source, or for another size of a playing one.
struct ShotRequest {
    SourceId source = 0;
    std::string path;  // relative to the media folder
    MediaKind kind = MediaKind::photo;
    Shot shot;
    int width = 0;  // px of the upright picture: its shown size, but not more than its own
    int height = 0;

    bool operator==(const ShotRequest&) const = default;
};

}  // namespace vitrine::player
