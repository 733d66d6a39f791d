#include "analyzer/weave/film_weave.hpp"

#include "analyzer/weave/picture_file.hpp"
#include "analyzer/weave/zoom_files.hpp"
#include "base/catalogue/media_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace fs = std::filesystem;
using std::chrono::nanoseconds;

namespace {

constexpr int tile_file_width = 512;  // px

/// Cuts a strip that comes in columns into files.
class TileWriter {
  public:
    TileWriter(const fs::path& directory, const Tapestry& tapestry, std::size_t level)
        : directory_(directory), tapestry_(tapestry), level_(level) {}

    void add(const cv::Mat& columns) {
        if (pending_.empty())
            pending_ = columns.clone();
        else
            cv::hconcat(pending_, columns, pending_);
        while (pending_.cols >= tapestry_.tile_width) {
            write(pending_.colRange(0, tapestry_.tile_width).clone());
            pending_ = pending_.colRange(tapestry_.tile_width, pending_.cols).clone();
        }
    }

    void finish() {
        if (!pending_.empty()) write(pending_);
    }

  private:
    void write(const cv::Mat& tile) { write_jpeg(directory_ / tapestry_.tile_name(level_, next_++), tile); }

    const fs::path& directory_;  // both outlive the writer
    const Tapestry& tapestry_;
    std::size_t level_;
    int next_ = 0;
    cv::Mat pending_;
};

/// A name of its own for each weaving, so that readers of the one before lose nothing.
std::string new_folder(const fs::path& directory) {
    for (int number = 1;; ++number) {
        std::string name = fmt::format("tiles-{}", number);
        if (fs::create_directories(directory / name)) return name;
    }
}

void remove_other_tiles(const fs::path& directory, const std::string& kept) {
    std::vector<fs::path> others;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory))
        if (entry.path().filename().string().starts_with("tiles-") && entry.path().filename() != kept)
            others.push_back(entry.path());
    for (const fs::path& other : others)
        fs::remove_all(other);
}

Brickwork brickwork_of(const Keyframes& keyframes, cv::Size brick) {
    return {.keyframes = static_cast<int>(keyframes.size()), .brick = brick};
}

}  // namespace

Film gathered(FrameSource& source, const fs::path& directory, FaceDetector* faces) {
    std::optional<VideoFrame> frame = source.next();
    if (!frame) throw MediaError(MediaState::failed, "it holds no picture that can be decoded");
    const cv::Size size = frame->picture.size();
    Film film{.candidates = std::make_unique<Candidates>(brick_for(size), directory, faces)};
    nanoseconds last{-1};
    for (; frame; frame = source.next()) {
        if (frame->time <= last || frame->picture.size() != size) continue;  // of a broken stream
        film.candidates->push(*frame);
        last = frame->time;
    }
    film.duration = std::max(source.info().duration, last + nanoseconds(1));
    return film;
}

std::vector<Keyframes> chosen_keyframes(const Candidates& candidates, const WeaveChoice& choice,
                                        const RunTasks& run) {
    const auto& frames = candidates.signatures();
    const KeyframeSettings settings{.most_levels = choice.most_levels};
    const Affinity costs = choice.is_uniform ? time_affinity(frames) : affinity(frames, {}, run);
    if (!choice.times.empty()) return refined_levels(costs, keyframes_at(frames, choice.times), settings);
    if (choice.is_uniform)
        return refined_levels(costs, uniform_keyframes(costs.frames(), settings.first), settings);
    return keyframe_levels(costs, settings);
}

Tapestry write_pyramid(const fs::path& directory, Tapestry tapestry, const Film& film,
                       const std::vector<Keyframes>& levels, const RetargetSettings& settings,
                       const RunTasks& run) {
    const Candidates& candidates = *film.candidates;
    tapestry.duration = film.duration;
    tapestry.folder = new_folder(directory);
    tapestry.tile_width = tile_file_width;
    tapestry.brick_width = candidates.brick().width;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const Brickwork brickwork = brickwork_of(levels[i], candidates.brick());
        TapestryLevel level{.width = brickwork.width(), .keyframes = {}};
        for (const int frame : levels[i])
            level.keyframes.push_back(candidates.signatures()[static_cast<std::size_t>(frame)].time);
        fs::create_directories(directory / tapestry.folder / fmt::format("{}", i));
        tapestry.height = tapestry_height(brickwork);
        TileWriter tiles(directory, tapestry, i);
        weave_level(
            brickwork, [&](int k) { return candidates.keyframe(levels[i][static_cast<std::size_t>(k)]); },
            [&](const cv::Mat& columns) { tiles.add(columns); }, settings, run);
        tiles.finish();
        tapestry.levels.push_back(std::move(level));
        if (i > 0) {
            write_zoom(directory, tapestry, i, run);
            tapestry.levels.back().has_zoom = true;
        }
        tapestry.is_complete = i + 1 == levels.size();
        write_tapestry(directory, tapestry);
    }
    remove_other_tiles(directory, tapestry.folder);
    return tapestry;
}

}  // namespace vitrine
