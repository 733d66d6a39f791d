#include "analyzer/tapestry/weave/sharp_frames.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace {

constexpr double worth_reading = 1.2;  // times the height of the kept bricks

}  // namespace

std::optional<SharpFrames> sharp_frames(const Candidates& kept, int wanted_height) {
    const cv::Size frame = kept.frame();
    const double full = kept.film().height > 0 ? static_cast<double>(kept.film().height) / frame.height : 1;
    const int height = std::min(wanted_height, static_cast<int>(kept.active().height * full)) / 2 * 2;
    if (height < worth_reading * kept.brick().height) return std::nullopt;
    const double scale = static_cast<double>(height) / kept.active().height;
    return SharpFrames{.brick_height = height,
                       .frame_size =
                           static_cast<int>(std::ceil(std::max(frame.width, frame.height) * scale))};
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
