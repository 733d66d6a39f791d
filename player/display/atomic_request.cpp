#include "player/display/atomic_request.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace vitrine::player {

namespace {

std::uint32_t property(const PropertyIds& ids, std::string_view name) {
    const auto found = ids.find(name);
    if (found == ids.end()) throw std::runtime_error(fmt::format("the card has no property '{}'", name));
    return found->second;
}

PropertyValue change(const PropertyIds& ids, std::uint32_t object, std::string_view name,
                     std::uint64_t value) {
    return {object, property(ids, name), value};
}

AtomicRequest removal_of(const Obstacles& obstacles, const OutputProperties& properties) {
    AtomicRequest request;
    for (const std::uint32_t id : obstacles.connectors)
        request.push_back(change(properties.connector, id, "CRTC_ID", 0));
    for (const std::uint32_t id : obstacles.crtcs) {
        request.push_back(change(properties.crtc, id, "MODE_ID", 0));
        request.push_back(change(properties.crtc, id, "ACTIVE", 0));
    }
    for (const std::uint32_t id : obstacles.planes) {
        request.push_back(change(properties.plane, id, "CRTC_ID", 0));
        request.push_back(change(properties.plane, id, "FB_ID", 0));
    }
    return request;
}

}  // namespace

AtomicRequest modeset_request(const Output& output, const OutputProperties& properties,
                              std::uint32_t mode_blob, std::uint32_t frame_buffer,
                              const Obstacles& in_the_way) {
    const std::uint64_t width = output.mode.hdisplay;
    const std::uint64_t height = output.mode.vdisplay;
    const auto of_plane = [&](std::string_view name, std::uint64_t value) {
        return change(properties.plane, output.plane, name, value);
    };
    AtomicRequest request{
        change(properties.connector, output.connector, "CRTC_ID", output.crtc),
        change(properties.crtc, output.crtc, "MODE_ID", mode_blob),
        change(properties.crtc, output.crtc, "ACTIVE", 1),
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
    const AtomicRequest removal = removal_of(in_the_way, properties);
    request.insert(request.end(), removal.begin(), removal.end());
    if (const auto status = properties.connector.find("link-status"); status != properties.connector.end())
        request.push_back({output.connector, status->second, DRM_MODE_LINK_STATUS_GOOD});
    return request;
}

AtomicRequest flip_request(const Output& output, const OutputProperties& properties,
                           std::uint32_t frame_buffer) {
    return {{output.plane, property(properties.plane, "FB_ID"), frame_buffer}};
}

AtomicRequest off_request(const Output& output, const OutputProperties& properties) {
    return {change(properties.crtc, output.crtc, "ACTIVE", 0)};
}

}  // namespace vitrine::player
