#include "player/playback/sample_queue.hpp"

#include <utility>

namespace vitrine::player {

bool SampleQueue::put(LoopedSample sample) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_closed_ || is_refusing_ || samples_.size() < capacity_; });
    if (is_closed_) return false;
    if (is_refusing_) return true;
    samples_.push_back(std::move(sample));
    changed_.notify_all();
    return true;
}

std::optional<LoopedSample> SampleQueue::take_if(const std::function<bool(const LoopedSample&)>& fits) {
    const std::lock_guard lock(mutex_);
    if (samples_.empty() || !fits(samples_.front())) return std::nullopt;
    LoopedSample sample = std::move(samples_.front());
    samples_.pop_front();
    changed_.notify_all();
    return sample;
}

void SampleQueue::refuse(bool refuses) {
    const std::lock_guard lock(mutex_);
    is_refusing_ = refuses;
    changed_.notify_all();
}

bool SampleQueue::is_empty() const {
    const std::lock_guard lock(mutex_);
    return samples_.empty();
}

bool SampleQueue::wait(std::chrono::nanoseconds patience) const {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] { return is_closed_ || !samples_.empty(); });
    return !samples_.empty();
}

void SampleQueue::close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
}

bool SampleQueue::is_closed() const {
    const std::lock_guard lock(mutex_);
    return is_closed_;
}

}  // namespace vitrine::player
