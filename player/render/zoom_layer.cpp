#include "player/render/zoom_layer.hpp"

#include <cstddef>
#include <iterator>

namespace vitrine::player {

namespace {

constexpr int kept_unused = 120;  // frames that a tile's points are kept after their last use

constexpr const char* zoom_vertex_shader = R"(
precision highp float;
layout(location = 0) in vec4 places;    // px of both strips
layout(location = 1) in vec3 texel;     // u, v, growth
uniform vec2 x_axis, y_axis, origin;    // canvas px to GL
uniform vec2 offset;                    // canvas px
uniform float scale, share, alpha;
out highp vec2 uv;
out mediump float opacity;

void main() {
    vec2 place = offset + scale * mix(places.xy, places.zw, share);
    uv = texel.xy;
    opacity = alpha * (texel.z < 0.0 ? 1.0 : share / mix(texel.z, 1.0, share));
    gl_Position = vec4(x_axis * place.x + y_axis * place.y + origin, 0.0, 1.0);
}
)";

constexpr const char* whole_shader = R"(
precision mediump float;
uniform sampler2D picture;
in highp vec2 uv;
out vec4 pixel;

void main() {
    pixel = texture(picture, uv);
}
)";

constexpr const char* tile_shader = R"(
precision mediump float;
uniform sampler2D picture;
in highp vec2 uv;
in mediump float opacity;
out vec4 pixel;

void main() {
    pixel = vec4(texture(picture, uv).rgb, opacity);
}
)";

template <typename Numbers> void fill(GLenum target, const GlBuffer& buffer, const Numbers& numbers) {
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(numbers.size() * sizeof(numbers[0])), numbers.data(),
                 GL_STATIC_DRAW);
}

void attribute(GLuint place, GLint count, std::size_t offset) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr,cppcoreguidelines-pro-type-reinterpret-cast): GL's way
    const auto* begin = reinterpret_cast<const void*>(offset);
    glVertexAttribPointer(place, count, GL_FLOAT, GL_FALSE, sizeof(ZoomMesh::Vertex), begin);
    glEnableVertexAttribArray(place);
}

}  // namespace

ZoomLayer::MeshProgram::MeshProgram(const char* fragment_shader)
    : program(zoom_vertex_shader, fragment_shader),
      view(program),
      offset(program.uniform("offset")),
      scale(program.uniform("scale")),
      share(program.uniform("share")),
      alpha(program.uniform("alpha")) {}

ZoomLayer::ZoomLayer() : whole_(whole_shader), blended_(tile_shader) {}

void ZoomLayer::draw(const DrawItem& item, const ToNdc& view) {
    Mesh& drawn = mesh(item.zoom);
    drawn.unused = 0;
    const bool is_whole = item.zoom->is_whole && item.alpha >= 1;
    if (is_whole)
        glDisable(GL_BLEND);
    else
        glEnable(GL_BLEND);
    glBindVertexArray(drawn.array.id());
    const MeshProgram& program = is_whole ? whole_ : blended_;
    program.program.use();
    program.view.set(view);
    set(program.offset, item.placement.offset);
    glUniform1f(program.scale, static_cast<float>(item.placement.scale));
    glUniform1f(program.share, static_cast<float>(item.share));
    glUniform1f(program.alpha, static_cast<float>(item.alpha));
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(item.zoom->triangles.size()), GL_UNSIGNED_SHORT,
                   nullptr);
}

ZoomLayer::Mesh& ZoomLayer::mesh(const std::shared_ptr<const ZoomMesh>& zoom) {
    const auto [place, is_new] = meshes_.try_emplace(zoom.get());
    Mesh& mesh = place->second;
    if (!is_new) return mesh;
    mesh.zoom = zoom;
    glBindVertexArray(mesh.array.id());
    fill(GL_ARRAY_BUFFER, mesh.vertices, zoom->vertices);
    fill(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles, zoom->triangles);
    attribute(0, 4, offsetof(ZoomMesh::Vertex, coarse_x));
    attribute(1, 3, offsetof(ZoomMesh::Vertex, u));
    return mesh;
}

void ZoomLayer::drop_old() {
    for (auto mesh = meshes_.begin(); mesh != meshes_.end();)
        mesh = ++mesh->second.unused > kept_unused ? meshes_.erase(mesh) : std::next(mesh);
}

}  // namespace vitrine::player
