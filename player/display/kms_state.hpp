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

/// What a graphics card says of its parts at one moment: plain data, so that what is made of it can be
/// tested without a card.
struct CardState {
    struct Connector {
        std::uint32_t id = 0;
        std::string name;  // "HDMI-A-1"
        bool is_connected = false;
        std::uint32_t crtcs = 0;    // bit i: it can be fed by crtcs[i]
        std::uint32_t crtc_id = 0;  // feeds it now; 0: none
        std::vector<drmModeModeInfo> modes;
        std::uint64_t panel = 0;   // tells panels from each other (of the EDID); 0: it says nothing of itself
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
    std::vector<Plane> planes;         // none where the card is driven the old way
};

/// The way from a picture to a panel.
struct Output {
    std::uint32_t connector = 0;
    std::uint32_t crtc = 0;
    std::uint32_t plane = 0;  // 0: none needed
    drmModeModeInfo mode{};
    std::string name;         // of the connector
    std::uint64_t panel = 0;  // CardState::Connector::panel

    /// Whether what the one shows the other shows as well. Names and marks of modes, which a card changes
    /// from one answer to the next, do not count.
    bool is_same(const Output& other) const;
};

/// Hz, exactly: from the pixel clock where there is one.
double refresh_rate(const drmModeModeInfo& mode);

/// The modes to be tried one after the other until the card takes one: the wished for, the one that the panel
/// prefers, then the others of its list from the largest down, none of them larger than the preferred.
std::vector<drmModeModeInfo> modes_to_try(const std::vector<drmModeModeInfo>& modes, const ModeWish& wish);

/// How many modes of each connector, by id, the card has refused already.
using Refusals = std::map<std::uint32_t, std::size_t>;

/// Every panel that can be lit at the same time, in the order of the card's connectors, each with the first
/// mode, of those that its own wish leads to, that was not refused; a panel with an empty list of modes is
/// none yet. What feeds a panel already is kept where that does not keep another panel dark.
/// @param needs_plane  the card takes atomic requests, which name planes
std::vector<Output> choose_outputs(const CardState& card, const ModeWishes& controls, bool needs_plane,
                                   const Refusals& refusals = {});

/// What lies on the way of an output and has to go in the same request, or it is refused: connectors that its
/// CRTC feeds by now, a CRTC that its connector leaves and that nothing else needs, planes of others on both.
struct Obstacles {
    std::vector<std::uint32_t> connectors;
    std::vector<std::uint32_t> crtcs;
    std::vector<std::uint32_t> planes;
};

/// @param all  every output that is to be lit, with `output`
Obstacles obstacles(const CardState& card, const Output& output, std::span<const Output> all);

/// The numbers of the flips that a card's events, as it hands them out, tell of.
std::vector<std::uint64_t> flips_in(std::span<const std::byte> events);

}  // namespace vitrine::player
