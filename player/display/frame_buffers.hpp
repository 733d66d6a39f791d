#pragma once

#include "base/system/unique_fd.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vitrine::player {

/// A buffer in a card's memory, with the data that the card needs to show it.
struct BufferForm {
    std::uint32_t width = 0;  // px
    std::uint32_t height = 0;
    std::uint32_t format = 0;                // DRM_FORMAT_*
    std::array<std::uint32_t, 4> handles{};  // one for each plane; 0: no such plane
    std::array<std::uint32_t, 4> pitches{};  // bytes a row
    std::array<std::uint32_t, 4> offsets{};  // bytes
    std::array<std::uint64_t, 4> modifiers{};
    bool is_modifier_named = false;
};

/// The card's numbers for buffers that are to be shown (DRM frame buffers).
///
/// When a program ends, the kernel removes the frame buffers that it added, and turns off the outputs that
/// show them. So they are added through a second opening of the card, the keeper, which systemd holds over a
/// restart (FileDescriptorStoreMax=). Everything else that the program had of the card ends with the program.
/// The picture stays until the next program shows its first one. A card that cannot pass buffers from one
/// opening to another gets them through its own opening.
class FrameBuffers {
  public:
    /// @param card    outlives this
    /// @param keeper  another opening of the card, perhaps with the pictures of an earlier run; none: the
    ///                card's own
    FrameBuffers(int card, UniqueFd keeper);
    FrameBuffers(const FrameBuffers&) = delete;
    FrameBuffers& operator=(const FrameBuffers&) = delete;
    FrameBuffers(FrameBuffers&&) = delete;
    FrameBuffers& operator=(FrameBuffers&&) = delete;
    ~FrameBuffers() = default;

    /// Adds a buffer and returns its number, which keeps the buffer alive. 0: the card refuses it, see errno.
    std::uint32_t add(const BufferForm& form);

    void remove(std::uint32_t number);

    /// From now on removes no frame buffer: the program ends, and the picture stays.
    /// @return false: the frame buffers will end with the card's opening anyway
    bool keep();

    /// True while pictures of an earlier run are left.
    bool has_old() const { return !old_.empty(); }

    /// Removes the pictures of an earlier run that are not shown any more.
    /// @param shown  the numbers that are shown
    void let_go(std::span<const std::uint32_t> shown);

  private:
    std::uint32_t add_to_keeper(const BufferForm& form);

    int card_;
    UniqueFd keeper_;
    bool is_keeper_refused_ = false;
    bool keeps_ = false;
    std::vector<std::uint32_t> old_;  // pictures of an earlier run, in the keeper
    std::vector<std::uint32_t> own_;  // added through the card's own opening, because the keeper refused
};

/// The numbers without the others.
std::vector<std::uint32_t> without(std::span<const std::uint32_t> numbers,
                                   std::span<const std::uint32_t> others);

/// A keeper for this card: the descriptor from an earlier run if it is an opening of this card, else a new
/// one. Neither may set modes. None: the card cannot be opened.
/// @param left  the descriptor from an earlier run; used or closed
UniqueFd keeper_of(int card, UniqueFd left);

}  // namespace vitrine::player
