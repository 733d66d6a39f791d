#pragma once

namespace vitrine {

// What draws pictures, in GLSL ES 3.00 without its #version line.

inline constexpr const char* vertex_shader = R"(
precision highp float;
layout(location = 0) in vec3 vertex;   // canvas px, coverage
uniform vec2 x_axis, y_axis, origin;   // canvas px to GL
uniform vec2 uv_scale, uv_offset;      // canvas px to texture
out highp vec2 uv;
out mediump float coverage;

void main() {
    uv = vertex.xy * uv_scale + uv_offset;
    coverage = vertex.z;
    gl_Position = vec4(x_axis * vertex.x + y_axis * vertex.y + origin, 0.0, 1.0);
}
)";

inline constexpr const char* opaque_shader = R"(
precision mediump float;
in highp vec2 uv;
uniform sampler2D picture;
out vec4 pixel;

void main() {
    pixel = texture(picture, uv);
}
)";

inline constexpr const char* blended_shader = R"(
precision mediump float;
in highp vec2 uv;
in float coverage;
uniform sampler2D picture;
uniform float alpha;
out vec4 pixel;

void main() {
    pixel = vec4(texture(picture, uv).rgb, alpha * coverage);
}
)";

// The mirrored picture, so blurred that nothing in it is recognised, and dark: a frame, not a second picture.
// The taps lie on a sunflower's spiral and are the same for each pixel, so that still pictures stand still.
inline constexpr const char* filler_shader = R"(
precision highp float;
in highp vec2 uv;
in mediump float coverage;
uniform sampler2D picture;
uniform vec2 blur;     // radius, as a share of the picture
uniform float level;   // of the smaller copies
uniform float alpha;
out vec4 pixel;

const int taps = 16;
const float light = 0.3;
const mat2 golden_turn = mat2(-0.737369, 0.675490, -0.675490, -0.737369);

void main() {
    vec3 sum = vec3(0.0);
    vec2 unit = vec2(1.0, 0.0);
    for (int i = 0; i < taps; ++i) {
        vec2 place = unit * sqrt((float(i) + 0.5) / float(taps)) * blur;
        sum += textureLod(picture, uv + place, level).rgb;
        unit = golden_turn * unit;
    }
    pixel = vec4(sum * (light / float(taps)), alpha * coverage);
}
)";

}  // namespace vitrine
