#pragma once

#include <opencv2/core/types.hpp>

#include <cstdint>
#include <span>

namespace vitrine::analyzer {

/// The black rows above and below a picture and the black columns beside it, in places of two by two cells.
/// Bars of a film, mostly; a dark sky as well, which does no harm: only what is black in both of two pictures
/// is left out where they are compared.
struct BlackMargins {
    std::uint8_t left = 0;
    std::uint8_t top = 0;
    std::uint8_t right = 0;
    std::uint8_t bottom = 0;
};

/// Margins at opposite sides only. A picture that is black all over has margins that meet in its middle.
/// @param grey  the cells of a picture, row by row
/// @param size  cells, even numbers
BlackMargins black_margins(std::span<const std::uint8_t> grey, cv::Size size);

/// The places within the margins that both pictures have; all places where that would leave none.
/// @param size  places
cv::Rect common_part(const BlackMargins& a, const BlackMargins& b, cv::Size size);

}  // namespace vitrine::analyzer
