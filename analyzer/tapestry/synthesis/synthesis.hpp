#pragma once

#include "analyzer/tapestry/synthesis/brickwork.hpp"
#include "analyzer/tapestry/synthesis/carve.hpp"
#include "analyzer/tapestry/synthesis/patch_match.hpp"

#include <memory>

namespace vitrine::analyzer {

/// The fixed part of a target: pixels of `picture` where `share` says so.
struct KnownPart {
    cv::Mat picture;  // CV_8UC3, of the target's size, or empty
    cv::Mat share;    // CV_32FC1 in [0, 1]; 1: the pixel is the picture's, 0: free
};

/// The target at one size, on its way to the least energy.
class Synthesis {
  public:
    /// @param window  outlives this
    /// @param target  CV_8UC3, the first guess
    Synthesis(const BrickWindow& window, const cv::Mat& target, KnownPart known, const RunTasks& run);

    Synthesis(const Synthesis&) = delete;
    Synthesis& operator=(const Synthesis&) = delete;
    ~Synthesis() = default;

    /// Each patch matched with the one at the same share of width and height.
    void match_by_place();

    /// Each patch matched with the one at the same column from which it was kept, or next to which it was
    /// lost.
    void match_kept(const KeptRows& kept);

    /// Matches of a synthesis of another size, of the same tile.
    void match_like(const Synthesis& other);

    /// One round: a search of `radius` px, then the target that costs least for what it found.
    /// @return the energy before the target changed
    double step(int radius, std::uint32_t seed);

    /// After a step: the energy of the target as it is, with matches as they are.
    double energy();

    /// The energy of the target as it is after so many searches: near the exact one, and far sooner had.
    double searched_energy(int radius, int rounds);

    /// The energy with the nearest of all patches for each, found by trying all: for tests and small
    /// pictures.
    double exact_energy();

    /// The target that follows from the matches alone.
    void take_votes();

    cv::Mat picture() const { return target_.bgr(); }

  private:
    void fix_known();

    const BrickWindow& window_;
    PatchImage target_;
    KnownPart known_;
    const RunTasks& run_;  // outlives this
    PatchMatch matches_;
};

}  // namespace vitrine::analyzer
