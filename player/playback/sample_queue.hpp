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
    std::uint64_t loop = 0;                // number of times that the shot had been played whole before
    std::chrono::nanoseconds duration{0};  // the time that this picture is shown
};

/// Thread-safe. Pictures in the order in which they are to be shown, from the thread that decodes to the one
/// that shows. It is bounded, which keeps a decoder from running ahead, and it bridges the seam between two
/// loops.
class SampleQueue {
  public:
    explicit SampleQueue(std::size_t capacity) : capacity_(capacity) {}

    /// Waits while the queue is full. False: closed; the picture is dropped.
    bool put(LoopedSample sample);

    /// The oldest picture where it fits, else nothing, without waiting.
    std::optional<LoopedSample> take_if(const std::function<bool(const LoopedSample&)>& fits);

    /// @param refuses  true: put() drops pictures without waiting, also one that waits by now
    void refuse(bool refuses);

    bool is_empty() const;

    /// Waits until there is a picture. False: none in time, or closed.
    bool wait(std::chrono::nanoseconds patience) const;

    /// Ends all waiting; nothing can be put any more. Pictures in the queue can still be taken.
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
