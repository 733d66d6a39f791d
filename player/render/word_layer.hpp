#pragma once

#include "player/render/gl_objects.hpp"
#include "player/render/view.hpp"
#include "player/words/word_item.hpp"

#include <map>
#include <memory>
#include <span>

namespace vitrine::player {

/// Draws words over a frame. Belongs to a Renderer.
class WordLayer {
  public:
    WordLayer();

    /// Pictures of words that were not drawn in this call are dropped.
    void draw(std::span<const WordItem> words, const ToNdc& view);

  private:
    struct Texture {
        std::shared_ptr<const WordPicture> picture;  // shared, so that no other gets its address meanwhile
        GlTexture texture;
        int unused = 0;  // draws since it was drawn last
    };

    const Texture& texture_of(const std::shared_ptr<const WordPicture>& picture);

    GlProgram program_;
    GlBuffer corners_;
    GlVertexArray square_;
    ViewUniforms view_;
    GLint place_;
    GLint size_;
    GLint alpha_;
    std::map<const WordPicture*, Texture> textures_;
};

}  // namespace vitrine::player
