#include "analyzer/one_file/file_analysis.hpp"

#include "analyzer/one_file/analyze.hpp"
#include "analyzer/one_file/explain_file.hpp"
#include "analyzer/status/thumbnail.hpp"
#include "analyzer/store/store_writer.hpp"
#include "analyzer/tapestry/tapestry_state.hpp"
#include "analyzer/tapestry/weave/kept_frames.hpp"
#include "analyzer/video/frame_reader.hpp"
#include "base/media/colour.hpp"
#include "base/media/media_type.hpp"
#include "base/media/stream_end.hpp"
#include "base/state/catalogue.hpp"
#include "base/state/media_error.hpp"
#include "base/state/screen_note.hpp"
#include "base/state/tapestry.hpp"
#include "base/system/error.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

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
    settings.face_model = from.face_model;
    settings.saliency_model = from.saliency_model;
    return settings;
}

struct stat status_of(const fs::path& file) {
    struct stat status {};

    if (::stat(file.c_str(), &status) < 0) throw_errno("look at '{}'", file.string());
    return status;
}

std::unique_ptr<FrameSource> opened(const fs::path& file, const struct stat& status,
                                    const Settings& settings) {
    if (!S_ISREG(status.st_mode)) throw MediaError(MediaState::unsupported, "it is not a plain file");
    return open_media(file.string(), settings.analyzer.frame_size,
                      colour_named(settings.show.background).value_or(Colour{}));
}

/// Path, bytes and mtime are the same in all that is said of a file.
MediaRecord name(MediaRecord record, const fs::path& file, const struct stat& status,
                 const Settings& settings) {
    record.path = record_path(file, settings.media.root);
    record.bytes = static_cast<std::uint64_t>(status.st_size);
    record.mtime_ns = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
    return record;
}

/// A source that lets something be done before and with each of its frames.
class AttendedSource : public FrameSource {
  public:
    AttendedSource(FrameSource& source, std::function<void()> attend,
                   std::function<void(const VideoFrame&)> saw)
        : source_(source), attend_(std::move(attend)), saw_(std::move(saw)) {}

    const MediaInfo& info() const override { return source_.info(); }

    std::optional<VideoFrame> next() override {
        attend_();
        std::optional<VideoFrame> frame = source_.next();
        if (frame) saw_(*frame);
        return frame;
    }

  private:
    FrameSource& source_;  // outlives this
    std::function<void()> attend_;
    std::function<void(const VideoFrame&)> saw_;
};

StorePlace store_place(const fs::path& file, const struct stat& status, const Settings& settings) {
    const MediaRecord named = name({}, file, status, settings);
    constexpr int most_parts = 4;  // of the store that one clip or copy may take
    return {.store = fs::path(settings.state.directory) / "store",
            .id = store_id(named.path, named.bytes, named.mtime_ns),
            .clip_side = clip_side(settings),
            .most_bytes = static_cast<std::uint64_t>(settings.store.max_bytes) / most_parts,
            .least_free = least_free_bytes};
}

fs::path thumbnail_place(const fs::path& file, const Settings& settings) {
    return fs::path(settings.state.directory) / "thumbnails" /
           (record_id(record_path(file, settings.media.root)) + ".jpg");
}

/// What a film that broke off keeps; the last shot ends where the damage begins, or earlier.
MediaRecord known_part(MediaRecord known, const MediaError& error) {
    using std::chrono::seconds;
    const auto end = std::chrono::floor<seconds>(known.shots.back().end).count();
    known.reason =
        fmt::format("shown up to {}:{:02}:{:02}: {}", end / 3600, end / 60 % 60, end % 60, error.what());
    known.is_complete = true;
    known.duration = known.shots.back().end;
    return known;
}

/// The analysis of one file, and what is said of it meanwhile.
class Analysis {
  public:
    Analysis(const fs::path& file, const struct stat& status, const Settings& settings,
             const Keeping& keeping, const GrowthObserver& grown)
        : file_(file), status_(status), settings_(settings), keeping_(keeping), grown_(grown) {
        if (keeping.has_thumbnail) thumbnail_.emplace(thumbnail_place(file, settings));
    }

    /// Whatever the file is, there is something to say of it.
    MediaRecord record() {
        try {
            return analysed();
        } catch (const MediaError& error) {
            const bool is_kept = error.state() == MediaState::failed && !known_.shots.empty();
            if (!is_kept) return without_shots(error.state(), error.what());
            known_ = known_part(std::move(known_), error);
            if (frames_) frames_->finish(known_.duration, content());
            if (keeper_) keeper_->complete(known_);
            return known_;
        } catch (const std::bad_alloc&) {
            return without_shots(MediaState::failed,
                                 fmt::format("it needs more memory than {} MiB", settings_.analyzer.memory));
        }
    }

  private:
    static MediaRecord without_shots(MediaState state, const std::string& reason) {
        MediaRecord record;
        record.state = state;
        record.reason = reason;
        return record;
    }

    MediaRecord analysed() {
        if (!keeping_.takes_cut_streams) require_whole_packets(file_.string(), media_format(file_.string()));
        const std::unique_ptr<FrameSource> source = opened(file_, status_, settings_);
        if (keeping_.stores) keeper_ = std::make_unique<Keeper>(file_.string(), source->info(), place());
        if (keeping_.has_frames && source->info().kind == MediaKind::film) keep_frames();
        AttendedSource attended(
            *source, [this] { tell_kept(); },
            [this](const VideoFrame& frame) {
                if (thumbnail_) thumbnail_->saw(frame);
                if (frames_) frames_->saw(frame);
            });
        MediaRecord record = analyze(attended, analysis_settings(settings_.analyzer), {},
                                     [this](const MediaRecord& part) { grow(part); });
        if (thumbnail_) thumbnail_->write(record);
        if (frames_) frames_->finish(record.duration, content());
        if (keeper_) keeper_->complete(record);
        return record;
    }

    FilmContent content() const {
        const MediaRecord named = name({}, file_, status_, settings_);
        return {.bytes = named.bytes, .mtime_ns = named.mtime_ns};
    }

    void keep_frames() {
        const MediaRecord named = name({}, file_, status_, settings_);
        const fs::path folder = tapestry_folder(settings_.state.directory, named.path);
        if (tapestry_state(folder, named.bytes, named.mtime_ns) != TapestryState::lacking) return;
        frames_.emplace(folder, tapestry_share(static_cast<std::uint64_t>(settings_.tapestry.max_bytes)));
    }

    StorePlace place() const {
        StorePlace place = store_place(file_, status_, settings_);
        place.wants_sound = keeping_.has_sound;
        return place;
    }

    void grow(const MediaRecord& part) {
        std::vector<Shot> shots = std::move(known_.shots);
        shots.insert(shots.end(), part.shots.begin(), part.shots.end());
        known_ = part;
        known_.shots = std::move(shots);
        if (thumbnail_) thumbnail_->write(part);
        grown_(part);
        for (const Shot& shot : part.shots)
            if (keeper_) keeper_->found(shot);
    }

    void tell_kept() {
        if (!keeper_) return;
        for (const Shot& shot : keeper_->news()) {
            MediaRecord part = known_;
            part.shots = {shot};
            grown_(part);
        }
    }

    const fs::path& file_;  // all but keeping outlive the analysis
    const struct stat& status_;
    const Settings& settings_;
    Keeping keeping_;
    const GrowthObserver& grown_;
    MediaRecord known_;  // of a film, with the shots so far
    std::unique_ptr<Keeper> keeper_;
    std::optional<Thumbnail> thumbnail_;
    std::optional<KeptFrames> frames_;
};

}  // namespace

int clip_side(const Settings& settings) {
    if (settings.store.clip_size > 0) return settings.store.clip_size;
    return clip_side_for(settings.layout.slots, noted_screen_side(settings.state.directory));
}

MediaRecord record_of_file(const fs::path& file, const Settings& settings, const Keeping& keeping,
                           const std::function<void(const MediaRecord&)>& grown) {
    const struct stat status = status_of(file);
    const auto tell = [&](const MediaRecord& part) {
        if (grown) grown(name(part, file, status, settings));
    };
    return name(Analysis(file, status, settings, keeping, tell).record(), file, status, settings);
}

bool leave_thumbnail(const fs::path& file, const Settings& settings) {
    const fs::path place = thumbnail_place(file, settings);
    const Catalogue catalogue(fs::path(settings.state.directory) / "catalogue");
    const auto record = catalogue.find(record_path(file, settings.media.root));
    if (!record || record->shots.empty()) return false;
    Thumbnail thumbnail(place);
    const std::unique_ptr<FrameSource> source = opened(file, status_of(file), settings);
    while (const std::optional<VideoFrame> frame = source->next()) {
        if (frame->time < record->shots.front().begin) continue;
        thumbnail.saw(*frame);
        break;
    }
    thumbnail.write(*record);
    return fs::exists(place);
}

MediaRecord explain_file(const fs::path& file, const std::string& sheet, const Settings& settings) {
    const struct stat status = status_of(file);
    const SheetTitle title{.name = file.filename().string(),
                           .bytes = static_cast<std::uint64_t>(status.st_size)};
    return write_explain_sheet([&] { return opened(file, status, settings); }, title, sheet,
                               analysis_settings(settings.analyzer));
}

}  // namespace vitrine::analyzer
