#include "player/scene/shot_request.hpp"

namespace vitrine::player {

std::optional<ShotRequest> stored_request(const ShotRequest& request) {
    const std::optional<StoredShot>& stored = request.shot.stored;
    if (!stored || stored->is_dropped) return std::nullopt;
    ShotRequest from = request;
    from.path = stored->file;
    from.shot.begin = stored->begin;
    from.shot.end = stored->begin + request.shot.duration();
    if (request.width > stored->width || request.height > stored->height) {
        from.width = stored->width;
        from.height = stored->height;
    }
    return from;
}

}  // namespace vitrine::player
