#include "analyzer/one_file/analysed_file.hpp"

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/models/face_model.hpp"
#include "base/media/colour.hpp"
#include "base/state/catalogue.hpp"
#include "base/state/media_error.hpp"
#include "base/state/tapestry.hpp"
#include "base/system/error.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

AnalysedFile::AnalysedFile(const fs::path& file, const Settings& settings)
    : file_(file), settings_(settings), path_(record_path(file, settings.media.root)) {
    struct stat status {};

    if (::stat(file.c_str(), &status) < 0) throw_errno("look at '{}'", file.string());
    bytes_ = static_cast<std::uint64_t>(status.st_size);
    mtime_ns_ = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
    is_plain_ = S_ISREG(status.st_mode);
}

MediaRecord AnalysedFile::stamped(MediaRecord record) const {
    record.path = path_;
    record.bytes = bytes_;
    record.mtime_ns = mtime_ns_;
    return record;
}

std::unique_ptr<FrameSource> AnalysedFile::open() const {
    if (!is_plain_) throw MediaError(MediaState::unsupported, "it is not a plain file");
    return open_media(file_.string(), settings_.analyzer.frame_size,
                      colour_named(settings_.show.background).value_or(Colour{}));
}

fs::path AnalysedFile::thumbnail() const {
    return fs::path(settings_.state.directory) / "thumbnails" / (record_id(path_) + ".jpg");
}

fs::path AnalysedFile::tapestry() const {
    return tapestry_folder(settings_.state.directory, path_);
}

StorePlace AnalysedFile::store_place() const {
    constexpr int max_share = 4;  // one clip or copy takes a quarter of the store at most
    return {.store = fs::path(settings_.state.directory) / "store",
            .id = store_id(path_, bytes_, mtime_ns_),
            .clip_side = clip_side(settings_),
            .max_bytes = static_cast<std::uint64_t>(settings_.store.max_bytes) / max_share,
            .min_free_bytes = usual_free_bytes};
}

AnalysisSettings analysis_settings(const Settings::Analyzer& from) {
    const bool is_paper_mode = from.region == RegionMode::hull;
    AnalysisSettings settings = is_paper_mode ? paper_mode() : AnalysisSettings{};
    settings.frame_size = from.frame_size;
    settings.samples_per_second = std::max(1, static_cast<int>(std::lround(from.samples_per_second)));
    settings.face_cascade = from.face_cascade;
    if (is_paper_mode) return settings;
    settings.weights = {.motion = from.motion_weight, .image = from.image_weight, .face = from.face_weight};
    settings.region.mass = from.region_mass;
    settings.region.margin = from.region_margin;
    settings.face_model = find_face_model(from.face_model);
    settings.saliency_model = from.saliency_model;
    return settings;
}

}  // namespace vitrine::analyzer
