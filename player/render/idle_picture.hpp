#pragma once

#include "base/geometry/box.hpp"
#include "player/render/gl_objects.hpp"

#include <chrono>

namespace vitrine::player {

/// The picture of a wall that has nothing to show: slow lights over a dark sky, without words, never still
/// and never black. The lights are computed at the corners of a coarse grid and interpolated, so the picture
/// costs little more than filling the screen, even without a graphics card.
class IdlePicture {
  public:
    IdlePicture();

    /// Fills the canvas, or the part of it that the scissor allows.
    ///
    /// @param time     moves the lights; equal times give equal pictures
    /// @param opacity  in [0, 1], over the pixels that are there
    /// @param part     canvas px; the picture is drawn only between its top and its bottom
    void draw(Vec2 canvas, const ToNdc& view, std::chrono::nanoseconds time, double opacity,
              const Box& part) const;

  private:
    GlProgram program_;
    GlBuffer corners_;
    GlBuffer order_;
    GlVertexArray grid_;
    ViewUniforms view_;
    GLint canvas_;
    GLint seconds_;
    GLint opacity_;
};

}  // namespace vitrine::player
