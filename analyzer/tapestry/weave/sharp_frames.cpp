#include "analyzer/tapestry/weave/sharp_frames.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace {

constexpr double worth_reading = 1.2;  // times the height of the kept bricks

}  // namespace

SharpFrames frames_as_tall_as(const Candidates& kept, int brick_height) {
    const cv::Size frame = kept.frame();
    const int side = std::max(frame.width, frame.height);
    const int film_side = std::max({kept.film().width, kept.film().height, side});
    const double full = kept.film().height > 0 ? static_cast<double>(kept.film().height) / frame.height : 1;
    const double largest = std::min(full, static_cast<double>(Candidates::max_side) / side);
    const int whole = static_cast<int>(std::lround(kept.active().height * largest)) / 2 * 2;
    const int height = std::clamp(brick_height / 2 * 2, 2, std::max(2, whole));
    const double scale = static_cast<double>(height) / kept.active().height;
    const int frame_size = height == whole ? film_side : static_cast<int>(std::ceil(side * scale));
    return {.brick_height = height, .frame_size = std::min(frame_size, Candidates::max_side)};
}

std::optional<SharpFrames> sharp_frames(const Candidates& kept, int wanted_height) {
    const SharpFrames size = frames_as_tall_as(kept, wanted_height);
    if (size.brick_height < worth_reading * kept.brick().height) return std::nullopt;
    return size;
}

void read_sharp_frames(FrameSource& source, const Candidates& kept, const Keyframes& finest,
                       const std::function<void(const FilmFrame&)>& keep) {
    auto next = finest.begin();
    while (const std::optional<FilmFrame> frame = source.next()) {
        if (next == finest.end() || frame->time != kept.signatures()[as_index(*next)].time) continue;
        keep(*frame);
        ++next;
    }
}

cv::Rect active_in(const Candidates& kept, cv::Size frame) {
    const double x = static_cast<double>(frame.width) / kept.frame().width;
    const double y = static_cast<double>(frame.height) / kept.frame().height;
    const cv::Rect active = kept.active();
    const cv::Rect part(cv::Point(cvRound(active.x * x), cvRound(active.y * y)),
                        cv::Point(cvRound(active.br().x * x), cvRound(active.br().y * y)));
    return part & cv::Rect({}, frame);
}

std::vector<Keyframes> sharp_levels(const std::vector<Keyframes>& levels) {
    const Keyframes& finest = levels.back();
    std::vector<Keyframes> sharp;
    for (const Keyframes& level : levels) {
        sharp.emplace_back();
        for (const int frame : level)
            sharp.back().push_back(
                static_cast<int>(std::ranges::lower_bound(finest, frame) - finest.begin()));
    }
    return sharp;
}

bool are_frames_of(const Candidates& sharp, const Candidates& kept, const Keyframes& finest) {
    return std::ranges::equal(sharp.signatures(), finest, [&](const FrameSignature& frame, int number) {
        return frame.time == kept.signatures()[as_index(number)].time;
    });
}

}  // namespace vitrine::analyzer
