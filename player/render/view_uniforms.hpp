#pragma once

#include "player/render/gl_objects.hpp"
#include "player/render/view.hpp"

namespace vitrine::player {

/// A program's uniforms for the place of the canvas: `uniform vec2 x_axis, y_axis, origin`.
struct ViewUniforms {
    explicit ViewUniforms(const GlProgram& program)
        : x_axis(program.uniform("x_axis")),
          y_axis(program.uniform("y_axis")),
          origin(program.uniform("origin")) {}

    /// @pre the program is in use
    void set(const ToNdc& view) const {
        vitrine::player::set(x_axis, view.x_axis);
        vitrine::player::set(y_axis, view.y_axis);
        vitrine::player::set(origin, view.origin);
    }

    GLint x_axis;
    GLint y_axis;
    GLint origin;
};

}  // namespace vitrine::player
