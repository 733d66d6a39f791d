#include "player/render/idle_picture.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::player {

namespace {

constexpr int columns = 40;
constexpr int rows = 25;
constexpr double period =
    3600;  // s; then the lights are at their start again, so that a float keeps its precision

// Everything makes whole turns in `period` seconds, so the movement has no seam.
constexpr const char* idle_vertex_shader = R"(
precision highp float;
layout(location = 0) in vec2 corner;   // [0, 1], y down
uniform vec2 x_axis, y_axis, origin;   // canvas px to GL
uniform vec2 canvas;                   // px
uniform float seconds;
out vec3 colour;

const float turn = 6.2831853 / 3600.0;

vec2 place(float a, float b, float phase) {
    return vec2(0.5 + 0.42 * sin(turn * a * seconds + phase), 0.5 + 0.38 * cos(turn * b * seconds + phase * 1.7));
}

float light(vec2 point, vec2 centre, float radius) {
    vec2 d = point - centre;
    return exp(-dot(d, d) / (radius * radius));
}

void main() {
    float aspect = canvas.x / canvas.y;
    vec2 stretch = aspect > 1.0 ? vec2(aspect, 1.0) : vec2(1.0, 1.0 / aspect);
    vec2 p = corner * stretch;
    p += 0.11 * vec2(sin(3.1 * p.y + turn * 83.0 * seconds), sin(2.3 * p.x - turn * 73.0 * seconds));

    vec3 c = mix(vec3(0.055, 0.075, 0.150), vec3(0.020, 0.035, 0.075), corner.y);
    c += vec3(0.080, 0.220, 0.330) * light(p, place(67.0, 53.0, 0.4) * stretch, 0.55);
    c += vec3(0.260, 0.120, 0.300) * light(p, place(-47.0, 61.0, 2.3) * stretch, 0.50);
    c += vec3(0.330, 0.170, 0.090) * light(p, place(59.0, -43.0, 4.1) * stretch, 0.36);
    c += vec3(0.050, 0.230, 0.190) * light(p, place(-71.0, -37.0, 5.5) * stretch, 0.44);
    float fold = dot(p, vec2(2.9, 4.7)) + 1.4 * sin(1.7 * p.x - turn * 41.0 * seconds) + turn * 97.0 * seconds;
    colour = c * (1.0 + 0.38 * pow(0.5 + 0.5 * sin(fold), 3.0)) + 0.012 * sin(fold * 0.5 + 1.0);

    vec2 u = corner * canvas;
    gl_Position = vec4(x_axis * u.x + y_axis * u.y + origin, 0.0, 1.0);
}
)";

// Noise of half a step hides the steps of eight bits, which are visible on slow gradients.
constexpr const char* idle_fragment_shader = R"(
precision mediump float;
in vec3 colour;
uniform float opacity;
out vec4 pixel;

void main() {
    highp float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    pixel = vec4(colour + (noise - 0.5) / 255.0, opacity);
}
)";

std::vector<GLfloat> grid_corners() {
    std::vector<GLfloat> corners;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            corners.push_back(static_cast<GLfloat>(column) / columns);
            corners.push_back(static_cast<GLfloat>(row) / rows);
        }
    }
    return corners;
}

std::vector<GLushort> grid_order() {
    std::vector<GLushort> order;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int a = row * (columns + 1) + column;
            for (const int corner : {a, a + 1, a + columns + 1, a + 1, a + columns + 2, a + columns + 1})
                order.push_back(static_cast<GLushort>(corner));
        }
    }
    return order;
}

}  // namespace

IdlePicture::IdlePicture()
    : program_(idle_vertex_shader, idle_fragment_shader),
      view_(program_),
      canvas_(program_.uniform("canvas")),
      seconds_(program_.uniform("seconds")),
      opacity_(program_.uniform("opacity")) {
    const std::vector<GLfloat> corners = grid_corners();
    const std::vector<GLushort> order = grid_order();
    glBindVertexArray(grid_.id());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(GLfloat)), corners.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, order_.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(order.size() * sizeof(GLushort)),
                 order.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
    check_gl("make the idle picture");
}

void IdlePicture::draw(Vec2 canvas, const ToNdc& view, std::chrono::nanoseconds time, double opacity,
                       const Box& part) const {
    const int first = std::clamp(static_cast<int>(std::floor(part.min.y / canvas.y * rows)), 0, rows);
    const int last = std::clamp(static_cast<int>(std::ceil(part.max.y / canvas.y * rows)), first, rows);
    const double seconds = std::chrono::duration<double>(time).count();
    program_.use();
    view_.set(view);
    set(canvas_, canvas);
    glUniform1f(seconds_, static_cast<float>(std::fmod(seconds, period)));
    glUniform1f(opacity_, static_cast<float>(opacity));
    glBindVertexArray(grid_.id());
    const std::size_t begin = static_cast<std::size_t>(first) * columns * 6 * sizeof(GLushort);
    // NOLINTNEXTLINE(performance-no-int-to-ptr,cppcoreguidelines-pro-type-reinterpret-cast): GL's way
    const auto* order = reinterpret_cast<const void*>(begin);
    glDrawElements(GL_TRIANGLES, columns * (last - first) * 6, GL_UNSIGNED_SHORT, order);
}

}  // namespace vitrine::player
