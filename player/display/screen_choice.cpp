#include "player/display/screen_choice.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace vitrine::player {

namespace {

constexpr int smallest_side = 16;    // px
constexpr int largest_side = 16384;  // px, what graphics cards take

[[noreturn]] void refuse(std::string_view text) {
    throw std::invalid_argument(fmt::format("screen '{}': expected kms, kms:/dev/dri/card0 or "
                                            "offscreen:WIDTHxHEIGHT+... with sides of {} to {} px",
                                            text, smallest_side, largest_side));
}

int side(std::string_view digits, std::string_view whole) {
    int value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc{} || stop != end || value < smallest_side || value > largest_side) refuse(whole);
    return value;
}

OffscreenChoice::Size size(std::string_view text, std::string_view whole) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) refuse(whole);
    return {.width = side(text.substr(0, cross), whole), .height = side(text.substr(cross + 1), whole)};
}

}  // namespace

ScreenChoice parse_screen(std::string_view text) {
    const std::size_t colon = text.find(':');
    const std::string_view kind = text.substr(0, colon);
    const std::string_view rest = colon == std::string_view::npos ? "" : text.substr(colon + 1);
    if (kind == "kms") {
        if (colon != std::string_view::npos && !rest.starts_with('/')) refuse(text);
        return KmsChoice{.card = rest};
    }
    if (kind != "offscreen") refuse(text);
    OffscreenChoice choice;
    for (std::string_view sizes = rest;;) {
        const std::size_t plus = sizes.find('+');
        choice.screens.push_back(size(sizes.substr(0, plus), text));
        if (plus == std::string_view::npos) return choice;
        sizes.remove_prefix(plus + 1);
    }
}

}  // namespace vitrine::player
