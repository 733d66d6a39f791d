#include "bench/analysis/take.hpp"

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/one_file/analyze.hpp"
#include "bench/analysis/region_score.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> sorted(const fs::path& folder) {
    std::vector<fs::path> files(fs::directory_iterator(folder), {});
    std::sort(files.begin(), files.end());
    return files;
}

std::chrono::nanoseconds frame_time(const Take& take, std::size_t frame) {
    return std::chrono::nanoseconds(std::llround(static_cast<double>(frame) / take.fps * 1e9));
}

}  // namespace

Take read_take(const fs::path& folder, int side) {
    Take take{.name = folder.filename().string(), .frames = {}, .masks = {}};
    for (const fs::path& file : sorted(folder / "frames"))
        take.frames.push_back(picture(file, side));
    for (const fs::path& file : sorted(folder / "masks")) {
        cv::Mat mask;
        cv::cvtColor(picture(file, side), mask, cv::COLOR_BGR2GRAY);
        take.masks.push_back(mask > 0);
    }
    return take;
}

TakeSource::TakeSource(const Take& take)
    : take_(take),
      info_{.kind = MediaKind::film,
            .width = take.frames.front().cols,
            .height = take.frames.front().rows,
            .duration = frame_time(take, take.frames.size())} {}

std::optional<FilmFrame> TakeSource::next() {
    if (count_ == take_.frames.size()) return std::nullopt;
    const cv::Mat& frame = take_.frames[count_];
    const double scale = std::min(1.0, AnalysisSettings{}.frame_size / static_cast<double>(info_.width));
    FilmFrame result{.time = frame_time(take_, count_++)};
    cv::resize(frame, result.picture, {}, scale, scale, cv::INTER_AREA);
    return result;
}

EncodedTake::EncodedTake(const Take& take) : take_(take) {
    if (std::system("command -v ffmpeg >/dev/null") != 0) return;
    file_ = fs::temp_directory_path() / fmt::format("vitrine-take-{}.mp4", getpid());
    const cv::Size size = take.frames.front().size();
    const std::string command =
        fmt::format("ffmpeg -loglevel error -y -f rawvideo -pix_fmt bgr24 -s {}x{} -r {} -i - -c:v libx264 "
                    "-preset veryfast -crf 28 -pix_fmt yuv420p '{}'",
                    size.width, size.height, take.fps, file_.string());
    FILE* pipe = popen(command.c_str(), "w");
    for (const cv::Mat& frame : take.frames)
        std::fwrite(frame.data, 3, frame.total(), pipe);
    if (pclose(pipe) != 0) file_.clear();
}

EncodedTake::~EncodedTake() {
    if (!file_.empty()) fs::remove(file_);
}

MediaRecord EncodedTake::analyzed(const AnalysisSettings& settings) const {
    if (!file_.empty()) return analyze(*open_media(file_.string(), settings.frame_size), settings);
    TakeSource source(take_);
    return analyze(source, settings);
}

Polygon region_at(const MediaRecord& record, std::chrono::nanoseconds time) {
    for (const Shot& shot : record.shots) {
        if (time < shot.begin || time >= shot.end) continue;
        const double since = std::chrono::duration<double>(time - shot.begin).count();
        return transformed(shot.region.polygon, 1, shot.region.drift * since);
    }
    return {};
}

}  // namespace vitrine::analyzer
