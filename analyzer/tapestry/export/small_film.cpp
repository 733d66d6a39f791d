#include "analyzer/tapestry/export/small_film.hpp"

#include "analyzer/store/clip_form.hpp"
#include "analyzer/store/clip_reader.hpp"
#include "analyzer/store/clip_writer.hpp"
#include "base/state/media_error.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

namespace vitrine::analyzer {

namespace {

using std::chrono::nanoseconds;

constexpr int max_film_side = 640;  // px
constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max();

/// Hands the frames over one after another. The first one stands from the film's begin on.
void copy_frames(ClipReader& reader, std::optional<ClipFrame> frame, ClipWriter& writer) {
    nanoseconds time{0};
    while (frame) {
        writer.push(frame->sample.get(), time);
        frame = reader.next();
        if (frame) time = frame->time;
    }
}

}  // namespace

void require_film_encoder() {
    if (!ClipWriter::has_encoder())
        throw std::runtime_error("a page needs a film, and GStreamer's encoder x264enc is missing (Debian: "
                                 "gstreamer1.0-plugins-ugly)");
}

SmallFilmSize write_small_film(const std::string& film, const MediaInfo& info, nanoseconds duration,
                               const std::filesystem::path& file) {
    const std::optional<ClipForm> form = clip_form(info, max_film_side);
    if (!form) throw MediaError(MediaState::unsupported, "it is too small for a page's film");
    ClipReader reader(film, *form);
    std::optional<ClipFrame> first = reader.next();
    if (!first) throw MediaError(MediaState::failed, "it holds no picture that can be decoded");
    try {
        ClipWriter writer(file, first->sample.get(), any_size);
        copy_frames(reader, std::move(first), writer);
        writer.finish(duration);
    } catch (const ClipError& error) {
        throw std::runtime_error(fmt::format("'{}': {}", file.string(), error.what()));
    }
    return {.width = form->width, .height = form->height};
}

}  // namespace vitrine::analyzer
