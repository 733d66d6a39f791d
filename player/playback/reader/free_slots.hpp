#pragma once

#include "player/playback/reader/picture_slots.hpp"
#include "player/playback/reader/reader_messages.hpp"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace vitrine::player {

/// Thread-safe. The slots of a reader that the player does not hold.
class FreeSlots {
  public:
    explicit FreeSlots(std::shared_ptr<const PictureSlots> memory);

    /// One slot that is taken, and the memory that it lies in.
    struct Place {
        std::shared_ptr<const PictureSlots> memory;
        SlotNote name;
    };

    /// Waits for a free slot and takes it.
    Place wait_for_slot();

    /// The player does not hold this slot any more. A slot of earlier memory is forgotten.
    void give_back(const SlotNote& slot);

    /// Uses other memory from now on. All its slots are free.
    void change_memory(std::shared_ptr<const PictureSlots> memory, std::uint32_t number);

  private:
    void set_memory(std::shared_ptr<const PictureSlots> memory, std::uint32_t number);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::shared_ptr<const PictureSlots> memory_;  // guarded by mutex_
    std::uint32_t number_ = 0;                    // guarded by mutex_
    std::vector<std::uint32_t> free_;             // guarded by mutex_
};

}  // namespace vitrine::player
