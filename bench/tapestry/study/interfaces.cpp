#include "bench/tapestry/study/interfaces.hpp"

#include "analyzer/tapestry/weave/picture_file.hpp"
#include "player/scene/tapestry/tapestry_picture.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace vitrine::study {

namespace {

using player::TapestryPlace;
using player::TapestryView;
using std::chrono::nanoseconds;

constexpr Vec2 screen{1920, 1080};
constexpr double reduction = 4;  // of all that is compared

int reduced(double pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels / reduction)));
}

Vec2 shape_of(cv::Size shape) {
    return {static_cast<double>(shape.width), static_cast<double>(shape.height)};
}

double strip_height(cv::Size shape) {
    return player::tapestry_boxes(screen, shape_of(shape)).strip.height();
}

/// Width of a level on the screen, px.
double level_width(const Tapestry& tapestry, std::size_t level, cv::Size shape) {
    return strip_height(shape) / tapestry.height * tapestry.levels[level].width;
}

cv::Mat read_level(const std::filesystem::path& directory, const Tapestry& tapestry, std::size_t level) {
    std::vector<cv::Mat> tiles;
    for (int tile = 0; tile < tapestry.tiles(level); ++tile) {
        const std::filesystem::path file = directory / tapestry.tile_name(level, tile);
        std::ifstream stream(file, std::ios::binary);
        if (!stream) throw std::runtime_error(fmt::format("'{}': cannot be read", file.string()));
        tiles.push_back(analyzer::from_jpeg(std::string(std::istreambuf_iterator<char>(stream), {})));
    }
    cv::Mat picture;
    cv::hconcat(tiles, picture);
    return picture;
}

SearchedLevel tapestry_level(const std::filesystem::path& directory, const Tapestry& tapestry,
                             std::size_t level, cv::Size shape) {
    const double height = strip_height(shape);
    const double width = level_width(tapestry, level, shape);
    const TapestryPlace place(tapestry, Box{{0, 0}, {width, height}});
    const TapestryView view =
        place.bounded({.centre = tapestry.duration / 2, .level = static_cast<double>(level)});
    SearchedLevel searched;
    cv::resize(read_level(directory, tapestry, level), searched.picture,
               cv::Size(reduced(width), reduced(height)), 0, 0, cv::INTER_AREA);
    const Box brick = place.brick(view, place.picture_at(view, {0, 0}), shape_of(shape));
    searched.frame = {reduced(brick.width()), reduced(brick.height())};
    searched.moment_at = [place, view](cv::Point at) {
        return place.picture_at(view, {(at.x + 0.5) * reduction, (at.y + 0.5) * reduction}).time;
    };
    searched.x_at = [place, view, last = searched.picture.cols - 1](nanoseconds time) {
        return std::clamp(static_cast<int>(place.canvas_x(view, time) / reduction), 0, last);
    };
    return searched;
}

const cv::Mat& frame_at(const FrameTable& frames, nanoseconds time) {
    const auto found = frames.lower_bound(time);
    return found == frames.end() ? frames.rbegin()->second : found->second;
}

SearchedLevel filmstrip_level(const std::vector<nanoseconds>& times, double width, double height,
                              cv::Size shape, const FrameTable& frames) {
    SearchedLevel searched;
    searched.frame = {reduced(height * shape.width / shape.height), reduced(height)};
    searched.picture =
        cv::Mat(reduced(height), std::max(reduced(width), searched.frame.width), CV_8UC3, cv::Scalar::all(0));
    const double spacing = searched.picture.cols / static_cast<double>(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double middle = (static_cast<double>(i) + 0.5) * spacing;
        const int left = std::clamp(static_cast<int>(middle - searched.frame.width / 2.0), 0,
                                    searched.picture.cols - searched.frame.width);
        cv::resize(frame_at(frames, times[i]), searched.picture(cv::Rect({left, 0}, searched.frame)),
                   searched.frame, 0, 0, cv::INTER_AREA);
    }
    const auto last = static_cast<int>(times.size()) - 1;
    searched.moment_at = [times, spacing, last](cv::Point at) {
        return times[static_cast<std::size_t>(std::clamp(static_cast<int>(at.x / spacing), 0, last))];
    };
    const nanoseconds duration = times.front() + times.back();  // both are half a space from an end
    searched.x_at = [duration, right = searched.picture.cols - 1](nanoseconds time) {
        const double share = static_cast<double>(time.count()) / static_cast<double>(duration.count());
        return std::clamp(static_cast<int>(share * (right + 1)), 0, right);
    };
    return searched;
}

SearchedInterface without_levels(const Tapestry& tapestry) {
    return {.levels = {}, .screen_width = reduced(screen.x), .duration = tapestry.duration};
}

}  // namespace

SearchedInterface tapestry_interface(const std::filesystem::path& directory, const Tapestry& tapestry,
                                     cv::Size shape) {
    SearchedInterface interface = without_levels(tapestry);
    for (std::size_t level = 0; level < tapestry.levels.size(); ++level)
        interface.levels.push_back(tapestry_level(directory, tapestry, level, shape));
    return interface;
}

std::vector<std::vector<nanoseconds>> filmstrip_times(const Tapestry& tapestry, cv::Size shape) {
    const double frame_width = strip_height(shape) * shape.width / shape.height;
    std::vector<std::vector<nanoseconds>> levels;
    for (std::size_t level = 0; level < tapestry.levels.size(); ++level) {
        const int count = std::max(1, static_cast<int>(level_width(tapestry, level, shape) / frame_width));
        levels.emplace_back();
        for (int i = 0; i < count; ++i)
            levels.back().push_back(tapestry.duration * (2 * i + 1) / (2 * count));
    }
    return levels;
}

SearchedInterface filmstrip_interface(const Tapestry& tapestry, cv::Size shape, const FrameTable& frames) {
    SearchedInterface interface = without_levels(tapestry);
    const auto times = filmstrip_times(tapestry, shape);
    for (std::size_t level = 0; level < times.size(); ++level)
        interface.levels.push_back(filmstrip_level(times[level], level_width(tapestry, level, shape),
                                                   strip_height(shape), shape, frames));
    return interface;
}

SearchedInterface scrollbar_interface(const Tapestry& tapestry) {
    SearchedInterface interface = without_levels(tapestry);
    const int right = interface.screen_width - 1;
    const nanoseconds duration = tapestry.duration;
    interface.levels.push_back(
        {.picture = {},
         .frame = {1, 1},
         .moment_at = [duration, right](cv::Point at) { return duration * at.x / (right + 1); },
         .x_at =
             [duration, right](nanoseconds time) {
                 const double share =
                     static_cast<double>(time.count()) / static_cast<double>(duration.count());
                 return std::clamp(static_cast<int>(share * (right + 1)), 0, right);
             }});
    return interface;
}

}  // namespace vitrine::study
