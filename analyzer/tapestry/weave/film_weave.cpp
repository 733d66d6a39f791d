#include "analyzer/tapestry/weave/film_weave.hpp"

#include "analyzer/film/shot_detector.hpp"
#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/synthesis/frame_fitness.hpp"
#include "analyzer/tapestry/weave/candidate_writer.hpp"
#include "analyzer/tapestry/weave/frame_sheets.hpp"
#include "analyzer/tapestry/weave/level_files.hpp"
#include "analyzer/tapestry/weave/zoom_files.hpp"
#include "base/state/media_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;
using std::chrono::nanoseconds;

namespace {

void remove_other_tiles(const fs::path& directory, const std::string& kept) {
    std::vector<fs::path> others;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory))
        if (entry.path().filename().string().starts_with("tiles-") && entry.path().filename() != kept)
            others.push_back(entry.path());
    for (const fs::path& other : others)
        fs::remove_all(other);
}

/// The number of levels that an earlier weaving into the same folder of tiles has finished.
std::size_t levels_woven(const fs::path& directory, const Tapestry& tapestry) {
    std::error_code error;
    if (!fs::exists(directory / "index.json", error)) return 0;
    try {
        const Tapestry before = read_tapestry(directory);
        const bool is_same = before.folder == tapestry.folder && before.bytes == tapestry.bytes &&
                             before.mtime_ns == tapestry.mtime_ns;
        return is_same ? before.levels.size() : 0;
    } catch (const std::runtime_error&) {  // loading one record: it is woven anew
        return 0;
    }
}

std::uint64_t tile_bytes(const fs::path& folder) {
    std::uint64_t bytes = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) bytes += entry.file_size();
    return bytes;
}

/// Says if a level of that width may be begun, judged by the bytes of the levels so far, at least one.
bool has_room(const Tapestry& tapestry, std::uint64_t bytes, int width, std::uint64_t max_bytes) {
    if (max_bytes == 0) return true;
    double columns = 0;
    for (const TapestryLevel& level : tapestry.levels)
        columns += level.width;
    return static_cast<double>(bytes) * (1 + width / columns) <= static_cast<double>(max_bytes);
}

KeyframeRules rules_of(const Candidates& candidates) {
    std::vector<FilmPart> shots;
    for (const Shot& shot : candidates.film().shots)
        shots.push_back({shot.begin, shot.end});
    const std::vector<FrameSignature>& frames = candidates.signatures();
    return {.frames = frames, .fit = fit_frames(frames, shots), .takes = takes_of(frames, shots)};
}

}  // namespace

Brickwork brickwork_of(const Keyframes& keyframes, cv::Size brick) {
    return {.keyframes = static_cast<int>(keyframes.size()), .brick = brick};
}

TapestryLevel level_of(const Keyframes& keyframes, const Candidates& candidates) {
    TapestryLevel level{.width = brickwork_of(keyframes, candidates.brick()).width(), .keyframes = {}};
    for (const int frame : keyframes)
        level.keyframes.push_back(candidates.signatures()[as_index(frame)].time);
    return level;
}

cv::Mat woven_strip(const Film& film, const Keyframes& keyframes, const RetargetSettings& settings,
                    const RunTasks& run) {
    const Brickwork brickwork = brickwork_of(keyframes, film.candidates->brick());
    cv::Mat strip(tapestry_height(brickwork), brickwork.width(), CV_8UC3);
    int done = 0;  // columns
    weave_level(
        {.brickwork = brickwork,
         .keyframe = [&](int k) { return film.candidates->keyframe(keyframes[as_index(k)]); }},
        [&](const cv::Mat& columns, const WovenSoFar&) {
            columns.copyTo(strip.colRange(done, done + columns.cols));
            done += columns.cols;
        },
        settings, run);
    return strip;
}

Film film_of(UniqueFd frames, FaceDetector* faces) {
    Film film{.candidates = std::make_unique<Candidates>(std::move(frames), faces)};
    film.duration = film.candidates->duration();
    return film;
}

MediaRecord watched_film(FrameSource& source, const std::function<void(const FilmFrame&)>& seen) {
    ShotDetector detector;
    MediaRecord film{.kind = MediaKind::film};
    const auto add = [&](const std::vector<DetectedShot>& shots) {
        for (const DetectedShot& shot : shots)
            film.shots.push_back(
                {.begin = shot.begin, .end = shot.end, .ends_with = shot.ends_with, .region = {}});
    };
    FilmFrame last;
    while (const std::optional<FilmFrame> frame = source.next()) {
        seen(*frame);
        const bool is_next =
            last.picture.empty() || (frame->time > last.time && frame->picture.size() == last.picture.size());
        if (!is_next) continue;  // its stream is broken
        add(detector.push(*frame));
        last = *frame;
    }
    film.width = source.info().width;
    film.height = source.info().height;
    film.duration = source.info().duration;
    if (!last.picture.empty()) add(detector.finish(std::max(film.duration, last.time + nanoseconds(1))));
    return film;
}

Film gathered(FrameSource& source, const fs::path& directory, FaceDetector* faces) {
    CandidateWriter writer(nameless_file(directory));
    const MediaRecord record = watched_film(source, [&](const FilmFrame& frame) { writer.push(frame); });
    if (writer.is_empty()) throw MediaError(MediaState::failed, "it holds no picture that can be decoded");
    return film_of(writer.finish(record, {}), faces);
}

std::vector<Keyframes> chosen_keyframes(const Candidates& candidates, const WeaveChoice& choice,
                                        const RunTasks& run) {
    const auto& frames = candidates.signatures();
    KeyframeSettings settings{.max_levels = choice.max_levels, .rules = std::nullopt};
    const KeyframeChoice& chosen = choice.chosen;
    if (choice.is_uniform) {
        const Affinity costs = time_affinity(frames);
        return refined_levels(costs, uniform_keyframes(costs.frames(), settings.first), settings);
    }
    settings.rules = rules_of(candidates);
    for (std::size_t frame = 0; frame < frames.size(); ++frame)
        if (is_struck(chosen, frames[frame].time)) settings.rules->fit[frame] = false;
    settings.chosen = keyframes_at(frames, chosen.keyframes);
    Affinity costs = affinity(frames, {}, run);
    if (chosen.is_only) return refined_levels(std::move(costs), std::move(settings.chosen), settings);
    return keyframe_levels(std::move(costs), settings);
}

std::string new_tile_folder(const fs::path& directory) {
    for (int number = 1;; ++number) {
        std::string name = fmt::format("tiles-{}", number);
        const bool is_taken =
            fs::exists(directory / (name + sharp_suffix)) || fs::exists(directory / (name + first_suffix));
        if (!is_taken && fs::create_directories(directory / name)) return name;
    }
}

void replace_tapestry(const fs::path& directory, const fs::path& index) {
    const Tapestry tapestry = read_tapestry(index);
    write_tapestry(directory, tapestry);
    fs::remove_all(index);
}

/// Writes the newest level of the tapestry: its tiles, its zoom fields, then the index that names them.
void PyramidWriter::write_newest_level(const Tapestry& tapestry, const Keyframes& keyframes) const {
    const Candidates& candidates = *film_.candidates;
    const std::size_t number = tapestry.levels.size() - 1;
    const Brickwork brickwork = brickwork_of(keyframes, candidates.brick());
    LevelFiles files(directory_, tapestry, number, brickwork);
    weave_level(
        {.brickwork = brickwork,
         .keyframe = [&](int k) { return candidates.keyframe(keyframes[as_index(k)]); }},
        [&](const cv::Mat& columns, const WovenSoFar& done) { files.add(columns, done); }, settings_.retarget,
        run_, files.done());
    files.finish();
    if (number > 0) write_zoom(directory_, tapestry, number, run_);
    write_tapestry(index_folder(), tapestry);
    files.remove_note();
}

Tapestry PyramidWriter::write(Tapestry tapestry, const WeavePlan& plan) const {
    const Candidates& candidates = *film_.candidates;
    tapestry.duration = film_.duration;
    tapestry.folder = plan.folder;
    tapestry.height = tapestry_height(brickwork_of(plan.levels[0], candidates.brick()));
    tapestry.tile_width = tile_file_width;
    tapestry.brick_width = candidates.brick().width;
    tapestry.kept = write_frame_sheets(directory_, tapestry, candidates);
    tapestry.digits = write_digits(directory_, tapestry);
    const std::uint64_t sheets = tile_bytes((directory_ / tapestry.sheet_name(0)).parent_path());
    const std::uint64_t max_bytes =
        settings_.max_bytes > 0 ? std::max<std::uint64_t>(settings_.max_bytes, sheets + 1) - sheets : 0;
    const std::size_t woven = levels_woven(index_folder(), tapestry);
    for (std::size_t i = 0; i < plan.levels.size(); ++i) {
        const Brickwork brickwork = brickwork_of(plan.levels[i], candidates.brick());
        if (i > 0 && !has_room(tapestry, tile_bytes(directory_ / tapestry.folder) - sheets, brickwork.width(),
                               max_bytes))
            break;
        tapestry.levels.push_back(level_of(plan.levels[i], candidates));
        tapestry.levels.back().has_zoom = i > 0;
        if (i >= woven) write_newest_level(tapestry, plan.levels[i]);
    }
    tapestry.is_complete = settings_.is_last;
    write_tapestry(index_folder(), tapestry);
    if (tapestry.is_complete && settings_.index.empty()) remove_other_tiles(directory_, tapestry.folder);
    return tapestry;
}

}  // namespace vitrine::analyzer
