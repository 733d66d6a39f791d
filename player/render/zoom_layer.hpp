#pragma once

#include "player/render/gl_objects.hpp"
#include "player/scene/frame.hpp"

#include <memory>
#include <unordered_map>

namespace vitrine::player {

/// Draws tiles of tapestries on the way from one level to the next. The graphics card has both places of each
/// point, so a moment in between costs only a few numbers. Belongs to a Renderer.
class ZoomLayer {
  public:
    ZoomLayer();

    /// @pre item.zoom; the tile's picture is bound
    void draw(const DrawItem& item, const ToNdc& view);

    /// Drops meshes that have not been drawn for a while. Call once a frame.
    void drop_old();

  private:
    struct Mesh {
        std::shared_ptr<const ZoomMesh> zoom;  // shared, so that no other mesh gets its address meanwhile
        GlBuffer vertices;
        GlBuffer triangles;
        GlVertexArray array;
        int unused = 0;  // frames since the last use
    };

    struct MeshProgram {
        explicit MeshProgram(const char* fragment_shader);

        GlProgram program;
        ViewUniforms view;
        GLint offset;
        GLint scale;
        GLint share;
        GLint alpha;  // -1: the program draws opaque
    };

    Mesh& mesh(const std::shared_ptr<const ZoomMesh>& zoom);

    MeshProgram whole_;    // draws opaque
    MeshProgram blended_;  // draws each point with its own opacity
    std::unordered_map<const ZoomMesh*, Mesh> meshes_;
};

}  // namespace vitrine::player
