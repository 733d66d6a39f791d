#pragma once

#include "player/playback/sample.hpp"

namespace vitrine::player {

// The shaders that draw pictures, in GLSL ES 3.00 without its #version line.

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

// The functions that read a pixel of the picture for the shaders below: `picture_at` and `opaque_at` read the
// smaller copies that the sampler chooses, `copy_at` reads a given one.

// Mesa's software renderer (22.3) copies whole tiles if a shader only looks up a texel. If a shader also sets
// the opacity to 1, red and blue are swapped there; if it rounds, it is not copied.
inline constexpr const char* rgba_picture = R"(
precision highp float;
uniform highp sampler2D picture;

vec3 picture_at(highp vec2 uv) {
    return texture(picture, uv).rgb;
}

vec4 opaque_at(highp vec2 uv) {
    return texture(picture, uv);
}

vec3 copy_at(highp vec2 uv, float level) {
    return textureLod(picture, uv, level).rgb;
}
)";

// A plane of brightness, and one or two planes of colour differences of half the size.
inline constexpr const char* i420_picture = R"(
precision highp float;
uniform sampler2D picture, blue, red;
uniform mat3 to_rgb;
uniform vec3 zero;   // the code of black

vec3 picture_at(highp vec2 uv) {
    return to_rgb * (vec3(texture(picture, uv).r, texture(blue, uv).r, texture(red, uv).r) - zero);
}

vec4 opaque_at(highp vec2 uv) {
    return vec4(picture_at(uv), 1.0);
}

vec3 copy_at(highp vec2 uv, float level) {
    vec3 coded = vec3(textureLod(picture, uv, level).r, textureLod(blue, uv, level).r, textureLod(red, uv, level).r);
    return to_rgb * (coded - zero);
}
)";

inline constexpr const char* nv12_picture = R"(
precision highp float;
uniform sampler2D picture, blue;
uniform mat3 to_rgb;
uniform vec3 zero;

vec3 picture_at(highp vec2 uv) {
    return to_rgb * (vec3(texture(picture, uv).r, texture(blue, uv).rg) - zero);
}

vec4 opaque_at(highp vec2 uv) {
    return vec4(picture_at(uv), 1.0);
}

vec3 copy_at(highp vec2 uv, float level) {
    return to_rgb * (vec3(textureLod(picture, uv, level).r, textureLod(blue, uv, level).rg) - zero);
}
)";

inline const char* picture_shader(PixelLayout layout) {
    switch (layout) {
    case PixelLayout::i420:
        return i420_picture;
    case PixelLayout::nv12:
        return nv12_picture;
    case PixelLayout::rgba:
    case PixelLayout::bgra:
        break;
    }
    return rgba_picture;
}

inline constexpr const char* opaque_shader = R"(
in highp vec2 uv;
out vec4 pixel;

void main() {
    pixel = opaque_at(uv);
}
)";

inline constexpr const char* blended_shader = R"(
in highp vec2 uv;
in mediump float coverage;
uniform float alpha;
out vec4 pixel;

void main() {
    pixel = vec4(picture_at(uv), alpha * coverage);
}
)";

// The picture, mirrored at its edges or at its bars, mostly dark, and so blurred that nothing in it is
// recognised: a frame, not a second picture. The taps lie on a sunflower's spiral and are the same for each
// pixel, so that still pictures stand still.
inline constexpr const char* filler_shader = R"(
in highp vec2 uv;
in mediump float coverage;
uniform highp vec2 blur;     // radius, as a share of the picture
uniform highp float level;   // the smaller copy that is read
uniform highp vec4 mirrors;  // place and size of what is mirrored, as shares of the picture
uniform float alpha;
uniform float light;         // share of the picture's brightness
out vec4 pixel;

const int taps = 16;
const highp mat2 golden_turn = mat2(-0.737369, 0.675490, -0.675490, -0.737369);

highp vec2 mirrored(highp vec2 place) {
    highp vec2 turn = mod((place - mirrors.xy) / mirrors.zw, 2.0);
    return mirrors.xy + mirrors.zw * (1.0 - abs(turn - 1.0));
}

void main() {
    highp vec3 sum = vec3(0.0);
    highp vec2 unit = vec2(1.0, 0.0);
    for (int i = 0; i < taps; ++i) {
        highp vec2 place = unit * sqrt((float(i) + 0.5) / float(taps)) * blur;
        sum += copy_at(mirrored(uv + place), level);
        unit = golden_turn * unit;
    }
    pixel = vec4(sum * (light / float(taps)), alpha * coverage);
}
)";

}  // namespace vitrine::player
