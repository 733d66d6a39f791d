#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace vitrine {

/// A signature of a shot's picture in few bytes. It tells how alike two shots look without their files.
struct ShotLook {
    static constexpr int grid = 3;  // fields across and down
    static constexpr int hash_side = 8;

    std::uint64_t hash = 0;  // a bit for each of 8 x 8 places: brighter than the place to its right
    std::array<std::uint8_t, std::size_t{3} * grid * grid> colours{};  // mean of each field: red, green, blue

    bool operator==(const ShotLook&) const = default;
};

/// Returns the difference of two looks in [0, 1]. It is the mean of the distance of their colours and that of
/// their hashes. Two photos of different things have about 0.4, two of a series about 0.1.
double distance_between(const ShotLook& a, const ShotLook& b);

/// The look in hex digits: the hash, then the colours.
std::string text_of(const ShotLook& look);

/// @throws std::runtime_error if the text has another form
ShotLook look_from_text(std::string_view text);

}  // namespace vitrine
