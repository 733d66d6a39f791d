#pragma once

#include "player/render/cell_mesh.hpp"
#include "player/render/gl_objects.hpp"
#include "player/render/picture_program.hpp"
#include "player/render/uploaded_pictures.hpp"
#include "player/render/view.hpp"
#include "player/scene/frame.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>

namespace vitrine::player {

/// The meshes of cells on the graphics card, made when a cell is first drawn.
class CellMeshes {
  public:
    struct Mesh {
        std::shared_ptr<const Cell> cell;  // shared, so that no other cell gets its address meanwhile
        GlBuffer vertices;
        GlVertexArray array;
        CellMesh::Layer parts;
        CellMesh::Layer filler;
        std::uint64_t last_drawn = 0;
    };

    const Mesh& of(const std::shared_ptr<const Cell>& cell);

    /// Drops meshes that have not been drawn for a while. Call once a frame.
    void drop_old();

  private:
    std::uint64_t frames_ = 0;
    std::unordered_map<const Cell*, Mesh> meshes_;
};

/// Draws pictures into their cells: outlines, fills and fringes (cell_mesh.hpp). Belongs to a Renderer.
class CellLayer {
  public:
    /// @param pictures  outlives this
    explicit CellLayer(UploadedPictures& pictures) : pictures_(pictures) {}

    /// True if draw() fills a part of the item's cell with its blurred picture.
    bool has_filler(const DrawItem& item);

    /// Draws a run of items of one opacity. They form one layer of cells that meet in seams. Items without a
    /// picture are left out.
    /// @param is_on_pixels  in this frame, canvas points with whole numbers are corners of pixels
    void draw(std::span<const DrawItem> items, const ToNdc& view, bool is_on_pixels);

    /// Drops meshes that have not been drawn for a while. Call once a frame.
    void drop_old() { meshes_.drop_old(); }

  private:
    void draw_outlines(const DrawItem& item, const ToNdc& view);
    void draw_fills(const DrawItem& item, const ToNdc& view);
    void draw_fringes(const DrawItem& item, const ToNdc& view);
    void draw_range(const PictureProgram& program, const DrawItem& item, const ToNdc& view, GLenum mode,
                    CellMesh::Range range);
    const PicturePrograms& programs(const DrawItem& item);
    Vec2 slide_of(const DrawItem& item) const;
    bool is_exact(const PictureTexture& texture, const DrawItem& item) const;

    UploadedPictures& pictures_;  // outlives this
    CellMeshes meshes_;
    std::array<std::optional<PicturePrograms>, 4> programs_;  // by layout; each is made when first needed
    bool is_on_pixels_ = true;
};

}  // namespace vitrine::player
