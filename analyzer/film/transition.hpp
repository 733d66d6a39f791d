#pragma once

#include "base/state/record.hpp"

#include <chrono>

namespace vitrine::analyzer {

/// The time between two shots, half-open in stream time: a cut is empty, [t, t) with t the new shot's first
/// frame; a dissolve or fade holds the frames that belong to neither shot.
struct Transition {
    std::chrono::nanoseconds begin{0};
    std::chrono::nanoseconds end{0};
    ShotEnd kind = ShotEnd::cut;
};

}  // namespace vitrine::analyzer
