#include "player/display/atomic_request.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace vitrine {

namespace {

std::uint32_t property(const PropertyIds& ids, std::string_view name) {
    const auto found = ids.find(name);
    if (found == ids.end()) throw std::runtime_error(fmt::format("the card has no property '{}'", name));
    return found->second;
}

}  // namespace

AtomicRequest modeset_request(const Output& output, const OutputProperties& properties,
                              std::uint32_t mode_blob, std::uint32_t frame_buffer) {
    const std::uint64_t width = output.mode.hdisplay;
    const std::uint64_t height = output.mode.vdisplay;
    const auto of_plane = [&](std::string_view name, std::uint64_t value) {
        return PropertyValue{output.plane, property(properties.plane, name), value};
    };
    return {
        {output.connector, property(properties.connector, "CRTC_ID"), output.crtc},
        {output.crtc, property(properties.crtc, "MODE_ID"), mode_blob},
        {output.crtc, property(properties.crtc, "ACTIVE"), 1},
        of_plane("CRTC_ID", output.crtc),
        of_plane("FB_ID", frame_buffer),
        of_plane("SRC_X", 0),
        of_plane("SRC_Y", 0),
        of_plane("SRC_W", width << 16),  // 16.16 fixed point
        of_plane("SRC_H", height << 16),
        of_plane("CRTC_X", 0),
        of_plane("CRTC_Y", 0),
        of_plane("CRTC_W", width),
        of_plane("CRTC_H", height),
    };
}

AtomicRequest flip_request(const Output& output, const OutputProperties& properties,
                           std::uint32_t frame_buffer) {
    return {{output.plane, property(properties.plane, "FB_ID"), frame_buffer}};
}

}  // namespace vitrine
