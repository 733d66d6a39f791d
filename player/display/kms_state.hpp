#pragma once

#include <xf86drmMode.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

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
    };

    struct Plane {
        std::uint32_t id = 0;
        std::uint32_t crtcs = 0;  // bit i: it can lie on crtcs[i]
        bool is_primary = false;
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
    std::string name;  // of the connector

    /// Whether what the one shows the other shows as well. Names and marks of modes, which a card changes
    /// from one answer to the next, do not count.
    bool is_same(const Output& other) const;
};

/// What the operator wants of a panel; whatever is left out, or not there, is chosen.
struct OutputWish {
    std::string connector;  // empty: the first that has a panel
    int width = 0;          // px; 0: as the panel prefers
    int height = 0;
    double refresh_rate = 0;  // Hz; 0: the fastest of that size
};

/// "", "preferred", "1920x1080" or "1920x1080@50".
/// @throws std::invalid_argument saying what is allowed
OutputWish parse_mode(const std::string& text);

/// Hz, exactly: from the pixel clock where there is one.
double refresh_rate(const drmModeModeInfo& mode);

/// A panel that is connected, and how to reach it; nothing where there is none. The wish is followed where
/// the panel can, else the panel's own preference is. What feeds it already is kept: a change of CRTC would
/// need the other one turned off in the same commit.
/// @param needs_plane  the card takes atomic requests, which name planes
std::optional<Output> choose_output(const CardState& card, const OutputWish& wish, bool needs_plane);

}  // namespace vitrine
