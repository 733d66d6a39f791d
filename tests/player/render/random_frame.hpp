#pragma once

#include "player/render/view.hpp"
#include "player/scene/frame.hpp"
#include "tests/player/render/drawn_wall.hpp"

#include <cstdint>
#include <map>
#include <random>

namespace vitrine::player {

using Dice = std::mt19937_64;

/// A picture for the renderer.
struct RandomPicture {
    Still still;
    bool is_film = false;  // true: it follows another one of its source
};

/// A frame as walls, changes of walls and tapestries draw them, and its pictures.
struct RandomFrame {
    int width = 0;  // px of the screen
    int height = 0;
    View view;
    Frame frame;
    std::map<SourceId, RandomPicture> pictures;
    bool is_noise = false;    // the pictures have noise; else they are smooth
    bool has_planes = false;  // some pictures are planes of brightness and differences; else all are colours
};

/// The same seed gives the same frame. @param max_side  of the screen, px
RandomFrame random_frame(std::uint64_t seed, int max_side);

/// A picture for a frame, in any layout of pixels and any code of colours that it allows.
RandomPicture random_picture(Dice& dice, int width, int height, const RandomFrame& frame);

}  // namespace vitrine::player
