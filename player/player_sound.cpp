#include "base/system/log.hpp"
#include "player/player.hpp"

#include <vector>

// What a running player lets be heard.

namespace vitrine::player {

/// As the walls are at this time; where none is shown, nothing.
void Player::hear(std::chrono::nanoseconds time) {
    if (!sound_) return;
    std::vector<AudibleShot> shots;
    for (const auto& stage : stages_)
        for (AudibleShot& shot : stage->audible())
            shots.push_back(std::move(shot));
    sound_->follow(shots, (start_ + time).time_since_epoch());
    for (const SoundEvent& event : sound_->take_events())
        log::write(event.is_trouble ? log::Level::warning : log::Level::info, "sound: " + event.text);
}

}  // namespace vitrine::player
