#pragma once

#include "player/playback/media_places.hpp"
#include "player/playback/shot_source.hpp"

#include <chrono>
#include <memory>

namespace vitrine::player {

/// Hands a film that plays from the media folder over to its clip, which the store has got meanwhile. The
/// clip is opened ahead and begins at a seam, the end of a loop; it has the very pictures, so that nobody
/// sees it.
class ClipHandover {
  public:
    /// The store has a clip now: it may be tried a few times.
    void allow();

    /// No further try.
    void forbid() { tries_ = 0; }

    bool is_allowed() const { return tries_ > 0; }

    /// Opens the clip for the next seam that leaves it time to get ready. Counts as a try, also where the
    /// store has lost the clip.
    /// @param local  time since the shot began to be shown
    void open_clip(const ShotRequest& request, const MediaPlaces& places, const SourceOptions& options,
                   std::chrono::nanoseconds local);

    /// True from open_clip() to take_clip().
    bool has_clip() const { return clip_ != nullptr; }

    /// True once a clip's seam has come.
    bool is_due(std::chrono::nanoseconds local) const { return clip_ && local >= seam_; }

    void resize(int width, int height);

    /// Waits until the clip is ready or has failed. @pre has_clip()
    void wait_until_ready(std::chrono::nanoseconds patience) const { clip_->wait_until_ready(patience); }

    /// The clip, ready or not; none: there is none.
    std::unique_ptr<ShotSource> take_clip() { return std::move(clip_); }

  private:
    std::unique_ptr<ShotSource> clip_;
    std::chrono::nanoseconds seam_{0};  // since the shot began to be shown
    int tries_ = 0;                     // tries left
};

}  // namespace vitrine::player
