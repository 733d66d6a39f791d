#include "player/playback/clip_handover.hpp"

#include <optional>

namespace vitrine::player {

namespace {

constexpr int max_tries = 3;
constexpr std::chrono::nanoseconds preparing_time = std::chrono::milliseconds(500);  // for a clip

}  // namespace

void ClipHandover::allow() {
    tries_ = max_tries;
}

void ClipHandover::open_clip(const ShotRequest& request, const MediaPlaces& places,
                             const SourceOptions& options, std::chrono::nanoseconds local) {
    --tries_;
    const std::optional<ShotFile> stored = stored_file(request, places);
    if (!stored) return;
    const std::chrono::nanoseconds loop = stored->request.shot.duration();
    seam_ = ((local + preparing_time) / loop + 1) * loop;
    clip_ = std::make_unique<ShotSource>(stored->path, stored->request, options, seam_);
}

void ClipHandover::resize(int width, int height) {
    if (clip_) clip_->resize(width, height);
}

}  // namespace vitrine::player
