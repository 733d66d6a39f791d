#pragma once

#include "player/playback/sample.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

namespace vitrine::player {

/// A picture of a shot that plays in a loop.
struct LoopedSample {
    Sample sample;
    std::uint64_t loop = 0;                // how often the shot had been played whole before
    std::chrono::nanoseconds duration{0};  // of this picture
};

/// Thread-safe. Pictures in the order they are to be shown, from the thread that decodes to the one that
/// shows. Bounded: it is what keeps a decoder from running ahead, and what bridges the seam of a loop.
class SampleQueue {
  public:
    explicit SampleQueue(std::size_t capacity) : capacity_(capacity) {}

    /// Waits while the queue is full. False: closed; the picture is dropped.
    bool put(LoopedSample sample);

    /// The oldest picture where it fits, else nothing, without waiting.
    std::optional<LoopedSample> take_if(const std::function<bool(const LoopedSample&)>& fits);

    /// Whether pictures are dropped instead of put, without waiting; true wakes who waits to put.
    void refuse(bool refuses);

    bool is_empty() const;

    /// Waits until there is a picture. False: none in time, or closed.
    bool wait(std::chrono::nanoseconds patience) const;

    /// Wakes all who wait; nothing can be put any more. What is in it can still be taken.
    void close();

    bool is_closed() const;

  private:
    std::size_t capacity_;
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::deque<LoopedSample> samples_;  // guarded by mutex_
    bool is_refusing_ = false;          // guarded by mutex_
    bool is_closed_ = false;            // guarded by mutex_
};

}  // namespace vitrine::player
