#pragma once

#include "analyzer/film/film_frame.hpp"
#include "base/state/record.hpp"

#include <memory>
#include <vector>

namespace vitrine::analyzer {

/// A stretch of one take, or of several short ones cut to each other, half-open [begin, end) in stream time.
/// The time between two shots is transition.
struct DetectedShot {
    std::chrono::nanoseconds begin{0};
    std::chrono::nanoseconds end{0};
    ShotEnd ends_with = ShotEnd::end;

    bool operator==(const DetectedShot&) const = default;
};

/// Finds cuts, dissolves and fades in a stream of frames with bounded memory.
/// Source: Dynamic Media Assemblage 3.1 (Lienhart's colour histogram differences).
class ShotDetector {
  public:
    ShotDetector();
    ~ShotDetector();
    ShotDetector(const ShotDetector&) = delete;
    ShotDetector& operator=(const ShotDetector&) = delete;

    /// @param frame  later than the one before, of the same size
    /// @return       the shots that this frame shows to be over, in time order; mostly none
    std::vector<DetectedShot> push(const FilmFrame& frame);

    /// The shots still open. @param end  end of the last frame
    std::vector<DetectedShot> finish(std::chrono::nanoseconds end);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::analyzer
