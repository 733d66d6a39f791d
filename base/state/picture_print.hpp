#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A photo in 16 x 16 shades, by which near-copies are found, and how sharp it is.
struct PicturePrint {
    static constexpr int side = 16;

    std::vector<std::uint8_t> shades;  // side * side, row by row; empty: an earlier analysis did not make it
    double sharpness = 0;              // of the analysed picture; compares pictures of one scene only

    bool operator==(const PicturePrint&) const = default;
};

/// The shades in hex digits.
std::string text_of(const PicturePrint& print);

/// @throws std::runtime_error if the text has another form
PicturePrint print_from_text(std::string_view text);

}  // namespace vitrine
