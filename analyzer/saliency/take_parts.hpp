#pragma once

#include "analyzer/saliency/sample.hpp"

#include <chrono>
#include <span>
#include <vector>

namespace vitrine::analyzer {

/// A part of one take, half-open [begin, end) in stream time.
struct TakePart {
    std::chrono::nanoseconds begin{0};
    std::chrono::nanoseconds end{0};
    bool is_empty = false;  // for seconds nothing moves, though something does elsewhere in the take

    bool operator==(const TakePart&) const = default;
};

/// The share of the picture that changes between two samples' pictures.
/// @param before, now  CV_8UC3 of any sizes, not empty
double changed_share(const cv::Mat& before, const cv::Mat& now);

/// Splits a take longer than 10 s: first into stretches in which something moves or a face is seen, and empty
/// ones; then what is still longer where the places that matter change most. A take in which nothing moves at
/// all is one part.
/// @param samples  of the take, in time order
std::vector<TakePart> take_parts(std::span<const Sample> samples, std::chrono::nanoseconds begin,
                                 std::chrono::nanoseconds end);

}  // namespace vitrine::analyzer
