#include "player/render/word_layer.hpp"

#include <array>

namespace vitrine::player {

namespace {

constexpr const char* word_vertex_shader = R"(
precision highp float;
layout(location = 0) in vec2 corner;   // of the unit square
uniform vec2 x_axis, y_axis, origin;   // canvas px to GL
uniform vec2 place, size;              // canvas px
out highp vec2 uv;

void main() {
    vec2 at = place + corner * size;
    uv = corner;
    gl_Position = vec4(x_axis * at.x + y_axis * at.y + origin, 0.0, 1.0);
}
)";

constexpr const char* word_shader = R"(
precision mediump float;
uniform sampler2D picture;
uniform float alpha;
in highp vec2 uv;
out vec4 pixel;

void main() {
    pixel = texture(picture, uv) * vec4(1.0, 1.0, 1.0, alpha);
}
)";

constexpr int kept_unused = 16;  // draws: each screen of a canvas may have a word of its own

constexpr std::array<float, 8> unit_square{0, 0, 1, 0, 0, 1, 1, 1};

}  // namespace

WordLayer::WordLayer()
    : program_(word_vertex_shader, word_shader),
      view_(program_),
      place_(program_.uniform("place")),
      size_(program_.uniform("size")),
      alpha_(program_.uniform("alpha")) {
    glBindVertexArray(square_.id());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
    glBufferData(GL_ARRAY_BUFFER, sizeof(unit_square), unit_square.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glBindVertexArray(0);
}

void WordLayer::draw(std::span<const WordItem> words, const ToNdc& view) {
    for (auto& [picture, texture] : textures_)
        ++texture.unused;
    program_.use();
    view_.set(view);
    glEnable(GL_BLEND);
    glBindVertexArray(square_.id());
    glActiveTexture(GL_TEXTURE0);
    for (const WordItem& word : words) {
        if (!word.picture || word.alpha <= 0) continue;
        glBindTexture(GL_TEXTURE_2D, texture_of(word.picture).texture.id());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                        word.is_sharp ? GL_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, word.is_sharp ? GL_NEAREST : GL_LINEAR);
        set(place_, word.place.min);
        set(size_, word.place.max - word.place.min);
        glUniform1f(alpha_, static_cast<float>(word.alpha));
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    glBindVertexArray(0);
    std::erase_if(textures_, [](const auto& entry) { return entry.second.unused > kept_unused; });
}

const WordLayer::Texture& WordLayer::texture_of(const std::shared_ptr<const WordPicture>& picture) {
    const auto [entry, is_new] = textures_.try_emplace(picture.get());
    Texture& texture = entry->second;
    texture.unused = 0;
    if (!is_new) return texture;
    texture.picture = picture;
    glBindTexture(GL_TEXTURE_2D, texture.texture.id());
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture->width, picture->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture->rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace vitrine::player
