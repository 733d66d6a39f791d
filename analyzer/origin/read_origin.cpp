#include "analyzer/origin/read_origin.hpp"

#include "analyzer/origin/exif_block.hpp"
#include "analyzer/origin/exif_facts.hpp"
#include "analyzer/origin/film_facts.hpp"
#include "analyzer/origin/own_caption.hpp"
#include "base/media/media_type.hpp"
#include "base/state/media_error.hpp"
#include "base/system/log.hpp"

namespace vitrine::analyzer {

namespace {

MediaOrigin camera_facts(const std::string& path) {
    try {
        const MediaFormat format = media_format(path);
        if (format == MediaFormat::mp4) return film_facts(path);
        MediaOrigin origin = exif_facts(exif_block(path, format));
        origin.caption = own_caption(path, format);
        return origin;
    } catch (const MediaError& error) {  // whoever decodes the file says so
        log::debug("no time of a camera: {}", error.what());
        return {};
    }
}

}  // namespace

MediaOrigin read_origin(const std::string& path, std::int64_t mtime_ns,
                        std::chrono::system_clock::time_point now) {
    MediaOrigin origin = camera_facts(path);
    if (origin.taken && is_plausible(origin.taken->at, now)) return origin;
    const auto own = std::chrono::floor<std::chrono::milliseconds>(
        std::chrono::sys_time<std::chrono::nanoseconds>(std::chrono::nanoseconds(mtime_ns)));
    origin.taken.reset();
    if (is_plausible(own, now))
        origin.taken = TimeTaken{.at = own, .zone = zone_here(own), .source = TimeSource::file};
    return origin;
}

}  // namespace vitrine::analyzer
