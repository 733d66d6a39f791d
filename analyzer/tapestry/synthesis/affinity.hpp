#pragma once

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/synthesis/frame_signature.hpp"
#include "analyzer/tapestry/synthesis/run_tasks.hpp"

#include <chrono>
#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::analyzer {

/// The cost of showing each frame by another, in a band along the diagonal; outside the band it is `far()`.
class Affinity {
  public:
    /// @param frames  number of frames of the film
    /// @param band    number of frames to either side that each frame is compared with
    Affinity(int frames, int band);

    int frames() const { return frames_; }

    int band() const { return band_; }

    float far() const { return far_; }

    void set_far(float far) { far_ = far; }

    /// A_ij: the cost of showing frame i by frame j. Source: Video Tapestries 4.1, eq. 3.
    float at(int i, int j) const { return is_near(i, j) ? costs_[place(i, j)] : far_; }

    void set(int i, int j, float cost) { costs_[place(i, j)] = cost; }

    /// Frame j can show the frames [first(j), last(j)). shown_by(j) holds A_ij for each of them.
    int first(int j) const { return j > band_ ? j - band_ : 0; }

    int last(int j) const { return j + band_ < frames_ ? j + band_ + 1 : frames_; }

    std::span<const float> shown_by(int j) const {
        return {&costs_[place(first(j), j)], static_cast<std::size_t>(last(j) - first(j))};
    }

  private:
    bool is_near(int i, int j) const { return i >= first(j) && i < last(j); }

    std::size_t place(int i, int j) const {  // column by column, so that the costs of one j lie together
        return as_index(j) * as_index(2 * band_ + 1) + as_index(i - j + band_);
    }

    int frames_;
    int band_;
    float far_ = 0;
    std::vector<float> costs_;
};

struct AffinitySettings {
    std::chrono::seconds time_scale{60};  // T_b: at this distance time costs as much as a median pair
    int band_scales = 4;  // the band's half width in T_b: at its edge time alone costs 16 median pairs
};

/// Computes eq. 3 for all pairs of frames in the band: the colour distance plus alpha (tau_i - tau_j)^2. The
/// colour distance is the mean over all 7 x 7 patches of frame i of the exact distance to the nearest patch
/// of frame j. It counts squared differences a channel value, [0, 16129]; a difference beyond 127 counts as
/// 127. alpha is the median colour distance over T_b^2.
///
/// @param frames  in time order
/// Source: Video Tapestries 4.1, eq. 3. Every displacement of one frame over the other is tried, with sliding
/// sums, for sixteen frames j at once.
Affinity affinity(std::span<const FrameSignature> frames, const AffinitySettings& settings = {},
                  const RunTasks& run = run_in_order);

/// Computes eq. 3 from time alone, which uniform sampling minimises. Compares no pictures.
Affinity time_affinity(std::span<const FrameSignature> frames, const AffinitySettings& settings = {});

}  // namespace vitrine::analyzer
