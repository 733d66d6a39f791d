#include "analyzer/saliency/sample_store.hpp"

#include <utility>

namespace vitrine::analyzer {

void SampleStore::push(Sample sample) {
    recent_.push_back(std::move(sample));
    if (recent_.size() <= recent) return;
    settle(std::move(recent_.front()));
    recent_.pop_front();
}

void SampleStore::settle(Sample sample) {
    const std::size_t number = count_++;
    if (number % stride_ != 0) return;
    settled_.push_back({number, std::move(sample)});
    if (settled_.size() <= max_settled) return;
    stride_ *= 2;
    std::erase_if(settled_, [this](const Settled& s) { return s.number % stride_ != 0; });
}

std::vector<Sample> SampleStore::pop_samples(std::chrono::nanoseconds begin, std::chrono::nanoseconds end) {
    std::vector<Sample> taken;
    for (Settled& s : settled_) {
        if (s.sample.time >= begin && s.sample.time < end) taken.push_back(std::move(s.sample));
    }
    // A boundary is found while its samples are recent, so no settled sample belongs to the next shot.
    settled_.clear();
    count_ = 0;
    stride_ = 1;
    while (!recent_.empty() && recent_.front().time < end) {
        if (recent_.front().time >= begin) taken.push_back(std::move(recent_.front()));
        recent_.pop_front();
    }
    return taken;
}

}  // namespace vitrine::analyzer
