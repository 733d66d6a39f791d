#include "player/render/picture_program.hpp"

#include "player/render/colour_matrix.hpp"
#include "player/render/shaders.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double filler_blur = 0.25;  // radius, as a share of the picture's shorter side

}  // namespace

PictureProgram::PictureProgram(const std::string& fragment_shader)
    : program_(vertex_shader, fragment_shader),
      view_(program_),
      uv_scale_(program_.uniform("uv_scale")),
      uv_offset_(program_.uniform("uv_offset")),
      blur_(program_.uniform("blur")),
      level_(program_.uniform("level")),
      alpha_(program_.uniform("alpha")),
      to_rgb_(program_.uniform("to_rgb")),
      zero_(program_.uniform("zero")) {
    program_.use();
    int unit = 0;
    for (const char* plane : {"picture", "blue", "red"})
        glUniform1i(program_.uniform(plane), unit++);
}

void PictureProgram::use(const DrawItem& item, const PictureTexture& texture, const ToNdc& view,
                         bool is_exact) const {
    program_.use();
    view_.set(view);
    set_texels(item, texture, is_exact);
    glUniform1f(alpha_, static_cast<float>(item.alpha));
    if (to_rgb_ >= 0) {
        const ColourMatrix colours = colour_matrix(texture.colours());
        glUniformMatrix3fv(to_rgb_, 1, GL_FALSE, colours.matrix.data());
        glUniform3fv(zero_, 1, colours.zero.data());
    }
    if (is_filler()) set_blur(texture);
}

// texel = (u - offset) / scale + slide, as a share of the picture. A picture that is drawn pixel for pixel is
// moved to whole pixels, by less than half a pixel.
void PictureProgram::set_texels(const DrawItem& item, const PictureTexture& texture, bool is_exact) const {
    const Vec2 offset = item.placement.offset;
    if (is_exact) {
        set(uv_scale_, {1.0 / texture.width(), 1.0 / texture.height()});
        set(uv_offset_, {-std::round(offset.x) / texture.width(), -std::round(offset.y) / texture.height()});
        return;
    }
    const double scale = item.placement.scale;
    const Vec2 first = item.slide - offset * (1 / scale);
    set(uv_scale_, {1 / (scale * item.picture.x), 1 / (scale * item.picture.y)});
    set(uv_offset_, {first.x / item.picture.x, first.y / item.picture.y});
}

void PictureProgram::set_blur(const PictureTexture& texture) const {
    const double radius = filler_blur * std::min(texture.width(), texture.height());  // texels
    set(blur_, {radius / texture.width(), radius / texture.height()});
    glUniform1f(level_, static_cast<float>(std::max(0.0, std::log2(radius) - 1)));  // half a radius a texel
}

PicturePrograms::PicturePrograms(PixelLayout layout)
    : opaque(std::string(picture_shader(layout)) + opaque_shader),
      blended(std::string(picture_shader(layout)) + blended_shader),
      filler(std::string(picture_shader(layout)) + filler_shader) {}

}  // namespace vitrine::player
