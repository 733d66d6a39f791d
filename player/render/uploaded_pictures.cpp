#include "player/render/uploaded_pictures.hpp"

#include <stdexcept>
#include <utility>

namespace vitrine::player {

std::optional<std::string> UploadedPictures::upload(SourceId source, const Sample& sample) {
    std::optional<std::string> reason = read_or_copy(source, sample);
    slides_[source] = sample.slide;
    return reason;
}

std::optional<std::string> UploadedPictures::read_or_copy(SourceId source, const Sample& sample) {
    if (!sample.shared) {
        copy(source, sample);
        return std::nullopt;
    }
    std::string reason = "it cannot be read in place";
    if (!copied_.contains(source) && import_.is_possible()) {
        try {
            replace(source, PictureTexture(sample, import_));
            return std::nullopt;
        } catch (const std::runtime_error& error) {
            reason = error.what();
        }
    }
    if (const std::optional<Sample> bytes = sample.copied()) copy(source, *bytes);
    return copied_.insert(source).second ? std::optional(reason) : std::nullopt;
}

void UploadedPictures::copy(SourceId source, const Sample& sample) {
    const auto place = textures_.find(source);
    if (place == textures_.end() || !place->second.fits(sample)) replace(source, PictureTexture(sample));
    textures_.at(source).upload(sample);
}

void UploadedPictures::replace(SourceId source, PictureTexture texture) {
    const auto [place, is_new] = textures_.try_emplace(source, std::move(texture));
    if (is_new) return;
    give_back(place->second);
    place->second = std::move(texture);
}

/// Keeps a replaced picture for a while: the decoder will write into it, but the graphics card may still read
/// it.
void UploadedPictures::give_back(const PictureTexture& texture) {
    if (texture.lender()) {
        Lent lent{.lender = texture.lender(), .read = {}};
        lent.read.reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
        lent_.push_back(std::move(lent));
    }
    while (!lent_.empty() && glClientWaitSync(lent_.front().read.get(), 0, 0) != GL_TIMEOUT_EXPIRED)
        lent_.pop_front();
}

void UploadedPictures::forget(SourceId source) {
    copied_.erase(source);
    slides_.erase(source);
    const auto place = textures_.find(source);
    if (place == textures_.end()) return;
    give_back(place->second);
    textures_.erase(place);
}

}  // namespace vitrine::player
