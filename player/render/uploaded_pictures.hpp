#pragma once

#include "player/display/gl_device.hpp"
#include "player/playback/sample.hpp"
#include "player/render/picture_import.hpp"
#include "player/render/picture_texture.hpp"
#include "player/scene/frame.hpp"

#include <GLES3/gl3.h>

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>

namespace vitrine::player {

/// The form for uploading pictures. If the processor draws, each operation on a pixel is expensive, so the
/// pictures are prepared for plain copying. A graphics card gets less data to carry, or none.
/// @param device               gl_device()
/// @param reads_shared_planes  true: decoders' pictures can be drawn in place
inline PictureForm picture_form(std::string_view device, bool reads_shared_planes) {
    if (is_software(device)) return PictureForm::bgra;
    return reads_shared_planes ? PictureForm::shared : PictureForm::planes;
}

/// The form in words, for the log.
inline const char* in_words(PictureForm form) {
    switch (form) {
    case PictureForm::bgra:
        return "scaled by the processor, which draws too";
    case PictureForm::planes:
        return "uploaded as they are decoded, scaled by the graphics card";
    case PictureForm::shared:
        break;
    }
    return "drawn from where a decoder shares them, else uploaded as they are decoded";
}

/// The newest picture of each source, on the graphics card. Keeps a decoder's picture until the card has read
/// it. Belongs to a Renderer.
class UploadedPictures {
  public:
    /// True if upload() can leave shared planes in place.
    bool reads_shared_planes() const { return import_.is_possible(); }

    /// Takes the source's newest picture. The pixels are copied before this returns. Shared planes are copied
    /// only if they cannot be read in place.
    /// @return the reason why they cannot be read in place, once for each source
    /// @throws std::runtime_error if the graphics card has no room
    std::optional<std::string> upload(SourceId source, const Sample& sample);

    void forget(SourceId source);

    bool has(SourceId source) const { return textures_.contains(source); }

    /// @pre has(source)
    PictureTexture& at(SourceId source) { return textures_.at(source); }

    /// The slide of the source's picture (Sample). @pre has(source)
    Vec2 slide(SourceId source) const { return slides_.at(source); }

  private:
    struct EndSync {
        void operator()(GLsync sync) const { glDeleteSync(sync); }
    };

    /// A replaced picture of a decoder, kept until the graphics card has read it.
    struct Lent {
        std::shared_ptr<const void> lender;  // shared: the decoder's buffer pool
        std::unique_ptr<std::remove_pointer_t<GLsync>, EndSync> read;
    };

    std::optional<std::string> read_or_copy(SourceId source, const Sample& sample);
    void copy(SourceId source, const Sample& sample);
    void replace(SourceId source, PictureTexture texture);
    void give_back(const PictureTexture& texture);

    PictureImport import_;
    std::set<SourceId> copied_;  // sources whose shared planes cannot be read in place
    std::deque<Lent> lent_;      // the oldest first
    std::unordered_map<SourceId, PictureTexture> textures_;
    std::unordered_map<SourceId, Vec2> slides_;
};

}  // namespace vitrine::player
