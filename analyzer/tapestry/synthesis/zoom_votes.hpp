#pragma once

#include "analyzer/tapestry/synthesis/patch_match.hpp"

#include <vector>

namespace vitrine::analyzer {

/// The votes of patches on a picture's pixels: sums of B, G, R and of the weights, a pixel.
class ZoomVotes {
  public:
    ZoomVotes(int width, int height);

    /// @param of_target  the picture's patches; those without a match have no vote
    /// @param source     the picture in which they are matched
    /// @param weights    one a patch of the picture
    void add(const MatchField& of_target, const PatchImage& source, const std::vector<float>& weights,
             const RunTasks& run);

    /// The sums of a pixel's votes: B, G, R and the weights; all 0 where it has none.
    const float* sums(int x, int y) const {
        return &sums_[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(x))];
    }

  private:
    int width_;
    int height_;
    std::vector<float> sums_;
};

}  // namespace vitrine::analyzer
