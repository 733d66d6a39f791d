#include "player/playback/sound/sound_fade.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <span>

namespace vitrine::player {

namespace {

constexpr std::chrono::duration<double> fade_time{0.2};

}  // namespace

void SoundFade::apply(GstBuffer* buffer, int rate, int channels) {
    const bool is_leaving = is_leaving_;
    if (!is_leaving && gain_ >= 1) return;
    GstMapInfo map;
    if (!gst_buffer_map(buffer, &map, GST_MAP_READWRITE)) return;
    const double step = (is_leaving ? -1 : 1) / (rate * fade_time.count());
    const std::span<float> samples(static_cast<float*>(static_cast<void*>(map.data)),
                                   map.size / sizeof(float));
    const auto width = static_cast<std::size_t>(channels);
    for (std::size_t i = 0; i + width <= samples.size(); i += width) {
        gain_ = std::clamp(gain_ + step, 0.0, 1.0);
        for (float& sample : samples.subspan(i, width))
            sample *= static_cast<float>(gain_);
    }
    gst_buffer_unmap(buffer, &map);
}

}  // namespace vitrine::player
