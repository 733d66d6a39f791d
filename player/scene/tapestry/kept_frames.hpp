#pragma once

#include "base/state/tapestry.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/tapestry/tapestry_view.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

// The pictures beside a tapestry's levels: sheets of frames that were kept of the film, and the digits. They
// are loaded like tiles, as two levels more.

TileId kept_sheet(const Tapestry& tapestry, int sheet);
TileId digits_picture(const Tapestry& tapestry);

/// True: this is a tile of a level, and no such picture.
bool is_of_level(const Tapestry& tapestry, const TileId& tile);

/// The file of a tile, of a sheet or of the digits, below the tapestry's folder.
std::string file_of(const Tapestry& tapestry, const TileId& tile);

/// Limit of these pictures in memory; a sheet has about a megabyte.
constexpr std::size_t max_kept_pictures = 24;

/// These pictures, the most urgent first: the digits, the sheets about the moment under a finger, those of
/// moments all over the view.
/// @param moment  under the finger; none: no finger looks for one
std::vector<TileId> wanted_pictures(const TapestryPlace& place, const TapestryView& view,
                                    const Tapestry& tapestry, std::optional<std::chrono::nanoseconds> moment);

/// A part of a picture, and where it is drawn.
struct PlacedCell {
    TileId picture;
    Vec2 offset;  // canvas px of the whole picture's corner
    Vec2 size;    // canvas px of the whole picture
};

/// The kept frame nearest to a moment, if it is drawn to fill a box. @pre frames are kept
PlacedCell placed_frame(const Tapestry& tapestry, std::chrono::nanoseconds moment, const Box& box);

/// A digit, if it is drawn to fill a box. @param glyph  '0' to '9', or ':'
PlacedCell placed_digit(const Tapestry& tapestry, char glyph, const Box& box);

/// A film's time as m:ss, from an hour on as h:mm:ss.
std::string time_in_words(std::chrono::nanoseconds time);

}  // namespace vitrine::player
