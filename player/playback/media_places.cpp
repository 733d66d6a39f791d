#include "player/playback/media_places.hpp"

#include "player/scene/shot_request.hpp"

#include <unistd.h>

#include <utility>

namespace vitrine::player {

ShotFile media_file(const ShotRequest& request, const MediaPlaces& places) {
    return {.path = places.media + "/" + request.path, .request = request};
}

std::optional<ShotFile> stored_file(const ShotRequest& request, const MediaPlaces& places) {
    std::optional<ShotRequest> stored = stored_request(request);
    if (!stored) return std::nullopt;
    std::string path = places.store + "/" + stored->path;
    if (::access(path.c_str(), R_OK) != 0) return std::nullopt;
    return ShotFile{.path = std::move(path), .request = *std::move(stored)};
}

}  // namespace vitrine::player
