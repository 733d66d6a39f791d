#include "player/render/renderer.hpp"

#include "player/render/colour_matrix.hpp"
#include "player/render/shaders.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double fringe_width = 1;         // canvas px
constexpr double filler_blur = 0.25;       // radius, as a share of the picture's shorter side
constexpr double small_picture = 1.5;      // texels a canvas px, from which single ones are stepped over
constexpr double same_size = 0.75;         // canvas px that a picture of the very size may differ
constexpr double same_place = 1e-3;        // canvas px
constexpr std::uint64_t kept_unused = 15;  // frames that a cell's vertices outlast their last use

bool is_opaque(const DrawItem& item) {
    return item.alpha >= 1;
}

bool is_whole(double value) {
    return std::abs(value - std::round(value)) < same_place;
}

}  // namespace

Renderer::PictureProgram::PictureProgram(const std::string& fragment_shader)
    : program(vertex_shader, fragment_shader),
      view(program),
      uv_scale(program.uniform("uv_scale")),
      uv_offset(program.uniform("uv_offset")),
      blur(program.uniform("blur")),
      level(program.uniform("level")),
      alpha(program.uniform("alpha")),
      to_rgb(program.uniform("to_rgb")),
      zero(program.uniform("zero")) {
    program.use();
    int unit = 0;
    for (const char* plane : {"picture", "blue", "red"})
        glUniform1i(program.uniform(plane), unit++);
}

Renderer::Programs::Programs(PixelLayout layout)
    : opaque(std::string(picture_shader(layout)) + opaque_shader),
      blended(std::string(picture_shader(layout)) + blended_shader),
      filler(std::string(picture_shader(layout)) + filler_shader) {}

Renderer::Renderer(int width, int height, const View& view) : width_(width), height_(height), view_(view) {
    check_gl("make the renderer");
}

void Renderer::aim(int width, int height, const View& view) {
    assert(is_own_thread());
    width_ = width;
    height_ = height;
    view_ = view;
}

std::optional<std::string> Renderer::upload(SourceId source, const Sample& sample) {
    assert(is_own_thread());
    if (!sample.shared) {
        copy(source, sample);
        return std::nullopt;
    }
    std::string reason = "it cannot be read in its place";
    if (!copied_.contains(source) && import_.is_possible()) {
        try {
            replace(source, PictureTexture(sample, import_));
            return std::nullopt;
        } catch (const std::runtime_error& error) {
            reason = error.what();
        }
    }
    if (const std::optional<Sample> bytes = sample.copied()) copy(source, *bytes);
    return copied_.insert(source).second ? std::optional(reason) : std::nullopt;
}

void Renderer::copy(SourceId source, const Sample& sample) {
    const auto place = textures_.find(source);
    if (place == textures_.end() || !place->second.fits(sample)) replace(source, PictureTexture(sample));
    textures_.at(source).upload(sample);
}

void Renderer::replace(SourceId source, PictureTexture texture) {
    const auto [place, is_new] = textures_.try_emplace(source, std::move(texture));
    if (is_new) return;
    give_back(place->second);
    place->second = std::move(texture);
}

/// A decoder writes into what it gets back, which the graphics card may still be reading for what was drawn.
void Renderer::give_back(const PictureTexture& texture) {
    if (texture.lender()) {
        Lent lent{.lender = texture.lender(), .read = {}};
        lent.read.reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
        lent_.push_back(std::move(lent));
    }
    while (!lent_.empty() && glClientWaitSync(lent_.front().read.get(), 0, 0) != GL_TIMEOUT_EXPIRED)
        lent_.pop_front();
}

void Renderer::forget(SourceId source) {
    assert(is_own_thread());
    copied_.erase(source);
    const auto place = textures_.find(source);
    if (place == textures_.end()) return;
    give_back(place->second);
    textures_.erase(place);
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
    draw_idle(frame, view);
    is_on_pixels_ = is_whole(frame.view.x) && is_whole(frame.view.y) &&
                    frame.canvas == canvas_size(width_, height_, view_);
    const ToNdc moved = seen_from(view, frame.view);
    const std::span<const DrawItem> items = frame.items;
    for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
        while (end < items.size() && items[end].alpha == items[begin].alpha &&
               !items[end].zoom == !items[begin].zoom)
            ++end;
        draw_run(items.subspan(begin, end - begin), moved);
    }
    glBindVertexArray(0);
    drop_old_meshes();
    if (zooms_) zooms_->drop_old();
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
    if (items.front().zoom) return draw_zooms(items, view);
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

void Renderer::draw_zooms(std::span<const DrawItem> items, const ToNdc& view) {
    if (!zooms_) zooms_.emplace();
    for (const DrawItem& item : items) {
        if (!has(item.source)) continue;
        choose_filter(textures_.at(item.source), item, false, false);
        zooms_->draw(item, view);
    }
}

void Renderer::draw_outlines(const DrawItem& item, const ToNdc& view) {
    const Mesh& cell = mesh(item.cell);
    draw_range(programs(item).filler, item, view, GL_LINES, cell.filler.outline);
    draw_range(programs(item).opaque, item, view, GL_LINES, cell.parts.outline);
}

void Renderer::draw_fills(const DrawItem& item, const ToNdc& view) {
    const Mesh& cell = mesh(item.cell);
    const Programs& of_item = programs(item);
    draw_range(of_item.filler, item, view, GL_TRIANGLES, cell.filler.triangles);
    draw_range(is_opaque(item) ? of_item.opaque : of_item.blended, item, view, GL_TRIANGLES,
               cell.parts.triangles);
}

void Renderer::draw_fringes(const DrawItem& item, const ToNdc& view) {
    const Mesh& cell = mesh(item.cell);
    draw_range(programs(item).filler, item, view, GL_TRIANGLES, cell.filler.fringe);
    draw_range(programs(item).blended, item, view, GL_TRIANGLES, cell.parts.fringe);
}

const Renderer::Programs& Renderer::programs(const DrawItem& item) {
    const PixelLayout layout = textures_.at(item.source).layout();
    std::optional<Programs>& programs = programs_.at(static_cast<std::size_t>(layout));
    if (!programs) programs.emplace(layout);
    return *programs;
}

void Renderer::draw_range(const PictureProgram& program, const DrawItem& item, const ToNdc& view, GLenum mode,
                          CellMesh::Range range) {
    if (range.count == 0) return;
    bind(program, item, view);
    glDrawArrays(mode, range.first, range.count);
}

void Renderer::bind(const PictureProgram& program, const DrawItem& item, const ToNdc& view) {
    const bool is_filler = program.blur >= 0;
    PictureTexture& whole = textures_.at(item.source);
    PictureTexture& texture = is_filler ? whole.reduced() : whole;
    const bool is_one_to_one = !is_filler && is_exact(texture, item);
    glBindVertexArray(meshes_.at(item.cell.get()).array.id());
    choose_filter(texture, item, is_filler, is_one_to_one);

    program.program.use();
    program.view.set(view);
    set_texels(program, texture, item, is_one_to_one);
    glUniform1f(program.alpha, static_cast<float>(item.alpha));
    if (program.to_rgb >= 0) {
        const ColourMatrix colours = colour_matrix(texture.colours());
        glUniformMatrix3fv(program.to_rgb, 1, GL_FALSE, colours.matrix.data());
        glUniform3fv(program.zero, 1, colours.zero.data());
    }
    if (is_filler) set_blur(program, texture);
}

// texel = (u - offset) / scale + slide, as a share of the picture; one that is drawn pixel for pixel is moved
// to whole ones, by less than half of one.
void Renderer::set_texels(const PictureProgram& program, const PictureTexture& texture, const DrawItem& item,
                          bool is_exact) const {
    const Vec2 offset = item.placement.offset;
    if (is_exact) {
        set(program.uv_scale, {1.0 / texture.width(), 1.0 / texture.height()});
        set(program.uv_offset,
            {-std::round(offset.x) / texture.width(), -std::round(offset.y) / texture.height()});
        return;
    }
    const double scale = item.placement.scale;
    const Vec2 first = item.slide - offset * (1 / scale);
    set(program.uv_scale, {1 / (scale * item.picture.x), 1 / (scale * item.picture.y)});
    set(program.uv_offset, {first.x / item.picture.x, first.y / item.picture.y});
}

/// Whether a texel of the picture is a pixel of the screen: then it is not filtered, which is sharper, and
/// half of what the picture costs where the processor draws it.
bool Renderer::is_exact(const PictureTexture& texture, const DrawItem& item) const {
    const Vec2 shown = item.picture * item.placement.scale;
    return is_on_pixels_ && is_rgb(texture.layout()) && item.slide == Vec2{} &&
           std::abs(shown.x - texture.width()) < same_size &&
           std::abs(shown.y - texture.height()) < same_size;
}

void Renderer::set_blur(const PictureProgram& filler, const PictureTexture& texture) {
    const double radius = filler_blur * std::min(texture.width(), texture.height());  // texels
    set(filler.blur, {radius / texture.width(), radius / texture.height()});
    glUniform1f(filler.level,
                static_cast<float>(std::max(0.0, std::log2(radius) - 1)));  // half a radius wide
}

// Smaller copies are made of a photo shown small, once; a film is not worth them, it would need them for
// every picture. Filler does need them, of both.
void Renderer::choose_filter(PictureTexture& texture, const DrawItem& item, bool is_filler, bool is_exact) {
    const double texels = texture.width() / (item.picture.x * item.placement.scale);  // a canvas px
    const bool is_small_photo = texels >= small_picture && texture.is_still();
    if (is_filler || is_small_photo) texture.make_smaller_copies();
    const GLint wrap = is_filler ? GL_MIRRORED_REPEAT : GL_CLAMP_TO_EDGE;
    if (is_exact) return texture.bind(GL_NEAREST, GL_NEAREST, wrap);
    texture.bind(texture.has_smaller_copies() ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR, GL_LINEAR, wrap);
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

}  // namespace vitrine::player
