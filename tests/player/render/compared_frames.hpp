#pragma once

#include "player/display/egl.hpp"
#include "player/render/renderer.hpp"
#include "tests/player/render/random_frame.hpp"
#include "tests/player/render/reference_compositor.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace vitrine::player {

/// The largest differences between a frame of the renderer and the same frame of the reference, in steps of
/// 8 bits. Those of single pixels count for smooth pictures only.
///
/// One step is taken off for each translucent triangle on a pixel, in the mean of a block for each after the
/// first: GL rounds the colour that a sampler reads, and at each blend colour and opacity again. The
/// reference cannot know which way.
struct Deviation {
    double grey = 0;      // of the brightness of a pixel that is not at an edge
    double colour = 0;    // of a channel of such a pixel
    double at_edges = 0;  // of a channel of a pixel at an edge from all that the reference drew within 1 px
    double blocks = 0;    // of the mean of a channel in a block of 16 x 16 px, without edges
    std::string place;    // of the largest one

    double worst() const;

    /// True if the renderer draws as it should.
    bool is_good() const { return grey <= 2 && colour <= 3 && at_edges <= 3 && blocks <= 2; }
};

Deviation deviation(const Picture& drawn, const ReferenceImage& expected, bool is_noise);

/// Draws random frames with one renderer and with the reference.
class ComparedFrames {
  public:
    Deviation compare(std::uint64_t seed, int max_side);

    /// The frame that the renderer drew last, and the reference's.
    const Picture& drawn() const { return drawn_; }

    const ReferenceImage& expected() const { return expected_; }

  private:
    std::shared_ptr<Egl> egl_ = std::make_shared<Egl>(Egl::surfaceless());  // shared with the screens
    Renderer renderer_{1, 1};
    Picture drawn_;
    ReferenceImage expected_;
};

}  // namespace vitrine::player
