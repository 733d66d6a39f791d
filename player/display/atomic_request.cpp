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

}  // namespace

AtomicRequest modeset_request(const Output& output, const OutputProperties& properties,
                              std::uint32_t mode_blob, std::uint32_t frame_buffer,
                              const Obstacles& in_the_way) {
    const std::uint64_t width = output.mode.hdisplay;
    const std::uint64_t height = output.mode.vdisplay;
    const auto of_connector = [&](std::uint32_t id, std::uint64_t crtc) {
        return PropertyValue{id, property(properties.connector, "CRTC_ID"), crtc};
    };
    const auto of_crtc = [&](std::uint32_t id, std::string_view name, std::uint64_t value) {
        return PropertyValue{id, property(properties.crtc, name), value};
    };
    const auto of_plane = [&](std::uint32_t id, std::string_view name, std::uint64_t value) {
        return PropertyValue{id, property(properties.plane, name), value};
    };
    AtomicRequest request{
        of_connector(output.connector, output.crtc),
        of_crtc(output.crtc, "MODE_ID", mode_blob),
        of_crtc(output.crtc, "ACTIVE", 1),
        of_plane(output.plane, "CRTC_ID", output.crtc),
        of_plane(output.plane, "FB_ID", frame_buffer),
        of_plane(output.plane, "SRC_X", 0),
        of_plane(output.plane, "SRC_Y", 0),
        of_plane(output.plane, "SRC_W", width << 16),  // 16.16 fixed point
        of_plane(output.plane, "SRC_H", height << 16),
        of_plane(output.plane, "CRTC_X", 0),
        of_plane(output.plane, "CRTC_Y", 0),
        of_plane(output.plane, "CRTC_W", width),
        of_plane(output.plane, "CRTC_H", height),
    };
    for (const std::uint32_t id : in_the_way.connectors)
        request.push_back(of_connector(id, 0));
    for (const std::uint32_t id : in_the_way.crtcs) {
        request.push_back(of_crtc(id, "MODE_ID", 0));
        request.push_back(of_crtc(id, "ACTIVE", 0));
    }
    for (const std::uint32_t id : in_the_way.planes) {
        request.push_back(of_plane(id, "CRTC_ID", 0));
        request.push_back(of_plane(id, "FB_ID", 0));
    }
    if (const auto status = properties.connector.find("link-status"); status != properties.connector.end())
        request.push_back({output.connector, status->second, DRM_MODE_LINK_STATUS_GOOD});
    return request;
}

AtomicRequest flip_request(const Output& output, const OutputProperties& properties,
                           std::uint32_t frame_buffer) {
    return {{output.plane, property(properties.plane, "FB_ID"), frame_buffer}};
}

}  // namespace vitrine::player
