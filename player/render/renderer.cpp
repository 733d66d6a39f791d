#include "player/render/renderer.hpp"

#include "player/render/shaders.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace vitrine {

namespace {

constexpr double fringe_width = 1;          // canvas px
constexpr double filler_blur = 0.25;        // radius, as a share of the picture's shorter side
constexpr double small_picture = 1.5;       // texels a canvas px, from which single ones are stepped over
constexpr std::uint64_t kept_unused = 120;  // frames that a cell's vertices outlast their last use

void set(GLint uniform, Vec2 value) {
    glUniform2f(uniform, static_cast<float>(value.x), static_cast<float>(value.y));
}

bool is_opaque(const DrawItem& item) {
    return item.alpha >= 1;
}

}  // namespace

Renderer::PictureProgram::PictureProgram(const char* fragment_shader)
    : program(vertex_shader, fragment_shader),
      x_axis(program.uniform("x_axis")),
      y_axis(program.uniform("y_axis")),
      origin(program.uniform("origin")),
      uv_scale(program.uniform("uv_scale")),
      uv_offset(program.uniform("uv_offset")),
      blur(program.uniform("blur")),
      level(program.uniform("level")),
      alpha(program.uniform("alpha")) {}

Renderer::Renderer(int width, int height, const View& view)
    : width_(width),
      height_(height),
      view_(view),
      opaque_(opaque_shader),
      blended_(blended_shader),
      filler_(filler_shader) {
    check_gl("make the renderer");
}

void Renderer::resize(int width, int height) {
    assert(is_own_thread());
    width_ = width;
    height_ = height;
}

void Renderer::upload(SourceId source, const Sample& sample) {
    assert(is_own_thread());
    assert(sample.width > 0 && sample.height > 0 && sample.stride % 4 == 0);
    assert(sample.pixels.size() >= sample.stride * static_cast<std::size_t>(sample.height - 1) +
                                       static_cast<std::size_t>(sample.width) * 4);
    Texture& texture = textures_[source];
    if (texture.width != sample.width || texture.height != sample.height) {
        texture = Texture{.width = sample.width, .height = sample.height};
        const auto levels = std::bit_width(static_cast<unsigned>(std::max(sample.width, sample.height)));
        glBindTexture(GL_TEXTURE_2D, texture.name.id());
        glTexStorage2D(GL_TEXTURE_2D, levels, GL_RGBA8, sample.width, sample.height);
        check_gl("make room for a picture");
    }
    glBindTexture(GL_TEXTURE_2D, texture.name.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(sample.stride / 4));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, sample.width, sample.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    sample.pixels.data());
    check_gl("upload a picture");
    texture.has_mipmap = false;
    ++texture.uploads;
}

void Renderer::forget(SourceId source) {
    assert(is_own_thread());
    textures_.erase(source);
}

bool Renderer::has(SourceId source) const {
    return textures_.contains(source);
}

void Renderer::draw(const Frame& frame) {
    assert(is_own_thread());
    ++frames_;
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);

    const int across = width_ - view_.left - view_.right;
    const int down = height_ - view_.top - view_.bottom;
    glViewport(view_.left, view_.bottom, across, down);
    glScissor(view_.left, view_.bottom, across, down);  // lines may reach beyond the viewport
    glEnable(GL_SCISSOR_TEST);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    const ToNdc view = to_ndc(frame.canvas, view_.rotation);
    if (const double idle = leaves_holes(frame) ? 1 : frame.idle; idle > 0) {
        glEnable(GL_BLEND);
        idle_.draw(frame.canvas, view, frame.time, idle);
    }
    const ToNdc moved = seen_from(view, frame.view);
    const std::span<const DrawItem> items = frame.items;
    for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
        while (end < items.size() && items[end].alpha == items[begin].alpha)
            ++end;
        draw_run(items.subspan(begin, end - begin), moved);
    }
    glBindVertexArray(0);
    drop_old_meshes();
    check_gl("draw a frame");
}

bool Renderer::is_own_thread() const {
    return std::this_thread::get_id() == thread_;
}

bool Renderer::leaves_holes(const Frame& frame) const {
    return std::ranges::none_of(frame.items,
                                [&](const DrawItem& i) { return is_opaque(i) && has(i.source); }) ||
           std::ranges::any_of(frame.items,
                               [&](const DrawItem& i) { return is_opaque(i) && !has(i.source); });
}

// A run of items of one opacity is one layer of cells, which meet in seams.
void Renderer::draw_run(std::span<const DrawItem> items, const ToNdc& view) {
    const auto for_each = [&](auto draw_it) {
        for (const DrawItem& item : items)
            if (has(item.source) && item.alpha > 0) (this->*draw_it)(item, view);
    };
    if (is_opaque(items.front())) {
        glDisable(GL_BLEND);
        for_each(&Renderer::draw_outlines);
        for_each(&Renderer::draw_fills);
        glEnable(GL_BLEND);
    } else {
        glEnable(GL_BLEND);
        for_each(&Renderer::draw_fills);
    }
    for_each(&Renderer::draw_fringes);
}

void Renderer::draw_outlines(const DrawItem& item, const ToNdc& view) {
    const Mesh& cell = mesh(item.cell);
    draw_range(filler_, item, view, GL_LINES, cell.filler.outline);
    draw_range(opaque_, item, view, GL_LINES, cell.parts.outline);
}

void Renderer::draw_fills(const DrawItem& item, const ToNdc& view) {
    const Mesh& cell = mesh(item.cell);
    draw_range(filler_, item, view, GL_TRIANGLES, cell.filler.triangles);
    draw_range(is_opaque(item) ? opaque_ : blended_, item, view, GL_TRIANGLES, cell.parts.triangles);
}

void Renderer::draw_fringes(const DrawItem& item, const ToNdc& view) {
    const Mesh& cell = mesh(item.cell);
    draw_range(filler_, item, view, GL_TRIANGLES, cell.filler.fringe);
    draw_range(blended_, item, view, GL_TRIANGLES, cell.parts.fringe);
}

void Renderer::draw_range(const PictureProgram& program, const DrawItem& item, const ToNdc& view, GLenum mode,
                          CellMesh::Range range) {
    if (range.count == 0) return;
    bind(program, item, view);
    glDrawArrays(mode, range.first, range.count);
}

void Renderer::bind(const PictureProgram& program, const DrawItem& item, const ToNdc& view) {
    const bool is_filler = &program == &filler_;
    Texture& texture = textures_.at(item.source);
    glBindVertexArray(meshes_.at(item.cell.get()).array.id());
    glBindTexture(GL_TEXTURE_2D, texture.name.id());
    const GLint wrap = is_filler ? GL_MIRRORED_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    choose_filter(texture, item, is_filler);

    // texel = (u - offset) / scale + slide, as a share of the picture
    const double scale = item.placement.scale;
    const Vec2 first = item.slide - item.placement.offset * (1 / scale);
    program.program.use();
    set(program.x_axis, view.x_axis);
    set(program.y_axis, view.y_axis);
    set(program.origin, view.origin);
    set(program.uv_scale, {1 / (scale * item.picture.x), 1 / (scale * item.picture.y)});
    set(program.uv_offset, {first.x / item.picture.x, first.y / item.picture.y});
    glUniform1f(program.alpha, static_cast<float>(item.alpha));
    if (is_filler) set_blur(program, texture);
}

void Renderer::set_blur(const PictureProgram& filler, const Texture& texture) {
    const double radius = filler_blur * std::min(texture.width, texture.height);  // texels
    set(filler.blur, {radius / texture.width, radius / texture.height});
    glUniform1f(filler.level,
                static_cast<float>(std::max(0.0, std::log2(radius) - 1)));  // half a radius wide
}

// Smaller copies are made of a photo shown small, once; a film is not worth them, it would need them for
// every picture. Filler does need them, of both.
void Renderer::choose_filter(Texture& texture, const DrawItem& item, bool is_filler) {
    const double texels = texture.width / (item.picture.x * item.placement.scale);  // a canvas px
    const bool is_small_photo = texels >= small_picture && texture.uploads == 1;
    if ((is_filler || is_small_photo) && !texture.has_mipmap) {
        glGenerateMipmap(GL_TEXTURE_2D);
        texture.has_mipmap = true;
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    texture.has_mipmap ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR);
}

Renderer::Mesh& Renderer::mesh(const std::shared_ptr<const Cell>& cell) {
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

void Renderer::drop_old_meshes() {
    std::erase_if(meshes_,
                  [&](const auto& entry) { return frames_ - entry.second.last_drawn > kept_unused; });
}

}  // namespace vitrine
