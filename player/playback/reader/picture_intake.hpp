#pragma once

#include "player/playback/reader/picture_slots.hpp"
#include "player/playback/reader/reader_messages.hpp"
#include "player/playback/sample_queue.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The pictures of one reader as the player takes them. The reader may have been taken over by its file:
/// every number is checked before it is used, and nothing that the reader writes is read as anything but
/// pixels. For one thread; the samples that it gives may be destroyed in any thread.
class PictureIntake {
  public:
    using GiveBack = std::function<void(const SlotNote& slot)>;

    /// @param duration   of the part of the film; 0 for a photo
    /// @param give_back  called when a sample is not needed any more, in any thread, also after this has gone
    PictureIntake(std::chrono::nanoseconds duration, GiveBack give_back);

    /// Takes the next memory: pictures may lie in it from now on, and in the one before.
    void add_memory(std::shared_ptr<const PictureSlots> slots);

    /// The sample of a picture. It refers to the slot and gives it back. None: a picture in earlier memory.
    /// @throws MediaError a fault of the file, if the reader names a picture that cannot be
    std::optional<LoopedSample> take(const PictureNote& note);

  private:
    /// Memory, and which of its slots the player holds.
    struct Memory {
        explicit Memory(std::shared_ptr<const PictureSlots> used)
            : slots(std::move(used)), held(slots->shape().count) {}

        std::shared_ptr<const PictureSlots> slots;
        std::vector<std::atomic<bool>> held;
    };

    struct Loan;

    std::shared_ptr<Memory> memory_of(const PictureNote& note) const;
    LoopedSample sample_of(const PictureNote& note, const Memory& memory) const;
    void require_possible_times(const PictureNote& note) const;

    std::chrono::nanoseconds duration_;
    std::shared_ptr<const GiveBack> give_back_;
    std::shared_ptr<Memory> before_;  // none: there was none
    std::shared_ptr<Memory> now_;
    std::uint32_t number_ = 0;  // of now_
};

}  // namespace vitrine::player
