#include "player/playback/reader/free_slots.hpp"

#include <utility>

namespace vitrine::player {

FreeSlots::FreeSlots(std::shared_ptr<const PictureSlots> memory) {
    set_memory(std::move(memory), 0);
}

FreeSlots::Place FreeSlots::wait_for_slot() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !free_.empty(); });
    Place place{.memory = memory_, .name = {.memory = number_, .slot = free_.back()}};
    free_.pop_back();
    return place;
}

void FreeSlots::give_back(const SlotNote& slot) {
    const std::lock_guard lock(mutex_);
    if (slot.memory != number_) return;
    free_.push_back(slot.slot);
    changed_.notify_all();
}

void FreeSlots::change_memory(std::shared_ptr<const PictureSlots> memory, std::uint32_t number) {
    const std::lock_guard lock(mutex_);
    set_memory(std::move(memory), number);
    changed_.notify_all();
}

void FreeSlots::set_memory(std::shared_ptr<const PictureSlots> memory, std::uint32_t number) {
    memory_ = std::move(memory);
    number_ = number;
    free_.clear();
    for (std::uint32_t slot = 0; slot < memory_->shape().count; ++slot)
        free_.push_back(slot);
}

}  // namespace vitrine::player
