#pragma once

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
    /// @param format  GL_RGBA, or another order that the context can read
    /// @throws std::runtime_error if GL cannot read it
    void read(GLenum format, const std::function<void(std::span<const std::byte> row)>& take);

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

    int width_;  // px
    int height_;
    Names names_;
    std::vector<std::byte> rows_;  // in the order of GL: the bottom row first
};

}  // namespace vitrine::player
