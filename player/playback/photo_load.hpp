#pragma once

#include "base/media/colour.hpp"
#include "player/playback/sample_queue.hpp"

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::player {

/// Reads one photo into a queue, in a thread of its own. Throws nothing: failure() reports, and the queue is
/// closed.
class PhotoLoad {
  public:
    /// @param width, height  px of the upright picture asked for
    /// @param background     colour behind the transparent parts of the photo
    /// @param queue  outlives this
    PhotoLoad(std::string file, int width, int height, Colour background, SampleQueue& queue);
    PhotoLoad(const PhotoLoad&) = delete;
    PhotoLoad& operator=(const PhotoLoad&) = delete;
    PhotoLoad(PhotoLoad&&) = delete;
    PhotoLoad& operator=(PhotoLoad&&) = delete;

    /// Waits for its thread, but not for long once has_ended().
    ~PhotoLoad();

    int width() const { return width_; }

    int height() const { return height_; }

    bool has_ended() const { return has_ended_; }

    /// The reason why there is no picture, in plain words.
    std::optional<std::string> failure() const;

  private:
    void run(const std::string& file, int width, int height, Colour background);

    int width_;  // px asked for
    int height_;
    SampleQueue& queue_;  // outlives this
    std::atomic<bool> has_ended_ = false;
    mutable std::mutex mutex_;
    std::optional<std::string> failure_;  // guarded by mutex_
    std::thread thread_;                  // last: it uses all members above
};

}  // namespace vitrine::player
