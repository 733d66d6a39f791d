#pragma once

#include "base/geometry/vec2.hpp"
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

/// The parts of a graphics card as reported at one moment. Plain data, so that the choice of outputs can be
/// tested without a card.
struct CardState {
    struct Connector {
        std::uint32_t id = 0;
        std::string name;  // "HDMI-A-1"
        bool is_connected = false;
        std::uint32_t crtcs = 0;    // bit i: it can be fed by crtcs[i]
        std::uint32_t crtc_id = 0;  // the CRTC that feeds it now; 0: none
        std::vector<drmModeModeInfo> modes;
        std::uint64_t panel = 0;   // a number made from the EDID, to tell panels apart; 0: no EDID
        Vec2 millimetres;          // the panel's sides by its EDID; 0: unknown
        bool is_link_bad = false;  // its mode must be set again
    };

    struct Plane {
        std::uint32_t id = 0;
        std::uint32_t crtcs = 0;  // bit i: it can be used by crtcs[i]
        bool is_primary = false;
        std::uint32_t crtc_id = 0;  // the CRTC that uses it now; 0: none
    };

    std::vector<Connector> connectors;
    std::vector<std::uint32_t> crtcs;  // ids
    std::vector<Plane> planes;         // none: legacy KMS calls are used
};

/// A connector that shall be lit, and the parts that feed it.
struct Output {
    std::uint32_t connector = 0;
    std::uint32_t crtc = 0;
    std::uint32_t plane = 0;  // 0: none needed
    drmModeModeInfo mode{};
    std::string name;         // the connector's
    std::uint64_t panel = 0;  // CardState::Connector::panel
    Vec2 millimetres = {};    // CardState::Connector::millimetres

    /// True if both show the same picture in the same way. Ignores names and flags of modes, which a card
    /// changes from one answer to the next.
    bool is_same(const Output& other) const;
};

/// Hz, computed from the pixel clock if it is known.
double refresh_rate(const drmModeModeInfo& mode);

/// The modes in the order of trying, until the card accepts one: the wished mode, the panel's preferred mode,
/// then the others of the panel's list from the largest down, none larger than the preferred one.
std::vector<drmModeModeInfo> modes_to_try(const std::vector<drmModeModeInfo>& modes, const ModeWish& wish);

/// The number of modes that the card has already refused, by connector id.
using Refusals = std::map<std::uint32_t, std::size_t>;

/// The outputs for all panels that can be lit at the same time, in the order of the card's connectors. Each
/// has the first of its modes_to_try() that was not refused. A panel with an empty list of modes is skipped
/// for now. A CRTC that already feeds a panel stays with it, unless another panel would then stay dark.
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

/// @param all  all outputs that shall be lit, including `output`
Obstacles obstacles(const CardState& card, const Output& output, std::span<const Output> all);

/// The numbers of the flips in a card's events, given as raw bytes.
std::vector<std::uint64_t> flips_in(std::span<const std::byte> events);

}  // namespace vitrine::player
