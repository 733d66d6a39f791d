#include "player/display/kms_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <tuple>

namespace vitrine {

namespace {

constexpr double same_rate = 0.6;  // Hz: 59.94 is what is meant by 60

bool has_bit(std::uint32_t bits, std::size_t i) {
    return i < 32 && (bits >> i & 1U) != 0;
}

const drmModeModeInfo& preferred(const std::vector<drmModeModeInfo>& modes) {
    const auto found = std::ranges::find_if(
        modes, [](const drmModeModeInfo& mode) { return (mode.type & DRM_MODE_TYPE_PREFERRED) != 0; });
    return found == modes.end() ? modes.front() : *found;
}

drmModeModeInfo choose_mode(const std::vector<drmModeModeInfo>& modes, const OutputWish& wish) {
    const drmModeModeInfo* best = nullptr;
    for (const drmModeModeInfo& mode : modes) {
        if (mode.hdisplay != wish.width || mode.vdisplay != wish.height) continue;
        if ((mode.flags & DRM_MODE_FLAG_INTERLACE) != 0) continue;
        const double rate = refresh_rate(mode);
        if (wish.refresh_rate > 0 && std::abs(rate - wish.refresh_rate) > same_rate) continue;
        if (!best || rate > refresh_rate(*best)) best = &mode;
    }
    return best ? *best : preferred(modes);
}

std::optional<std::size_t> choose_crtc(const CardState& card, const CardState::Connector& connector) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < card.crtcs.size(); ++i) {
        if (!has_bit(connector.crtcs, i)) continue;
        if (card.crtcs[i] == connector.crtc_id) return i;
        if (!first) first = i;
    }
    return first;
}

std::uint32_t choose_plane(const CardState& card, std::size_t crtc) {
    const auto found = std::ranges::find_if(card.planes, [&](const CardState::Plane& plane) {
        return plane.is_primary && has_bit(plane.crtcs, crtc);
    });
    return found == card.planes.end() ? 0 : found->id;
}

}  // namespace

bool Output::is_same(const Output& other) const {
    const auto timing = [](const drmModeModeInfo& m) {
        return std::tuple(m.clock, m.hdisplay, m.hsync_start, m.hsync_end, m.htotal, m.hskew, m.vdisplay,
                          m.vsync_start, m.vsync_end, m.vtotal, m.vscan, m.flags);
    };
    return connector == other.connector && crtc == other.crtc && plane == other.plane &&
           timing(mode) == timing(other.mode);
}

OutputWish parse_mode(const std::string& text) {
    if (text.empty() || text == "preferred") return {};
    OutputWish wish;
    int used = 0;
    const int fields = std::sscanf(text.c_str(), "%5dx%5d%n@%7lf%n", &wish.width, &wish.height, &used,
                                   &wish.refresh_rate, &used);
    if (fields < 2 || static_cast<std::size_t>(used) != text.size() || wish.width <= 0 || wish.height <= 0 ||
        (fields == 3 && wish.refresh_rate <= 0))
        throw std::invalid_argument(
            fmt::format("mode '{}': expected preferred, 1920x1080 or 1920x1080@60", text));
    return wish;
}

double refresh_rate(const drmModeModeInfo& mode) {
    if (mode.clock == 0 || mode.htotal == 0 || mode.vtotal == 0) return mode.vrefresh;
    return mode.clock * 1000.0 / (static_cast<double>(mode.htotal) * mode.vtotal);
}

std::optional<Output> choose_output(const CardState& card, const OutputWish& wish, bool needs_plane) {
    for (const CardState::Connector& connector : card.connectors) {
        if (!connector.is_connected || connector.modes.empty()) continue;
        if (!wish.connector.empty() && connector.name != wish.connector) continue;
        const std::optional<std::size_t> crtc = choose_crtc(card, connector);
        if (!crtc) continue;
        const std::uint32_t plane = needs_plane ? choose_plane(card, *crtc) : 0;
        if (needs_plane && plane == 0) continue;
        return Output{.connector = connector.id,
                      .crtc = card.crtcs[*crtc],
                      .plane = plane,
                      .mode = choose_mode(connector.modes, wish),
                      .name = connector.name};
    }
    return std::nullopt;
}

}  // namespace vitrine
