#pragma once

#include "player/display/picture.hpp"

#include <GLES3/gl3.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A picture in memory that GL draws to, 8 bits a channel, blue first: the order of scan-out. In this order
/// Mesa's software renderer draws pictures pixel for pixel at half the cost of any other order. Create, use
/// and destroy it with the same context current.
class MemoryTarget {
  public:
    /// The pixels are not defined yet.
    /// @throws std::runtime_error if GL has no room
    MemoryTarget(int width, int height);

    int width() const { return width_; }

    int height() const { return height_; }

    /// Draws to it from now on.
    void make_current() const;

    /// Calls `take` with each row of the picture, from the top, each 4 * width() bytes and lent for the call.
    /// @throws std::runtime_error if GL cannot read it
    void read(const std::function<void(std::span<const std::byte> row)>& take);

    /// A copy of the picture. @throws std::runtime_error if GL cannot read it
    CardPicture picture();

  private:
    /// GL's names of the frame buffer and its colours.
    struct Names {
        Names();
        Names(const Names&) = delete;
        Names& operator=(const Names&) = delete;
        Names(Names&&) = delete;
        Names& operator=(Names&&) = delete;
        ~Names();

        GLuint frame_buffer = 0;
        GLuint colours = 0;  // a texture
    };

    /// Copies the rows in the order of GL: the bottom row first.
    void copy(std::span<std::byte> rows) const;

    int width_;  // px
    int height_;
    Names names_;
    std::vector<std::byte> rows_;  // the last that were read
    CardPictureMemory pictures_;
};

}  // namespace vitrine::player
