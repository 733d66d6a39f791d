#pragma once

#include "base/system/unique_fd.hpp"
#include "player/playback/reader/reader_messages.hpp"
#include "player/playback/sample.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace vitrine::player {

constexpr int max_picture_side = 16'384;  // px of a picture that is handed over

/// Room for the pictures that a reader may hand over. A film's planes may be twice as large as they are
/// shown.
/// @param width, height  px asked for
/// @return  none: no such picture can be handed over
std::optional<SlotShape> slots_for(std::size_t count, int width, int height, PictureForm form);

/// New memory of that size, which nobody can change any more: the process that reads it cannot be made to
/// read where nothing is. @throws std::system_error
UniqueFd new_slot_memory(const SlotShape& shape);

/// Memory for pictures, divided into slots, as one process sees it. The player makes it and reads it, a
/// reader writes it.
class PictureSlots {
  public:
    enum class Use { reading, writing };

    /// @param memory  made by new_slot_memory(); not needed any more afterwards
    /// @throws std::system_error if it cannot be mapped
    PictureSlots(const UniqueFd& memory, const SlotShape& shape, Use use);
    ~PictureSlots();
    PictureSlots(const PictureSlots&) = delete;
    PictureSlots& operator=(const PictureSlots&) = delete;
    PictureSlots(PictureSlots&&) = delete;
    PictureSlots& operator=(PictureSlots&&) = delete;

    const SlotShape& shape() const { return shape_; }

    /// @pre slot < shape().count
    std::span<const std::byte> slot(std::uint32_t slot) const { return {begin_of(slot), shape_.bytes}; }

    /// @pre slot < shape().count, and the use is writing
    std::span<std::byte> writable_slot(std::uint32_t slot) const { return {begin_of(slot), shape_.bytes}; }

  private:
    std::byte* begin_of(std::uint32_t slot) const { return memory_ + std::size_t{slot} * shape_.bytes; }

    SlotShape shape_;
    std::byte* memory_ = nullptr;  // shape_.all_bytes(), mapped
};

/// The picture of that size and layout at the begin of a slot, without an owner. None: the slot is too small,
/// or there is no such picture.
std::optional<Sample> sample_in(std::span<const std::byte> slot, int width, int height, PixelLayout layout);

/// Copies the planes of a picture to where sample_in() finds them. False: it does not fit.
bool copy_picture(const Sample& picture, std::span<std::byte> slot);

}  // namespace vitrine::player
