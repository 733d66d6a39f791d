#pragma once

#include "base/settings/output_words.hpp"

#include <xf86drmMode.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// The parts of a graphics card as it reports them at one moment. Plain data, so that the choice of outputs
/// can be tested without a card.
struct CardState {
    struct Connector {
        std::uint32_t id = 0;
        std::string name;  // "HDMI-A-1"
        bool is_connected = false;
        std::uint32_t crtcs = 0;    // bit i: it can be fed by crtcs[i]
        std::uint32_t crtc_id = 0;  // feeds it now; 0: none
        std::vector<drmModeModeInfo> modes;
        std::uint64_t panel = 0;   // a number made from the EDID, to tell panels apart; 0: no EDID
        bool is_link_bad = false;  // its mode has to be set again
    };

    struct Plane {
        std::uint32_t id = 0;
        std::uint32_t crtcs = 0;  // bit i: it can lie on crtcs[i]
        bool is_primary = false;
        std::uint32_t crtc_id = 0;  // lies on it now; 0: on none
    };

    std::vector<Connector> connectors;
    std::vector<std::uint32_t> crtcs;  // ids
    std::vector<Plane> planes;         // none where the card is driven by legacy KMS calls
};

/// A connector that is to be lit, and what feeds it.
struct Output {
    std::uint32_t connector = 0;
    std::uint32_t crtc = 0;
    std::uint32_t plane = 0;  // 0: none needed
    drmModeModeInfo mode{};
    std::string name;         // the connector's
    std::uint64_t panel = 0;  // CardState::Connector::panel

    /// True if the two show the same in the same way. Names and flags of modes, which a card changes from one
    /// answer to the next, do not count.
    bool is_same(const Output& other) const;
};

/// Hz, exactly: from the pixel clock where there is one.
double refresh_rate(const drmModeModeInfo& mode);

/// The modes to try one after the other until the card takes one: the wished one, the panel's preferred one,
/// then the others of the panel's list from the largest down, none of them larger than the preferred.
std::vector<drmModeModeInfo> modes_to_try(const std::vector<drmModeModeInfo>& modes, const ModeWish& wish);

/// The number of modes that the card has refused already, by connector id.
using Refusals = std::map<std::uint32_t, std::size_t>;

/// The outputs for every panel that can be lit at the same time, in the order of the card's connectors. Each
/// has the first of its modes_to_try() that was not refused; a panel with an empty list of modes does not
/// count yet. A CRTC that feeds a panel already is kept there unless that keeps another panel dark.
/// @param needs_plane  the card takes atomic requests, which name planes
std::vector<Output> choose_outputs(const CardState& card, const ModeWishes& controls, bool needs_plane,
                                   const Refusals& refusals = {});

/// The obstacles to an output. They must be removed in the same request, or the card refuses it: connectors
/// that its CRTC feeds by now, the CRTC that its connector leaves if no other connector needs it, and other
/// outputs' planes on both CRTCs.
struct Obstacles {
    std::vector<std::uint32_t> connectors;
    std::vector<std::uint32_t> crtcs;
    std::vector<std::uint32_t> planes;
};

/// @param all  every output that is to be lit, with `output`
Obstacles obstacles(const CardState& card, const Output& output, std::span<const Output> all);

/// The numbers of the flips in a card's events, given as the bytes that it hands out.
std::vector<std::uint64_t> flips_in(std::span<const std::byte> events);

}  // namespace vitrine::player
