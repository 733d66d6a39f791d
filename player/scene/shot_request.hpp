#pragma once

#include "base/state/record.hpp"
#include "player/scene/frame.hpp"

#include <chrono>
#include <optional>
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
    std::chrono::nanoseconds at{0};  // how long it has been shown elsewhere when it is first seen here

    bool operator==(const ShotRequest&) const = default;
};

/// The request for the same shot in the store: its path is relative to the store, its times are those of the
/// stored file, and its size is at most the stored size, which is enlarged in drawing. None: the record names
/// no place in the store. The file may have been removed since; that is noticed when it is opened.
std::optional<ShotRequest> stored_request(const ShotRequest& request);

}  // namespace vitrine::player
