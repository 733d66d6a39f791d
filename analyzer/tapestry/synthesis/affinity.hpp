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
    /// @param frames  of the film
    /// @param band    frames to either side that are compared
    Affinity(int frames, int band);

    int frames() const { return frames_; }

    int band() const { return band_; }

    float far() const { return far_; }

    void set_far(float far) { far_ = far; }

    /// A_ij: what it costs to show frame i by frame j. Source: Video Tapestries 4.1, eq. 3.
    float at(int i, int j) const { return is_near(i, j) ? costs_[place(i, j)] : far_; }

    void set(int i, int j, float cost) { costs_[place(i, j)] = cost; }

    /// The frames that j can show: [first(j), last(j)), and what they cost, A_ij for each of them.
    int first(int j) const { return j > band_ ? j - band_ : 0; }

    int last(int j) const { return j + band_ < frames_ ? j + band_ + 1 : frames_; }

    std::span<const float> shown_by(int j) const {
        return {&costs_[place(first(j), j)], static_cast<std::size_t>(last(j) - first(j))};
    }

  private:
    bool is_near(int i, int j) const { return i >= first(j) && i < last(j); }

    std::size_t place(int i, int j) const {  // column by column, so that what a frame shows lies together
        return as_index(j) * as_index(2 * band_ + 1) + as_index(i - j + band_);
    }

    int frames_;
    int band_;
    float far_ = 0;
    std::vector<float> costs_;
};

struct AffinitySettings {
    std::chrono::seconds time_scale{
        60};              // T_b: at this distance time costs as much as a usual pair of frames
    int band_scales = 4;  // times T_b is the band's half width: there time alone costs 16 usual pairs
};

/// Eq. 3 for all pairs of frames in the band: for each 7 x 7 patch of frame i the colour distance to its
/// nearest patch of frame j, exact, the mean over the patches; and alpha (tau_i - tau_j)^2. Colour is squared
/// difference a channel value, [0, 16129]; a difference beyond 127 counts as 127. alpha is the median colour
/// distance over T_b^2.
///
/// @param frames  in time order
/// Source: Video Tapestries 4.1, eq. 3. All displacements of one frame over the other are gone through, with
/// sliding sums, for sixteen frames j at once.
Affinity affinity(std::span<const FrameSignature> frames, const AffinitySettings& settings = {},
                  const RunTasks& run = run_in_order);

/// Time alone: what uniform sampling minimises. Costs nothing to compute.
Affinity time_affinity(std::span<const FrameSignature> frames, const AffinitySettings& settings = {});

}  // namespace vitrine::analyzer
