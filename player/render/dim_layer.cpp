#include "player/render/dim_layer.hpp"

namespace vitrine::player {

namespace {

// One triangle that holds the whole screen.
constexpr const char* dim_vertex_shader = R"(
precision highp float;

void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
)";

constexpr const char* dim_shader = R"(
precision mediump float;
uniform float shade;
out vec4 pixel;

void main() {
    pixel = vec4(0.0, 0.0, 0.0, shade);
}
)";

}  // namespace

DimLayer::DimLayer() : program_(dim_vertex_shader, dim_shader), shade_(program_.uniform("shade")) {}

void DimLayer::draw(double light) {
    program_.use();
    glUniform1f(shade_, static_cast<float>(1 - light));
    glEnable(GL_BLEND);
    glBindVertexArray(nothing_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace vitrine::player
