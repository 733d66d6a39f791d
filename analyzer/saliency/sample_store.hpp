#pragma once

#include "analyzer/saliency/sample.hpp"

#include <cstddef>
#include <deque>
#include <vector>

namespace vitrine::analyzer {

/// The samples of the shot that is still open, bounded however long it lasts.
///
/// The newest `recent` samples are all kept, for a boundary found among them opens a new shot. Every
/// stride-th of the older ones is kept; when they are more than `max_settled`, the stride doubles and every
/// second one is dropped, so that the rest stays evenly spread over the shot.
class SampleStore {
  public:
    // 13 s at 5 a second, longer than it takes to find any transition
    static constexpr std::size_t recent = 64;
    static constexpr std::size_t max_settled = 192;

    /// @param sample  later than all before
    void push(Sample sample);

    /// Removes and returns the samples with begin <= time < end, in time order; drops earlier ones; later
    /// ones stay.
    std::vector<Sample> pop_samples(std::chrono::nanoseconds begin, std::chrono::nanoseconds end);

    std::size_t size() const { return settled_.size() + recent_.size(); }

  private:
    struct Settled {
        std::size_t number = 0;  // count of samples since the last pop_samples()
        Sample sample;
    };

    void settle(Sample sample);

    std::deque<Sample> recent_;
    std::vector<Settled> settled_;
    std::size_t count_ = 0;  // samples that left recent_ since the last pop_samples()
    std::size_t stride_ = 1;
};

}  // namespace vitrine::analyzer
