#include "player/render/picture_program.hpp"

#include "player/playback/colour_code.hpp"
#include "player/render/shaders.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

/// The part of a picture that has nothing of its bars, source px. @param texel  of the smaller copy that is
/// read, as a share of the picture: one that lies over the edge of a bar is not read
Box within_bars(const DrawItem& item, Vec2 texel) {
    const Box whole{{0, 0}, item.picture};
    if (item.active.is_empty()) return whole;
    Box part = item.active;
    const Vec2 margin{texel.x * item.picture.x, texel.y * item.picture.y};
    if (part.min.x > 0) part.min.x += margin.x;
    if (part.min.y > 0) part.min.y += margin.y;
    if (part.max.x < whole.max.x) part.max.x -= margin.x;
    if (part.max.y < whole.max.y) part.max.y -= margin.y;
    return part.is_empty() ? item.active : part;
}

}  // namespace

PictureProgram::PictureProgram(const std::string& fragment_shader)
    : program_(vertex_shader, fragment_shader),
      view_(program_),
      uv_scale_(program_.uniform("uv_scale")),
      uv_offset_(program_.uniform("uv_offset")),
      blur_(program_.uniform("blur")),
      level_(program_.uniform("level")),
      mirrors_(program_.uniform("mirrors")),
      light_(program_.uniform("light")),
      alpha_(program_.uniform("alpha")),
      to_rgb_(program_.uniform("to_rgb")),
      zero_(program_.uniform("zero")) {
    program_.use();
    int unit = 0;
    for (const char* plane : {"picture", "blue", "red"})
        glUniform1i(program_.uniform(plane), unit++);
}

void PictureProgram::use(const DrawItem& item, const DrawnPicture& picture, const ToNdc& view) const {
    program_.use();
    view_.set(view);
    set_texels(item, picture);
    glUniform1f(alpha_, static_cast<float>(item.alpha));
    if (to_rgb_ >= 0) {
        const ColourMatrix colours = colour_matrix(picture.texture.colours());
        glUniformMatrix3fv(to_rgb_, 1, GL_FALSE, colours.matrix.data());
        glUniform3fv(zero_, 1, colours.zero.data());
    }
    if (is_filler()) set_blur(item, picture.texture);
}

// texel = (u - offset) / scale + slide, as a share of the picture. A picture that is drawn pixel for pixel is
// moved to whole pixels, by less than half a pixel.
void PictureProgram::set_texels(const DrawItem& item, const DrawnPicture& picture) const {
    const PictureTexture& texture = picture.texture;
    const Vec2 offset = item.placement.offset;
    if (picture.is_exact) {
        set(uv_scale_, {1.0 / texture.width(), 1.0 / texture.height()});
        set(uv_offset_, {-std::round(offset.x) / texture.width(), -std::round(offset.y) / texture.height()});
        return;
    }
    const double scale = item.placement.scale;
    const Vec2 first = picture.slide - offset * (1 / scale);
    set(uv_scale_, {1 / (scale * item.picture.x), 1 / (scale * item.picture.y)});
    set(uv_offset_, {first.x / item.picture.x, first.y / item.picture.y});
}

void PictureProgram::set_blur(const DrawItem& item, const PictureTexture& texture) const {
    const double radius = texture.blur_radius();
    set(blur_, {radius / texture.width(), radius / texture.height()});
    glUniform1f(light_, static_cast<float>(item.filler_light));
    glUniform1f(level_, static_cast<float>(texture.blur_level()));
    const Box part = within_bars(item, {radius / 2 / texture.width(), radius / 2 / texture.height()});
    glUniform4f(mirrors_, static_cast<float>(part.min.x / item.picture.x),
                static_cast<float>(part.min.y / item.picture.y),
                static_cast<float>(part.width() / item.picture.x),
                static_cast<float>(part.height() / item.picture.y));
}

PicturePrograms::PicturePrograms(PixelLayout layout)
    : opaque(std::string(picture_shader(layout)) + opaque_shader),
      blended(std::string(picture_shader(layout)) + blended_shader),
      filler(std::string(picture_shader(layout)) + filler_shader) {}

}  // namespace vitrine::player
