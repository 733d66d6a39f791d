#include "player/scene/chosen_sound.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

constexpr double much_larger = 2;  // times the area

}  // namespace

const AudibleShot* chosen_sound(std::span<const AudibleShot> shots, std::optional<SourceId> heard) {
    const auto largest = std::ranges::max_element(shots, {}, &AudibleShot::area);
    if (largest == shots.end()) return nullptr;
    const auto now =
        std::ranges::find(shots, heard, [](const AudibleShot& shot) { return std::optional(shot.source); });
    const bool stays = now != shots.end() && largest->area < much_larger * now->area;
    return stays ? &*now : &*largest;
}

}  // namespace vitrine::player
