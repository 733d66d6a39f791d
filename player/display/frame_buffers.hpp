#pragma once

#include "base/system/unique_fd.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vitrine::player {

/// A buffer in a card's memory that is to be shown: what the card has to know of it.
struct BufferForm {
    std::uint32_t width = 0;  // px
    std::uint32_t height = 0;
    std::uint32_t format = 0;                // DRM_FORMAT_*
    std::array<std::uint32_t, 4> handles{};  // of the card, a plane each; 0: no such plane
    std::array<std::uint32_t, 4> pitches{};  // bytes a row
    std::array<std::uint32_t, 4> offsets{};  // bytes
    std::array<std::uint64_t, 4> modifiers{};
    bool is_modifier_named = false;
};

/// The card's numbers for buffers that are to be shown.
///
/// A card forgets the pictures of a program that ends, and turns off what shows them. So they are told to it
/// through an opening of its own, the keeper, which systemd holds over a restart (FileDescriptorStoreMax=):
/// all else that the program had of the card ends with it, and the picture stays until the next program shows
/// its first. Where a card does not pass buffers from one opening to another its own is used.
class FrameBuffers {
  public:
    /// @param card    outlives this
    /// @param keeper  another opening of it, perhaps of an earlier run with its pictures; none: the card's
    /// own
    FrameBuffers(int card, UniqueFd keeper);
    FrameBuffers(const FrameBuffers&) = delete;
    FrameBuffers& operator=(const FrameBuffers&) = delete;
    FrameBuffers(FrameBuffers&&) = delete;
    FrameBuffers& operator=(FrameBuffers&&) = delete;
    ~FrameBuffers() = default;

    /// The number of a buffer, which it keeps in being; 0: the card does not take it, errno says why.
    std::uint32_t add(const BufferForm& form);

    void remove(std::uint32_t number);

    /// From here on none is removed: the program ends, and what is shown stays.
    /// @return whether they outlive the card's opening
    bool keep();

    /// Whether pictures of an earlier run are left.
    bool has_old() const { return !old_.empty(); }

    /// Those of an earlier run that are not shown any more go.
    /// @param shown  the numbers that are
    void let_go(std::span<const std::uint32_t> shown);

  private:
    std::uint32_t add_to_keeper(const BufferForm& form);

    int card_;
    UniqueFd keeper_;
    bool is_keeper_refused_ = false;
    bool keeps_ = false;
    std::vector<std::uint32_t> old_;  // of the keeper
    std::vector<std::uint32_t> own_;  // of the card itself, where the keeper has refused
};

/// Those of the first that are not among the others.
std::vector<std::uint32_t> without(std::span<const std::uint32_t> numbers,
                                   std::span<const std::uint32_t> others);

/// The descriptor that an earlier run left, where it is an opening of this card, else a new one; neither may
/// tell the card what to show. None where it cannot be opened.
/// @param left  taken where it is used, else closed
UniqueFd keeper_of(int card, UniqueFd left);

}  // namespace vitrine::player
