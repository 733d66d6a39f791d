#pragma once

#include <filesystem>
#include <string_view>
#include <variant>
#include <vector>

namespace vitrine::player {

/// Memory instead of panels.
struct OffscreenChoice {
    struct Size {
        int width = 0;  // px
        int height = 0;

        friend bool operator==(const Size&, const Size&) = default;
    };

    std::vector<Size> screens;  // one at least

    friend bool operator==(const OffscreenChoice&, const OffscreenChoice&) = default;
};

/// The panels of a graphics card.
struct KmsChoice {
    std::filesystem::path card;  // empty: the first card with a panel

    friend bool operator==(const KmsChoice&, const KmsChoice&) = default;
};

using ScreenChoice = std::variant<OffscreenChoice, KmsChoice>;

/// What "kms", "kms:/dev/dri/card1" or "offscreen:1280x720+640x360" asks for.
/// @throws std::invalid_argument saying what is allowed
ScreenChoice parse_screen(std::string_view text);

}  // namespace vitrine::player
