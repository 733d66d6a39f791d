#include "analyzer/file_analysis.hpp"

#include "analyzer/analyze.hpp"
#include "analyzer/explain_file.hpp"
#include "analyzer/video/frame_reader.hpp"
#include "base/catalogue/media_error.hpp"
#include "base/media/colour.hpp"
#include "base/system/error.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

namespace vitrine {

namespace fs = std::filesystem;

namespace {

AnalysisSettings analysis_settings(const Settings::Analyzer& from) {
    const bool is_letter = from.region == "hull";
    AnalysisSettings settings = is_letter ? papers_letter() : AnalysisSettings{};
    settings.frame_size = from.frame_size;
    settings.samples_per_second = std::max(1, static_cast<int>(std::lround(from.samples_per_second)));
    settings.face_cascade = from.face_cascade;
    if (is_letter) return settings;
    settings.weights = {.motion = from.motion_weight, .image = from.image_weight, .face = from.face_weight};
    settings.region.mass = from.region_mass;
    settings.region.margin = from.region_margin;
    settings.face_model = from.face_model;
    settings.saliency_model = from.saliency_model;
    return settings;
}

std::string path_in_record(const fs::path& file, const fs::path& root) {
    const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(
        (fs::absolute(root) / "").lexically_normal());
    const bool is_inside = !relative.empty() && *relative.begin() != ".." && relative != ".";
    return is_inside ? relative.string() : file.string();
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

/// Path, bytes and mtime are the same in all that is said of a file.
void name(MediaRecord& record, const fs::path& file, const struct stat& status, const Settings& settings) {
    record.path = path_in_record(file, settings.media.root);
    record.bytes = static_cast<std::uint64_t>(status.st_size);
    record.mtime_ns = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
}

/// Whatever the file is, there is something to say of it.
MediaRecord analysed(const fs::path& file, const struct stat& status, const Settings& settings,
                     const GrowthObserver& grown) {
    const auto without_shots = [](MediaState state, const std::string& reason) {
        MediaRecord record;
        record.state = state;
        record.reason = reason;
        return record;
    };
    MediaRecord known;
    const auto keep = [&](const MediaRecord& part) {
        if (known.shots.empty())
            known = part;
        else
            known.shots.insert(known.shots.end(), part.shots.begin(), part.shots.end());
        grown(part);
    };
    try {
        return analyze(*opened(file, status, settings), analysis_settings(settings.analyzer), {}, keep);
    } catch (const MediaError& error) {
        const bool is_kept = error.state() == MediaState::failed && !known.shots.empty();
        return is_kept ? known_part(known, error) : without_shots(error.state(), error.what());
    } catch (const std::bad_alloc&) {
        return without_shots(MediaState::failed,
                             fmt::format("it needs more memory than {} MiB", settings.analyzer.memory));
    }
}

}  // namespace

MediaRecord record_of_file(const fs::path& file, const Settings& settings,
                           const std::function<void(const MediaRecord&)>& grown) {
    const struct stat status = status_of(file);
    const auto tell = [&](MediaRecord part) {
        if (!grown) return;
        name(part, file, status, settings);
        grown(part);
    };
    MediaRecord record = analysed(file, status, settings, tell);
    name(record, file, status, settings);
    return record;
}

MediaRecord explain_file(const fs::path& file, const std::string& sheet, const Settings& settings) {
    const struct stat status = status_of(file);
    const SheetTitle title{.name = file.filename().string(),
                           .bytes = static_cast<std::uint64_t>(status.st_size)};
    return write_explain_sheet([&] { return opened(file, status, settings); }, title, sheet,
                               analysis_settings(settings.analyzer));
}

}  // namespace vitrine
