#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace vitrine {

/// A colour in 8-bit sRGB.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    bool operator==(const Colour&) const = default;
};

/// Parses "#rrggbb" with digits of either case. @return  none: another text
inline std::optional<Colour> colour_named(std::string_view text) {
    constexpr int hexadecimal = 16;
    if (text.size() != 7 || text.front() != '#') return std::nullopt;
    std::uint32_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [after, error] = std::from_chars(text.data() + 1, end, value, hexadecimal);
    if (error != std::errc() || after != end) return std::nullopt;
    return Colour{.red = static_cast<std::uint8_t>(value >> 16),
                  .green = static_cast<std::uint8_t>(value >> 8 & 0xffU),
                  .blue = static_cast<std::uint8_t>(value & 0xffU)};
}

}  // namespace vitrine
