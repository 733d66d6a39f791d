#include "analyzer/film/frame_reader.hpp"

#include "analyzer/film/film_source.hpp"
#include "analyzer/film/photo_source.hpp"
#include "base/media/media_type.hpp"

namespace vitrine::analyzer {
namespace {

// A photo has one picture, so all is searched in as many px as faces need; a film has them in
// FilmFrame::finer.
constexpr int photo_enlargement = 2;

}  // namespace

std::unique_ptr<FrameSource> open_media(const std::string& path, int analysis_size, Colour background) {
    if (kind_of(media_format(path)) == MediaKind::photo)
        return std::make_unique<PhotoSource>(path, photo_enlargement * analysis_size, background);
    return std::make_unique<FilmSource>(path, analysis_size, background);
}

}  // namespace vitrine::analyzer
