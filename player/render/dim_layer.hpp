#pragma once

#include "player/render/gl_objects.hpp"

namespace vitrine::player {

/// Takes light from all that was drawn. Belongs to a Renderer.
class DimLayer {
  public:
    DimLayer();

    /// @param light  the share that stays, [0, 1)
    void draw(double light);

  private:
    GlProgram program_;
    GlVertexArray nothing_;
    GLint shade_;
};

}  // namespace vitrine::player
