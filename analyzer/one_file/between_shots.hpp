#pragma once

#include "base/state/record.hpp"

#include <chrono>
#include <vector>

namespace vitrine::analyzer {

/// The times at which a film shows a plain picture, and those in which nothing stands out.
class UnshownTimes {
  public:
    /// @param time  of a sample, later than the last
    void add_sample(std::chrono::nanoseconds time, bool is_plain);

    void add_empty(std::chrono::nanoseconds begin, std::chrono::nanoseconds end);

    /// The stretches of a film that its shots leave, with their kinds, in time order.
    /// @param record  with its shots and its duration
    std::vector<Stretch> between(const MediaRecord& record) const;

  private:
    std::vector<Stretch> plain_;  // in time order
    std::vector<Stretch> empty_;  // in time order
    bool is_open_ = false;        // the last plain one goes on
};

}  // namespace vitrine::analyzer
