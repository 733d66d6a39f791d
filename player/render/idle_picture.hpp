#pragma once

#include "base/geometry/box.hpp"
#include "player/render/gl_objects.hpp"
#include "player/render/view_uniforms.hpp"

#include <chrono>

namespace vitrine::player {

/// The picture of a wall that has nothing to show: slow lights over a dark sky, without words, never still
/// and never black. The lights are computed at the corners of a coarse grid and come to the pixels by
/// interpolation, so that it costs little more than filling the screen, also without a graphics card.
class IdlePicture {
  public:
    IdlePicture();

    /// Fills the canvas, or as much of it as the scissor lets through.
    ///
    /// @param time     moves the lights; equal times give equal pictures
    /// @param opacity  over what is there, in [0, 1]
    /// @param part     canvas px; nothing is seen above it, nor below
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
