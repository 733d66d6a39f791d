#include "player/scene/chosen_sound.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr double much_larger = 2;                  // times the area
constexpr std::chrono::nanoseconds together = 2s;  // those that came within this time came together

}  // namespace

const AudibleShot* chosen_sound(std::span<const AudibleShot> shots) {
    const auto largest = std::ranges::max_element(shots, {}, &AudibleShot::area);
    if (largest == shots.end()) return nullptr;
    const auto is_large = [&](const AudibleShot& shot) {
        return &shot == &*largest || largest->area < much_larger * shot.area;
    };
    std::chrono::nanoseconds longest{0};
    for (const AudibleShot& shot : shots)
        if (is_large(shot)) longest = std::max(longest, shot.local);
    const AudibleShot* chosen = nullptr;
    for (const AudibleShot& shot : shots)
        if (is_large(shot) && longest - shot.local <= together && (!chosen || shot.area > chosen->area))
            chosen = &shot;
    return chosen;
}

}  // namespace vitrine::player
