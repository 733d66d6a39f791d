#include "player/render/cell_layer.hpp"

#include <cmath>

namespace vitrine::player {

namespace {

constexpr double fringe_width = 1;         // canvas px
constexpr double same_size = 0.75;         // canvas px of difference at which pictures count as of equal size
constexpr std::uint64_t kept_unused = 15;  // frames that a cell's vertices are kept after their last use

bool is_opaque(const DrawItem& item) {
    return item.alpha >= 1;
}

}  // namespace

const CellMeshes::Mesh& CellMeshes::of(const std::shared_ptr<const Cell>& cell) {
    const auto [place, is_new] = meshes_.try_emplace(cell.get());
    Mesh& mesh = place->second;
    mesh.last_drawn = frames_;
    if (!is_new) return mesh;

    const CellMesh cut = cell_mesh(*cell, fringe_width);
    mesh.cell = cell;
    mesh.parts = cut.parts;
    mesh.filler = cut.filler;
    glBindVertexArray(mesh.array.id());
    glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(cut.vertices.size() * sizeof(CellMesh::Vertex)),
                 cut.vertices.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    return mesh;
}

void CellMeshes::drop_old() {
    std::erase_if(meshes_,
                  [&](const auto& entry) { return frames_ - entry.second.last_drawn > kept_unused; });
    ++frames_;
}

bool CellLayer::has_filler(const DrawItem& item) {
    const CellMesh::Layer& filler = meshes_.of(item.cell).filler;
    return filler.outline.count + filler.triangles.count + filler.fringe.count > 0;
}

void CellLayer::draw(std::span<const DrawItem> items, const ToNdc& view, bool is_on_pixels) {
    is_on_pixels_ = is_on_pixels;
    const auto for_each = [&](auto draw_it) {
        for (const DrawItem& item : items)
            if (pictures_.has(item.source) && item.alpha > 0) (this->*draw_it)(item, view);
    };
    if (is_opaque(items.front())) {
        glDisable(GL_BLEND);
        for_each(&CellLayer::draw_outlines);
        for_each(&CellLayer::draw_fills);
        glEnable(GL_BLEND);
    } else {
        glEnable(GL_BLEND);
        for_each(&CellLayer::draw_fills);
    }
    for_each(&CellLayer::draw_fringes);
}

void CellLayer::draw_outlines(const DrawItem& item, const ToNdc& view) {
    const CellMeshes::Mesh& mesh = meshes_.of(item.cell);
    draw_range(programs(item).filler, item, view, GL_TRIANGLES, mesh.filler.outline);
    draw_range(programs(item).opaque, item, view, GL_TRIANGLES, mesh.parts.outline);
}

void CellLayer::draw_fills(const DrawItem& item, const ToNdc& view) {
    const CellMeshes::Mesh& mesh = meshes_.of(item.cell);
    const PicturePrograms& of_item = programs(item);
    draw_range(of_item.filler, item, view, GL_TRIANGLES, mesh.filler.triangles);
    draw_range(is_opaque(item) ? of_item.opaque : of_item.blended, item, view, GL_TRIANGLES,
               mesh.parts.triangles);
}

void CellLayer::draw_fringes(const DrawItem& item, const ToNdc& view) {
    const CellMeshes::Mesh& mesh = meshes_.of(item.cell);
    draw_range(programs(item).filler, item, view, GL_TRIANGLES, mesh.filler.fringe);
    draw_range(programs(item).blended, item, view, GL_TRIANGLES, mesh.parts.fringe);
}

void CellLayer::draw_range(const PictureProgram& program, const DrawItem& item, const ToNdc& view,
                           GLenum mode, CellMesh::Range range) {
    if (range.count == 0) return;
    PictureTexture& whole = pictures_.at(item.source);
    PictureTexture& texture = program.is_filler() ? whole.reduced() : whole;
    const bool is_one_to_one = !program.is_filler() && is_exact(texture, item);
    glBindVertexArray(meshes_.of(item.cell).array.id());
    texture.bind_sampled(program.is_filler() ? Sampling::filler
                         : is_one_to_one     ? Sampling::exact
                                             : Sampling::smooth);
    program.use(item, {.texture = texture, .slide = slide_of(item), .is_exact = is_one_to_one}, view);
    glDrawArrays(mode, range.first, range.count);
}

Vec2 CellLayer::slide_of(const DrawItem& item) const {
    return pictures_.slide(item.source) * item.slide_share;
}

const PicturePrograms& CellLayer::programs(const DrawItem& item) {
    const PixelLayout layout = pictures_.at(item.source).layout();
    std::optional<PicturePrograms>& programs = programs_.at(static_cast<std::size_t>(layout));
    if (!programs) programs.emplace(layout);
    return *programs;
}

/// True if a texel of the picture is a pixel of the screen. Then it is not filtered, which is sharper, and
/// costs half if the processor draws.
bool CellLayer::is_exact(const PictureTexture& texture, const DrawItem& item) const {
    const Vec2 shown = item.picture * item.placement.scale;
    return is_on_pixels_ && is_rgb(texture.layout()) && slide_of(item) == Vec2{} &&
           std::abs(shown.x - texture.width()) < same_size &&
           std::abs(shown.y - texture.height()) < same_size;
}

}  // namespace vitrine::player
