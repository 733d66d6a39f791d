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

/// Brings the target at one size towards the least energy.
class Synthesis {
  public:
    /// @param window  outlives this
    /// @param target  CV_8UC3, the first guess
    Synthesis(const BrickWindow& window, const cv::Mat& target, KnownPart known, const RunTasks& run);

    Synthesis(const Synthesis&) = delete;
    Synthesis& operator=(const Synthesis&) = delete;
    ~Synthesis() = default;

    /// Matches each patch with the one at the same column and at the same share of the height.
    void match_by_place();

    /// Matches each patch with the one in the same column that it was kept from, or beside which it was lost.
    void match_kept(const KeptRows& kept);

    /// Takes the matches of a synthesis of the same tile at another size.
    void match_like(const Synthesis& other);

    /// Does one round: searches within `radius` px, then makes the target that costs least for the matches
    /// found.
    /// @return the energy before the target changed
    double step(int radius, std::uint32_t seed);

    /// The energy after a step, with target and matches as they are.
    double energy();

    /// The energy of the target after `rounds` searches: close to the exact one, and computed far sooner.
    double searched_energy(int radius, int rounds);

    /// The energy with the nearest of all patches for each, found by trying all: for tests and small
    /// pictures.
    double exact_energy();

    /// Makes the target that follows from the matches alone.
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
