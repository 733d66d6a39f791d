#include "tests/player/render/flash_meter.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double min_change = 0.1;   // of relative luminance
constexpr double max_darker = 0.8;   // a darker picture above does not count
constexpr std::size_t too_many = 5;  // changes within a second: more than two pairs

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance_of(const Rgb& colour) {
    return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
}

}  // namespace

void FlashMeter::note(Place& place, double luminance, std::chrono::nanoseconds now) {
    place.low = std::min(place.low, luminance);
    place.high = std::max(place.high, luminance);
    const bool is_brighter =
        place.direction != 1 && luminance - place.low > min_change && place.low < max_darker;
    const bool is_darker =
        place.direction != -1 && place.high - luminance > min_change && luminance < max_darker;
    if (is_brighter || is_darker) {
        place.direction = is_brighter ? 1 : -1;
        place.changes.push_back(now);
        place.low = place.high = luminance;
    }
    std::erase_if(place.changes, [&](auto time) { return now - time >= std::chrono::seconds(1); });
}

void FlashMeter::add(const ReferenceImage& image, std::chrono::nanoseconds now) {
    const bool is_first = places_.empty();
    places_.resize(image.pixels.size());
    std::size_t flashing = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const double luminance = luminance_of(image.pixels[i]);
        if (is_first) places_[i] = {.low = luminance, .high = luminance};
        note(places_[i], luminance, now);
        if (places_[i].changes.size() >= too_many) ++flashing;
        most_ = std::max(most_, places_[i].changes.size());
    }
    worst_ = std::max(worst_, static_cast<double>(flashing) / static_cast<double>(places_.size()));
}

}  // namespace vitrine::player
