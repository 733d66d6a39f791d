#include "player/display/kms_state.hpp"

#include <xf86drm.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double same_rate = 0.6;  // Hz: a wish for 60 accepts 59.94

using Connector = CardState::Connector;

bool has_bit(std::uint32_t bits, std::size_t i) {
    return i < 32 && (bits >> i & 1U) != 0;
}

auto timing(const drmModeModeInfo& m) {
    return std::tuple(m.clock, m.hdisplay, m.hsync_start, m.hsync_end, m.htotal, m.hskew, m.vdisplay,
                      m.vsync_start, m.vsync_end, m.vtotal, m.vscan, m.flags);
}

bool is_interlaced(const drmModeModeInfo& mode) {
    return (mode.flags & DRM_MODE_FLAG_INTERLACE) != 0;
}

int area(const drmModeModeInfo& mode) {
    return mode.hdisplay * mode.vdisplay;
}

const drmModeModeInfo& preferred(const std::vector<drmModeModeInfo>& modes) {
    const auto found = std::ranges::find_if(
        modes, [](const drmModeModeInfo& mode) { return (mode.type & DRM_MODE_TYPE_PREFERRED) != 0; });
    return found == modes.end() ? modes.front() : *found;
}

const drmModeModeInfo* wished(const std::vector<drmModeModeInfo>& modes, const ModeWish& wish) {
    const drmModeModeInfo* best = nullptr;
    for (const drmModeModeInfo& mode : modes) {
        if (mode.hdisplay != wish.width || mode.vdisplay != wish.height || is_interlaced(mode)) continue;
        const double rate = refresh_rate(mode);
        if (wish.refresh_rate > 0 && std::abs(rate - wish.refresh_rate) > same_rate) continue;
        if (!best || rate > refresh_rate(*best)) best = &mode;
    }
    return best;
}

// A primary plane for a CRTC; prefers one that is on it already; 0: none.
std::uint32_t free_plane(const CardState& card, std::size_t crtc, std::span<const Output> taken) {
    std::uint32_t found = 0;
    for (const CardState::Plane& plane : card.planes) {
        if (!plane.is_primary || !has_bit(plane.crtcs, crtc)) continue;
        if (std::ranges::find(taken, plane.id, &Output::plane) != taken.end()) continue;
        if (found == 0 || plane.crtc_id == card.crtcs[crtc]) found = plane.id;
    }
    return found;
}

// Assigns CRTCs to connectors, so that as many connectors as possible have a CRTC of their own.
class Feeding {
  public:
    Feeding(const CardState& card, bool needs_plane)
        : card_(card), needs_plane_(needs_plane), fed_(card.crtcs.size()) {}

    // Gives the connector a CRTC, if need be that of another connector, which then gets a different one.
    // True: it has one.
    bool feed(const Connector& connector) {
        std::vector<bool> tried(card_.crtcs.size(), false);
        return feed(connector, tried);
    }

    std::optional<std::size_t> crtc_of(const Connector& connector) const {
        const auto found = std::ranges::find(fed_, &connector);
        if (found == fed_.end()) return std::nullopt;
        return static_cast<std::size_t>(found - fed_.begin());
    }

  private:
    bool feed(const Connector& connector, std::vector<bool>& tried) {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < card_.crtcs.size(); ++i)
            if (has_bit(connector.crtcs, i) && (!needs_plane_ || free_plane(card_, i, {}) != 0))
                order.push_back(i);
        // First the connector's present CRTC, then free ones, then others' CRTCs.
        const auto rank = [&](std::size_t i) {
            if (card_.crtcs[i] == connector.crtc_id) return 0;
            return fed_[i] == nullptr ? 1 : 2;
        };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
        for (const std::size_t i : order) {
            if (tried[i]) continue;
            tried[i] = true;
            if (fed_[i] != nullptr && !feed(*fed_[i], tried)) continue;
            fed_[i] = &connector;
            return true;
        }
        return false;
    }

    const CardState& card_;  // outlives this
    bool needs_plane_;
    std::vector<const Connector*> fed_;  // index: as in crtcs
};

}  // namespace

bool Output::is_same(const Output& other) const {
    return connector == other.connector && crtc == other.crtc && plane == other.plane &&
           panel == other.panel && timing(mode) == timing(other.mode);
}

double refresh_rate(const drmModeModeInfo& mode) {
    if (mode.clock == 0 || mode.htotal == 0 || mode.vtotal == 0) return mode.vrefresh;
    return mode.clock * 1000.0 / (static_cast<double>(mode.htotal) * mode.vtotal);
}

std::vector<drmModeModeInfo> modes_to_try(const std::vector<drmModeModeInfo>& modes, const ModeWish& wish) {
    if (modes.empty()) return {};
    std::vector<drmModeModeInfo> order;
    if (const drmModeModeInfo* mode = wished(modes, wish)) order.push_back(*mode);
    order.push_back(preferred(modes));
    std::vector<drmModeModeInfo> others;
    for (const drmModeModeInfo& mode : modes)
        if (!is_interlaced(mode) && area(mode) <= area(preferred(modes))) others.push_back(mode);
    std::ranges::stable_sort(others, std::ranges::greater{}, area);
    order.insert(order.end(), others.begin(), others.end());
    std::vector<drmModeModeInfo> once;
    for (const drmModeModeInfo& mode : order)
        if (std::ranges::find(once, timing(mode), timing) == once.end()) once.push_back(mode);
    return once;
}

std::vector<Output> choose_outputs(const CardState& card, const ModeWishes& controls, bool needs_plane,
                                   const Refusals& refusals) {
    std::vector<std::pair<const Connector*, drmModeModeInfo>> wanted;
    for (const Connector& connector : card.connectors) {
        if (!connector.is_connected) continue;
        const std::vector<drmModeModeInfo> modes = modes_to_try(connector.modes, controls.of(connector.name));
        const auto refused = refusals.find(connector.id);
        const std::size_t next = refused == refusals.end() ? 0 : refused->second;
        if (next < modes.size()) wanted.emplace_back(&connector, modes[next]);
    }

    Feeding feeding(card, needs_plane);
    for (const bool is_lit : {true, false})  // lit panels choose first
        for (const auto& [connector, mode] : wanted)
            if ((connector->crtc_id != 0) == is_lit) feeding.feed(*connector);

    std::vector<Output> outputs;
    for (const auto& [connector, mode] : wanted) {
        const std::optional<std::size_t> crtc = feeding.crtc_of(*connector);
        if (!crtc) continue;
        const std::uint32_t plane = needs_plane ? free_plane(card, *crtc, outputs) : 0;
        if (needs_plane && plane == 0) continue;
        outputs.push_back({.connector = connector->id,
                           .crtc = card.crtcs[*crtc],
                           .plane = plane,
                           .mode = mode,
                           .name = connector->name,
                           .panel = connector->panel,
                           .millimetres = connector->millimetres});
    }
    return outputs;
}

Obstacles obstacles(const CardState& card, const Output& output, std::span<const Output> all) {
    Obstacles found;
    std::uint32_t left = 0;
    for (const Connector& connector : card.connectors) {
        const bool is_ours = connector.id == output.connector;
        if (!is_ours && connector.crtc_id == output.crtc) found.connectors.push_back(connector.id);
        if (is_ours && connector.crtc_id != output.crtc) left = connector.crtc_id;
    }
    const auto feeds_another = [&](const Connector& connector) {
        return connector.id != output.connector && connector.crtc_id == left;
    };
    const bool is_needed = std::ranges::find(all, left, &Output::crtc) != all.end() ||
                           std::ranges::any_of(card.connectors, feeds_another);
    if (is_needed) left = 0;
    if (left != 0) found.crtcs.push_back(left);
    for (const CardState::Plane& plane : card.planes) {
        const bool is_in_the_way = plane.crtc_id == output.crtc || (left != 0 && plane.crtc_id == left);
        if (plane.id != output.plane && plane.crtc_id != 0 && is_in_the_way) found.planes.push_back(plane.id);
    }
    return found;
}

std::vector<std::uint64_t> flips_in(std::span<const std::byte> events) {
    std::vector<std::uint64_t> flips;
    drm_event head{};
    while (events.size() >= sizeof head) {
        std::memcpy(&head, events.data(), sizeof head);
        if (head.length < sizeof head || head.length > events.size()) break;
        drm_event_vblank event{};
        if (head.type == DRM_EVENT_FLIP_COMPLETE && head.length >= sizeof event) {
            std::memcpy(&event, events.data(), sizeof event);
            flips.push_back(event.user_data);
        }
        events = events.subspan(head.length);
    }
    return flips;
}

}  // namespace vitrine::player
