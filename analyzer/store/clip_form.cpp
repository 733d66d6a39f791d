#include "analyzer/store/clip_form.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace {

constexpr int min_side = 16;  // px, for x264enc

int even(double length) {
    return 2 * std::max(1, static_cast<int>(std::lround(length / 2)));
}

}  // namespace

std::optional<ClipForm> clip_form(const MediaInfo& film, int max_side) {
    const int longest = std::max(film.width, film.height);
    if (longest <= 0) return std::nullopt;
    const double scale = std::min(1.0, static_cast<double>(max_side) / longest);
    const ClipForm form{.width = even(film.width * scale),
                        .height = even(film.height * scale),
                        .turn = film.turn,
                        .colours = film.colours};
    if (std::min(form.width, form.height) < min_side) return std::nullopt;
    return form;
}

int clip_side_for(int slots, int screen_side) {
    constexpr int usual_screen = 1920;
    constexpr int min_clip = 320;
    const int screen = screen_side > 0 ? screen_side : usual_screen;
    constexpr double beyond = 1.2;
    constexpr int step = 16;  // px: a macroblock
    const double side = screen * beyond / std::sqrt(std::max(1, slots));
    return std::clamp(step * static_cast<int>(std::lround(side / step)), min_clip,
                      std::max(min_clip, screen));
}

}  // namespace vitrine::analyzer
