#pragma once

#include "base/media/colour.hpp"
#include "player/playback/sample_queue.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::player {

/// The photo that is asked for.
struct PhotoWish {
    std::string file;
    int width = 0;  // px of the upright picture
    int height = 0;
    Colour background;  // behind the transparent parts of the photo
};

/// Reads one photo into a queue, in a thread of its own. Throws nothing: failure() reports, and the queue is
/// closed.
class PhotoFeed {
  public:
    PhotoFeed() = default;
    PhotoFeed(const PhotoFeed&) = delete;
    PhotoFeed& operator=(const PhotoFeed&) = delete;
    PhotoFeed(PhotoFeed&&) = delete;
    PhotoFeed& operator=(PhotoFeed&&) = delete;

    /// Does not wait for long once has_ended().
    virtual ~PhotoFeed() = default;

    /// Asks the reading to end, if that is possible.
    virtual void stop() {}

    virtual bool has_ended() const = 0;

    /// The reason why there is no picture, in plain words.
    virtual std::optional<std::string> failure() const = 0;

    /// True: the photo made its reader crash.
    virtual bool has_crashed() const { return false; }
};

/// @param queue  outlives the feed
using PhotoFactory = std::function<std::unique_ptr<PhotoFeed>(const PhotoWish&, SampleQueue& queue)>;

/// Reads a photo in this process.
/// @return BGRA of at most the size asked for
/// @throws MediaError like load_still()
Sample load_photo(const PhotoWish& wish);

/// Reads a photo in this process, in a thread of its own.
class PhotoLoad final : public PhotoFeed {
  public:
    /// @param queue  outlives this
    PhotoLoad(PhotoWish wish, SampleQueue& queue);
    PhotoLoad(const PhotoLoad&) = delete;
    PhotoLoad& operator=(const PhotoLoad&) = delete;
    PhotoLoad(PhotoLoad&&) = delete;
    PhotoLoad& operator=(PhotoLoad&&) = delete;
    ~PhotoLoad() override;

    bool has_ended() const override { return has_ended_; }

    std::optional<std::string> failure() const override;

  private:
    void run(const PhotoWish& wish);

    SampleQueue& queue_;  // outlives this
    std::atomic<bool> has_ended_ = false;
    mutable std::mutex mutex_;
    std::optional<std::string> failure_;  // guarded by mutex_
    std::thread thread_;                  // last: it uses all members above
};

}  // namespace vitrine::player
