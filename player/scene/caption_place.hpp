#pragma once

#include "player/layout/canvas.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// The rooms for the captions of shots that stand. @param bezels  canvas px
std::vector<CaptionRoom> caption_rooms(std::span<const PlacedShot> wall, std::span<const Box> bezels = {});

/// The rooms for the captions of shots that stay where they are while a wall changes into the next.
std::vector<CaptionRoom> kept_caption_rooms(std::span<const PlacedShot> shown,
                                            std::span<const PlacedShot> incoming,
                                            std::span<const Box> bezels = {});

/// True if a caption that stands may stay: its box lies in the shot's own pixels, now and after the change,
/// outside its I-Region, and under nothing that is drawn of another shot.
bool keeps_place(const Box& caption, const CaptionRoom& room, std::span<const DrawItem> items);

/// The size of a caption's picture.
struct CaptionSize {
    double aspect = 1;   // its width as a share of its height
    double letters = 1;  // the letters' size as a share of its height
};

/// Letters are at least so high as a share of the canvas' height.
inline constexpr double min_caption_letters = 1.0 / 40;

/// The place of a caption and which of its forms has it.
struct CaptionPlace {
    Box box;  // canvas px
    std::size_t form = 0;
};

/// The place of a caption: inside the shot's own pixels, outside its I-Region and so outside that of every
/// shot, as large as it can be, in the first form that has room, as low as that can be. None: there is no
/// room.
/// @param canvas  its size, px
/// @param taken   canvas px: another thing of this shot stands there
std::optional<CaptionPlace> caption_place(const CaptionRoom& room, std::span<const CaptionSize> forms,
                                          Vec2 canvas, const Box& taken = {});

/// A module of a QR code is at least so many canvas px wide, and a whole number of them.
inline constexpr double min_code_module = 3;

/// The sides of a QR code with its quiet zone, as shares of the canvas' height.
inline constexpr double min_code_side = 0.1;
inline constexpr double max_code_side = 0.2;

/// The place of a QR code, found like that of a caption, at whole px. None: there is no room.
/// @param modules  on each side, with the quiet zone
std::optional<Box> code_place(const CaptionRoom& room, int modules, Vec2 canvas, const Box& taken = {});

/// The place of the wall's QR code on the idle picture: at its lower right.
Box idle_code_place(int modules, Vec2 canvas);

/// The place of a line of words on the idle picture: at its lower left, a fourteenth of its height.
/// @param aspect  width / height
Box idle_words_place(double aspect, Vec2 canvas);

}  // namespace vitrine::player
