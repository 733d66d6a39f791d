#pragma once

#include "analyzer/saliency/sample.hpp"

#include <cstddef>
#include <deque>
#include <vector>

namespace vitrine::analyzer {

/// The samples of the shot that is still open, bounded however long it lasts.
///
/// The newest `recent` samples are all kept, for a boundary found among them opens a new shot. Of the older
/// ones every stride-th is kept; when more than `most_settled` are, the stride doubles and every second one
/// goes, so that those left stay evenly spread over the shot.
class SampleStore {
  public:
    static constexpr std::size_t recent =
        64;  // 13 s at 5 a second, longer than any transition takes to be told
    static constexpr std::size_t most_settled = 192;

    /// @param sample  later than all before
    void push(Sample sample);

    /// Takes the samples with begin <= time < end out, in time order; earlier ones are dropped, later ones
    /// stay.
    std::vector<Sample> take(std::chrono::nanoseconds begin, std::chrono::nanoseconds end);

    std::size_t size() const { return settled_.size() + recent_.size(); }

  private:
    struct Settled {
        std::size_t number = 0;  // of all samples since the last take()
        Sample sample;
    };

    void settle(Sample sample);

    std::deque<Sample> recent_;
    std::vector<Settled> settled_;
    std::size_t count_ = 0;  // samples that left recent_ since the last take()
    std::size_t stride_ = 1;
};

}  // namespace vitrine::analyzer
