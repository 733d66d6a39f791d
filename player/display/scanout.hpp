#pragma once

#include "player/display/picture.hpp"

#include <cstdint>
#include <memory>

namespace vitrine::player {

/// A finished picture in the card's memory, lent by a Scanout, which outlives it. Destroy it to give it back.
struct ScanoutBuffer {
    std::uint32_t frame_buffer = 0;  // the card's number for it
    std::shared_ptr<const void>
        lease;  // gives the buffer back when destroyed; shared only to hide its type, has one owner
};

/// The buffers that GL draws to and a card shows, all of one size. Outlives every buffer that it lends.
class Scanout {
  public:
    Scanout() = default;
    Scanout(const Scanout&) = delete;
    Scanout& operator=(const Scanout&) = delete;
    Scanout(Scanout&&) = delete;
    Scanout& operator=(Scanout&&) = delete;
    virtual ~Scanout() = default;

    /// Draws to the next buffer from now on.
    virtual void make_current() = 0;

    /// True if there is a next buffer to draw to.
    virtual bool has_free_buffer() const = 0;

    /// Ends the drawing and lends the buffer that was drawn to, ready to be shown.
    /// @throws std::runtime_error if the card has no room or no such format, or is gone
    virtual ScanoutBuffer lock_front_buffer() = 0;

    /// The picture in a lent buffer.
    /// @throws std::runtime_error if it cannot be read
    virtual CardPicture picture(const ScanoutBuffer& buffer) = 0;
};

}  // namespace vitrine::player
