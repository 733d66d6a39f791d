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
    std::uint64_t loop = 0;                // number of complete loops before this one
    std::chrono::nanoseconds duration{0};  // the time for which this picture is shown
};

/// Thread-safe. Carries pictures, in the order of showing, from the decoding thread to the thread that shows
/// them. Its capacity keeps a decoder from running ahead. Its pictures bridge the seam between two loops.
class SampleQueue {
  public:
    explicit SampleQueue(std::size_t capacity) : capacity_(capacity) {}

    std::size_t capacity() const { return capacity_; }

    /// Waits while the queue is full. False: the queue is closed and the picture is dropped.
    bool put(LoopedSample sample);

    /// Takes the oldest picture if `fits` accepts it; else none. Does not wait.
    std::optional<LoopedSample> take_if(const std::function<bool(const LoopedSample&)>& fits);

    /// @param refuses  true: put() drops pictures without waiting, even in a call that is waiting already
    void refuse(bool refuses);

    bool is_empty() const;

    /// Waits for a picture. False: none came in time, or the queue is closed.
    bool wait(std::chrono::nanoseconds patience) const;

    /// Ends all waiting. put() then drops pictures; pictures in the queue can still be taken.
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
