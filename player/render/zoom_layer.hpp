#pragma once

#include "player/render/gl_objects.hpp"
#include "player/render/view_uniforms.hpp"
#include "player/scene/frame.hpp"

#include <memory>
#include <unordered_map>

namespace vitrine::player {

/// Draws tiles of tapestries on their way from level to level. The graphics card has both places of each
/// point; a moment in between costs a few numbers. Belongs to a Renderer.
class ZoomLayer {
  public:
    ZoomLayer();

    /// @pre item.zoom; the tile's picture is bound
    void draw(const DrawItem& item, const ToNdc& view);

    /// Drops meshes that have not been drawn for a while; to be called once a frame.
    void drop_old();

  private:
    struct Mesh {
        std::shared_ptr<const ZoomMesh> zoom;  // shared: while it lives no other has its address
        GlBuffer vertices;
        GlBuffer triangles;
        GlVertexArray array;
        int unused = 0;  // frames
    };

    struct MeshProgram {
        explicit MeshProgram(const char* fragment_shader);

        GlProgram program;
        ViewUniforms view;
        GLint offset;
        GLint scale;
        GLint share;
        GLint alpha;  // -1: it draws whole
    };

    Mesh& mesh(const std::shared_ptr<const ZoomMesh>& zoom);

    MeshProgram whole_;    // lets nothing through
    MeshProgram blended_;  // lets through as much as each point says
    std::unordered_map<const ZoomMesh*, Mesh> meshes_;
};

}  // namespace vitrine::player
