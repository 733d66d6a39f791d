#pragma once

#include <filesystem>
#include <string_view>
#include <variant>

namespace vitrine {

/// Memory instead of a panel.
struct OffscreenChoice {
    int width = 0;  // px
    int height = 0;

    friend bool operator==(const OffscreenChoice&, const OffscreenChoice&) = default;
};

/// A panel at a graphics card.
struct KmsChoice {
    std::filesystem::path card;  // empty: the first card with a connector

    friend bool operator==(const KmsChoice&, const KmsChoice&) = default;
};

using ScreenChoice = std::variant<OffscreenChoice, KmsChoice>;

/// What "kms", "kms:/dev/dri/card1" or "offscreen:1280x720" asks for.
/// @throws std::invalid_argument saying what is allowed
ScreenChoice parse_screen(std::string_view text);

}  // namespace vitrine
