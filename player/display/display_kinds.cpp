#include "player/display/display_kinds.hpp"

#include "player/display/kms_display.hpp"
#include "player/display/offscreen_display.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace vitrine::player {

namespace {

struct DisplayKind {
    std::string_view name;   // before the colon
    std::string_view usage;  // the allowed words, for the error text
    std::unique_ptr<DisplayOpener> (*make)(std::optional<std::string_view> argument,
                                           const DisplayRequest& request);  // nullptr: not understood
};

// base/settings/setting_keys.cpp checks the same words when the settings are read.
constexpr std::array<DisplayKind, 2> kinds{{
    {"kms", "kms, kms:/dev/dri/card0", &make_kms_opener},
    {"offscreen", "offscreen:WIDTHxHEIGHT+... with sides of 16 to 16384 px", &make_offscreen_opener},
}};

}  // namespace

std::unique_ptr<DisplayOpener> make_display_opener(const DisplayRequest& request) {
    const std::string_view text = request.output.screen;
    const std::size_t colon = text.find(':');
    const auto argument =
        colon == std::string_view::npos ? std::nullopt : std::optional(text.substr(colon + 1));
    std::string usages;
    for (const DisplayKind& kind : kinds) {
        usages += fmt::format("{}{}", usages.empty() ? "" : ", ", kind.usage);
        if (text.substr(0, colon) != kind.name) continue;
        if (std::unique_ptr<DisplayOpener> opener = kind.make(argument, request)) return opener;
    }
    throw std::invalid_argument(fmt::format("screen '{}': expected one of: {}", text, usages));
}

}  // namespace vitrine::player
