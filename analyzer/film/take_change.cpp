#include "analyzer/film/take_change.hpp"

#include "analyzer/film/block_motion.hpp"

#include <array>
#include <cmath>

namespace vitrine::analyzer {

namespace {

using std::chrono::milliseconds;

constexpr std::array looked_back{milliseconds{0}, milliseconds{150}, milliseconds{400}};
constexpr std::array looked_ahead{milliseconds{0}, milliseconds{130}, milliseconds{300}, milliseconds{600},
                                  max_return};
constexpr double explained = .07;  // unexplained share: less is one scene, moved
constexpr double same = .11;  // geometric mean of unexplained share and colour difference: less is one scene
constexpr double other_colours = .6;    // colour difference: more is not one scene, whatever motion explains
constexpr double clearly_unlike = .25;  // unexplained share that makes such a change clear, however abrupt
constexpr milliseconds max_flash_length{250};
constexpr double flash_light = 20;  // grey levels by which a flash is brighter
constexpr double flash_rest = .4;   // share of that light at which a flash is over
constexpr double explained_if_flash = .2;
constexpr double same_if_flash = .25;
constexpr int enough_alike = 3;  // pairs of pictures: one may be alike by chance
constexpr double plain = 4;      // deviation of a picture of one colour, which tells nothing

constexpr std::size_t min_steps = 4;  // steps in which a gradual change is looked at
constexpr milliseconds step_length{80};

}  // namespace

namespace {

// Says if the light goes up here and down again soon, or went up shortly before and goes down here.
bool is_in_flash(const FeatureWindow& window, std::size_t before, std::size_t after) {
    const double brighter = window.at(after).mean - window.at(before).mean;
    if (std::abs(brighter) < flash_light) return false;
    const double dark = std::min(window.at(after).mean, window.at(before).mean);
    const double limit = dark + flash_rest * std::abs(brighter);
    if (brighter > 0) {
        for (std::size_t i = after; i <= window.ahead(after, max_flash_length); ++i)
            if (window.at(i).mean < limit) return true;
        return false;
    }
    for (std::size_t i = window.back(before, max_flash_length); i <= before; ++i)
        if (window.at(i).mean < limit) return true;
    return false;
}

}  // namespace

TakeChange take_change(const FeatureWindow& window, std::size_t before, std::size_t after) {
    bool is_clear = true;
    int alike = 0;
    const bool is_flash = is_in_flash(window, before, after);
    const double max_left = is_flash ? explained_if_flash : explained;
    const double max_same = is_flash ? same_if_flash : same;
    for (const milliseconds back : looked_back) {
        const FrameFeatures& earlier = window.at(window.back(before, back));
        for (const milliseconds ahead : looked_ahead) {
            const FrameFeatures& later = window.at(window.ahead(after, ahead));
            if (earlier.deviation < plain && later.deviation < plain) continue;
            const double colours = colour_difference(earlier, later);
            const double left = unexplained(earlier, later).share;
            is_clear = is_clear && colours > other_colours && left > clearly_unlike;
            if (colours > other_colours) continue;
            if ((left < max_left || std::sqrt(left * colours) < max_same) && ++alike == enough_alike)
                return TakeChange::none;
        }
    }
    return is_clear ? TakeChange::clear : TakeChange::likely;
}

GradualChange gradual_change(const FeatureWindow& window, std::size_t first, std::size_t last) {
    const Unexplained ends = unexplained(window.at(first), window.at(last));
    const auto length = static_cast<std::size_t>((window.time(last) - window.time(first)) / step_length);
    const std::size_t steps = std::min(std::max(length, min_steps), last - first);
    double on_way = 0;
    double change = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        const Unexplained step = unexplained(window.at(first + (last - first) * i / steps),
                                             window.at(first + (last - first) * (i + 1) / steps));
        on_way += step.share;
        change += step.still;
    }
    return {.share = ends.share,
            .area = ends.area,
            .unmoved = change > 0 ? on_way / change : 1,
            .on_way = ends.share > 0 ? on_way / ends.share : 1};
}

bool is_new_take(const FeatureWindow& window, std::size_t before, std::size_t after) {
    return take_change(window, before, after) != TakeChange::none;
}

}  // namespace vitrine::analyzer
