#include "analyzer/film/sudden_change.hpp"

#include "analyzer/film/block_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace vitrine::analyzer {

namespace {

using std::chrono::milliseconds;

constexpr double min_step = 4;      // grey levels
constexpr double min_change = 10;   // content change at a cut
constexpr double above_around = 4;  // times the mean change of the frames around
constexpr std::size_t around = 3;   // frames to either side
constexpr double still = .5;        // content change of a still picture: noise of a coder
constexpr double lasting = .6;      // share of the change that must stay
constexpr milliseconds max_flash{300};
constexpr double min_unexplained = .03;  // share: a step of a jerky pan is explained by motion
constexpr double same_shape = .75;       // correlation of two pictures of one scene in another light

struct Hsv {
    int hue = 0;  // 1/256 of a turn
    int saturation = 0;
    int value = 0;
};

Hsv hsv(const std::uint8_t* bgr) {
    const int blue = bgr[0];
    const int green = bgr[1];
    const int red = bgr[2];
    const int value = std::max({blue, green, red});
    const int spread = value - std::min({blue, green, red});
    if (spread == 0) return {.value = value};
    const int sixth = value == red     ? 43 * (green - blue) / spread
                      : value == green ? 85 + 43 * (blue - red) / spread
                                       : 171 + 43 * (red - green) / spread;
    return {.hue = sixth & 255, .saturation = 255 * spread / value, .value = value};
}

// Twice the length of the shorter way around the circle, so that the opposite hue differs by 255.
int hue_change(const Hsv& a, const Hsv& b) {
    const int way = std::abs(a.hue - b.hue);
    return std::min(255, 2 * std::min(way, 256 - way));
}

int change(const Hsv& a, const Hsv& b) {
    const int chroma = std::min(a.saturation * a.value, b.saturation * b.value) / 255;
    const int light = std::max(a.value, b.value);
    return hue_change(a, b) * chroma / 255 + std::abs(a.saturation - b.saturation) * light / 255 +
           std::abs(a.value - b.value);
}

double change_at(const FeatureWindow& window, std::size_t frame) {
    return content_change(window.at(frame - 1), window.at(frame));
}

// The mean change from frame to frame around a frame.
double change_around(const FeatureWindow& window, std::size_t frame) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 1; i <= around; ++i) {
        if (frame > window.first() + i) sum += change_at(window, frame - i), ++count;
        if (frame + i < window.end()) sum += change_at(window, frame + i), ++count;
    }
    return count > 0 ? std::max(still, sum / count) : still;
}

bool lasts(const FeatureWindow& window, std::size_t frame, double change) {
    const auto time = window.time(frame);
    for (std::size_t i = frame + 1; i < window.end() && window.time(i) - time < max_flash; ++i)
        if (content_change(window.at(frame - 1), window.at(i)) < lasting * change) return false;
    for (std::size_t i = frame - 1; i > window.first() && time - window.time(i) < max_flash; --i)
        if (content_change(window.at(i - 1), window.at(frame)) < lasting * change) return false;
    return true;
}

// The correlation of two pictures' greys.
double correlation(const FrameFeatures& a, const FrameFeatures& b) {
    std::int64_t product = 0;
    for (std::size_t i = 0; i < a.detail.size(); ++i)
        product += std::int64_t{a.detail[i]} * b.detail[i];
    const double both = static_cast<double>(product) / static_cast<double>(a.detail.size()) - a.mean * b.mean;
    const double spread = a.deviation * b.deviation;
    return spread > 1 ? both / spread : 0;
}

}  // namespace

double content_change(const FrameFeatures& before, const FrameFeatures& after) {
    const cv::Rect part = common_part(before, after);
    constexpr std::size_t row = 3 * FrameFeatures::signature_width;
    int sum = 0;
    for (int y = part.y; y < part.br().y; ++y)
        for (int x = part.x; x < part.br().x; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * row + static_cast<std::size_t>(3 * x);
            sum += change(hsv(before.signature.data() + i), hsv(after.signature.data() + i));
        }
    return sum / (3.0 * part.area());
}

bool is_sudden_change(const FeatureWindow& window, std::size_t frame) {
    if (frame <= window.first() || frame >= window.end() || window.step_at(frame) < min_step) return false;
    const double change = change_at(window, frame);
    if (change < min_change || change < above_around * change_around(window, frame)) return false;
    const FrameFeatures& before = window.at(frame - 1);
    const FrameFeatures& after = window.at(frame);
    return correlation(before, after) < same_shape && unexplained(before, after).share > min_unexplained &&
           lasts(window, frame, change);
}

}  // namespace vitrine::analyzer
