#include "analyzer/film/frame_reader.hpp"

#include "analyzer/film/film_source.hpp"
#include "analyzer/film/photo_source.hpp"
#include "base/media/media_type.hpp"

namespace vitrine::analyzer {
namespace {

// Small faces need so many px. A film has them in FilmFrame::finer, and a photo in its only picture.
constexpr int photo_enlargement = 2;

}  // namespace

std::unique_ptr<FrameSource> open_media(const std::string& path, int analysis_size, Colour background) {
    if (kind_of(media_format(path)) == MediaKind::photo)
        return std::make_unique<PhotoSource>(path, photo_enlargement * analysis_size, background);
    return std::make_unique<FilmSource>(path, analysis_size, background);
}

}  // namespace vitrine::analyzer
