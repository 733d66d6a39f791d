#pragma once

#include "player/display/egl.hpp"
#include "player/render/renderer.hpp"
#include "tests/player/render/random_frame.hpp"
#include "tests/player/render/reference_compositor.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>

namespace vitrine::player {

/// Features of a frame that let a renderer be further off.
struct FrameKind {
    bool has_planes = false;
    int blends = 0;  // translucent pictures over one another
};

/// The largest differences between a frame of the renderer and the same frame of the reference, in steps of
/// 8 bits. Those of single pixels count for smooth pictures only.
struct Deviation {
    double grey = 0;      // of the brightness of a pixel that is not at an edge, but for one stray pixel
    double colour = 0;    // of a channel of such a pixel
    double stray = 0;     // of a channel of the stray pixel
    double at_edges = 0;  // of a channel of a pixel at an edge from all that the reference drew within 1 px
    double blocks = 0;    // of the mean of a channel in a block of 16 x 16 px, without edges
    std::string place;    // of the largest one

    double worst() const;

    /// True if the renderer draws as it should. The largest brightness is mostly below 2; samplers may pick
    /// another smaller copy. Planes may be further off: each is read in steps of 8 bits, and a step of a
    /// colour difference is two steps of blue. A sampler in steps of 8 bits is off by up to 1 in the mean,
    /// and so is each blend over it, whose opacity has 8 bits, too; a block is off by half a step more where
    /// all of it is rounded alike. One pixel of a frame may stray: GL puts corners on a grid of 1/256 px, so
    /// that a pixel whose centre lies on the side of a triangle may belong to none, or to both.
    bool is_good(const FrameKind& kind) const {
        const double channel = kind.has_planes ? 6 : 4;
        return grey <= (kind.has_planes ? 3.5 : 3) && colour <= channel && at_edges <= channel &&
               blocks <= std::max(2, 1 + kind.blends) + 0.5;
    }
};

Deviation deviation(const Picture& drawn, const ReferenceImage& expected, bool is_noise);

/// Draws random frames with one renderer and with the reference.
class ComparedFrames {
  public:
    Deviation compare(std::uint64_t seed, int max_side);

    /// The kind of the last frame.
    const FrameKind& kind() const { return kind_; }

    /// The frame that the renderer drew last, and the reference's.
    const Picture& drawn() const { return drawn_; }

    const ReferenceImage& expected() const { return expected_; }

  private:
    std::shared_ptr<Egl> egl_ = std::make_shared<Egl>(Egl::surfaceless());  // shared with the screens
    Renderer renderer_{1, 1};
    FrameKind kind_;
    Picture drawn_;
    ReferenceImage expected_;
};

}  // namespace vitrine::player
