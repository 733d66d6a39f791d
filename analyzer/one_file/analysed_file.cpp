#include "analyzer/one_file/analysed_file.hpp"

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/models/model_file.hpp"
#include "analyzer/origin/read_origin.hpp"
#include "analyzer/status/thumbnail_copies.hpp"
#include "base/media/colour.hpp"
#include "base/state/catalogue.hpp"
#include "base/state/media_error.hpp"
#include "base/state/tapestry.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

AnalysedFile::AnalysedFile(const fs::path& file, const Settings& settings)
    : file_(file, settings.media.root), settings_(settings) {}

MediaRecord AnalysedFile::stamped(MediaRecord record) const {
    record.path = file_.path();
    record.bytes = file_.bytes();
    record.mtime_ns = file_.mtime_ns();
    return record;
}

MediaOrigin AnalysedFile::origin() const {
    return read_origin(file_.name(), file_.mtime_ns(), std::chrono::system_clock::now());
}

std::unique_ptr<FrameSource> AnalysedFile::open() const {
    if (!file_.is_plain()) throw MediaError(MediaState::unsupported, "it is not a plain file");
    return open_media(file_.name(), settings_.analyzer.frame_size,
                      colour_named(settings_.show.background).value_or(Colour{}));
}

fs::path AnalysedFile::thumbnail() const {
    return thumbnail_place(fs::path(settings_.state.directory) / "thumbnails", record_id(file_.path()));
}

fs::path AnalysedFile::tapestry() const {
    return tapestry_folder(settings_.state.directory, file_.path());
}

StorePlace AnalysedFile::store_place() const {
    constexpr int max_share = 4;  // one clip or copy takes a quarter of the store at most
    return {.store = fs::path(settings_.state.directory) / "store",
            .id = store_id(file_.path(), file_.bytes(), file_.mtime_ns()),
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
    const Settings::Analyzer usual;
    settings.face_model = find_model(from.face_model, usual.face_model);
    if (from.saliency == SaliencyMethod::plain) return settings;
    settings.is_student = from.saliency == SaliencyMethod::student;
    const std::string student = find_model(from.student_model, usual.student_model);
    settings.saliency_model =
        settings.is_student ? student : find_model(from.saliency_model, usual.saliency_model);
    if (!settings.is_student && !settings.saliency_model.empty()) settings.spare_model = student;
    settings.text_model = find_model(from.text_model, usual.text_model);
    return settings;
}

}  // namespace vitrine::analyzer
