#pragma once

#include "player/playback/media_places.hpp"
#include "player/playback/shot_source.hpp"

#include <chrono>
#include <memory>

namespace vitrine::player {

/// Hands a film that plays from the media folder over to its clip, once the store has one. The clip is opened
/// ahead and starts at a seam, the end of a loop. Its pictures are the same, so nobody sees the change.
class ClipHandover {
  public:
    /// Call when the store has got a clip: a few tries are allowed.
    void allow();

    /// Allows no further try.
    void forbid() { tries_ = 0; }

    bool is_allowed() const { return tries_ > 0; }

    /// Opens the clip for the next seam that leaves it enough time to get ready. This counts as a try even if
    /// the store has lost the clip.
    /// @param local  time since the shot was first shown
    void open_clip(const ShotRequest& request, const MediaPlaces& places, const SourceOptions& options,
                   std::chrono::nanoseconds local);

    /// True from open_clip() to take_clip().
    bool has_clip() const { return clip_ != nullptr; }

    /// True once the clip's seam is reached.
    bool is_due(std::chrono::nanoseconds local) const { return clip_ && local >= seam_; }

    void resize(int width, int height);

    /// Waits until the clip is ready or has failed. @pre has_clip()
    void wait_until_ready(std::chrono::nanoseconds patience) const { clip_->wait_until_ready(patience); }

    /// The clip, ready or not. None: no clip is open.
    std::unique_ptr<ShotSource> take_clip() { return std::move(clip_); }

  private:
    std::unique_ptr<ShotSource> clip_;
    std::chrono::nanoseconds seam_{0};  // the clip's first time, since the shot was first shown
    int tries_ = 0;                     // tries left
};

}  // namespace vitrine::player
