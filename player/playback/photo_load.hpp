#pragma once

#include "base/media/colour.hpp"
#include "player/playback/sample_queue.hpp"

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::player {

/// Reads one photo into a queue, in a thread of its own; failures are told, not thrown, and close
/// the queue.
class PhotoLoad {
  public:
    /// @param width, height  px that the upright picture shall have
    /// @param background     shows through where the photo is transparent
    /// @param queue  outlives this
    PhotoLoad(std::string file, int width, int height, Colour background, SampleQueue& queue);
    PhotoLoad(const PhotoLoad&) = delete;
    PhotoLoad& operator=(const PhotoLoad&) = delete;
    PhotoLoad(PhotoLoad&&) = delete;
    PhotoLoad& operator=(PhotoLoad&&) = delete;

    /// Waits for its thread: not for long after has_ended().
    ~PhotoLoad();

    int width() const { return width_; }

    int height() const { return height_; }

    bool has_ended() const { return has_ended_; }

    /// The reason why there is no picture, in plain words.
    std::optional<std::string> failure() const;

  private:
    void run(const std::string& file, int width, int height, Colour background);

    int width_;  // px that were asked for
    int height_;
    SampleQueue& queue_;  // outlives this
    std::atomic<bool> has_ended_ = false;
    mutable std::mutex mutex_;
    std::optional<std::string> failure_;  // guarded by mutex_
    std::thread thread_;                  // last: all else is there when it starts
};

}  // namespace vitrine::player
