#include "base/media/tone_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vitrine {

namespace {

constexpr std::int32_t full_light = 16'383;
constexpr double paper_white = 203;  // cd/m2, BT.2408
constexpr double peak = 1000;        // cd/m2; brighter values become full light

// The light in cd/m2 of a coded value in [0, 1]. Source: ST 2084.
double perceptual_quantizer(double value) {
    constexpr double m1 = 2610.0 / 16384;
    constexpr double m2 = 2523.0 / 4096 * 128;
    constexpr double c1 = 3424.0 / 4096;
    constexpr double c2 = 2413.0 / 4096 * 32;
    constexpr double c3 = 2392.0 / 4096 * 32;
    const double root = std::pow(value, 1 / m2);
    return 10'000 * std::pow(std::max(root - c1, 0.0) / (c2 - c3 * root), 1 / m1);
}

// The light in cd/m2 of a value in hybrid log-gamma on a screen of `peak`, with the system gamma for each
// channel. Source: BT.2100.
double hybrid_log_gamma(double value) {
    constexpr double a = 0.17883277;
    constexpr double b = 1 - 4 * a;
    const double c = 0.5 - a * std::log(4 * a);
    const double scene = value <= 0.5 ? value * value / 3 : (std::exp((value - c) / a) + b) / 12;
    return peak * std::pow(scene, 1.2);
}

// Converts light relative to paper white to a share of the light of a usual screen.
double toned(double light) {
    constexpr double white = peak / paper_white;
    return std::min(1.0, light * (1 + light / (white * white)) / (1 + light));
}

// The light of a value of a usual film on its screen (BT.1886), so that a grey stays the same.
constexpr double usual_gamma = 2.4;

double srgb(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

}  // namespace

std::optional<ToneMap> ToneMap::of(const GstVideoColorimetry& colours) {
    const bool is_wide = colours.primaries == GST_VIDEO_COLOR_PRIMARIES_BT2020;
    if (colours.transfer == GST_VIDEO_TRANSFER_ARIB_STD_B67) return ToneMap(Curve::hybrid_log, is_wide);
    if (colours.transfer == GST_VIDEO_TRANSFER_SMPTE2084)
        return ToneMap(Curve::perceptual_quantizer, is_wide);
    if (is_wide) return ToneMap(Curve::usual, true);
    return std::nullopt;
}

ToneMap::ToneMap(Curve curve, bool wide) : code_(full_light + 1) {
    const auto light_of = [curve](double value) {
        switch (curve) {
        case Curve::perceptual_quantizer:
            return toned(perceptual_quantizer(value) / paper_white);
        case Curve::hybrid_log:
            return toned(hybrid_log_gamma(value) / paper_white);
        case Curve::usual:
            break;
        }
        return std::pow(value, usual_gamma);
    };
    for (std::size_t i = 0; i < light_.size(); ++i)
        light_[i] =
            static_cast<std::int32_t>(std::lround(full_light * light_of(static_cast<double>(i) / 255)));
    for (std::size_t i = 0; i < code_.size(); ++i) {
        const double light = static_cast<double>(i) / full_light;
        const double code = curve == Curve::usual ? std::pow(light, 1 / usual_gamma) : srgb(light);
        code_[i] = static_cast<std::uint8_t>(std::lround(255 * code));
    }
    constexpr std::array<std::array<double, 3>, 3> narrower{
        {{1.6605, -0.5876, -0.0729}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1188}}};  // BT.2087
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
            const double same = row == column ? 1 : 0;
            to_bt709_[row][column] =
                static_cast<std::int32_t>(std::lround(4096 * (wide ? narrower[row][column] : same)));
        }
}

void ToneMap::apply(std::span<std::uint8_t> pixels, int channels, bool blue_first) const {
    const auto step = static_cast<std::size_t>(channels);
    const std::size_t red = blue_first ? 2 : 0;
    for (std::size_t at = 0; at + step <= pixels.size(); at += step) {
        const std::array<std::int32_t, 3> light{light_[pixels[at + red]], light_[pixels[at + 1]],
                                                light_[pixels[at + 2 - red]]};
        const auto coded = [&](const std::array<std::int32_t, 3>& row) {
            const std::int32_t sum = row[0] * light[0] + row[1] * light[1] + row[2] * light[2];
            return code_[static_cast<std::size_t>(std::clamp((sum + 2048) >> 12, 0, full_light))];
        };
        pixels[at + red] = coded(to_bt709_[0]);
        pixels[at + 1] = coded(to_bt709_[1]);
        pixels[at + 2 - red] = coded(to_bt709_[2]);
    }
}

}  // namespace vitrine
