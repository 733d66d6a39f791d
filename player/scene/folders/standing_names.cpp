#include "player/scene/folders/standing_names.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/folders/folder_names.hpp"

namespace vitrine::player {

namespace {

constexpr std::chrono::duration<double> fade_time{0.3};

}  // namespace

void StandingNames::stand(std::span<const PlacedShot> wall, Vec2 canvas, const Box& taken,
                          std::chrono::nanoseconds now) {
    if (!since_ || !is_placed_) all_ = folder_names(wall, canvas, taken);
    is_placed_ = true;
    if (!since_) since_ = now;
}

std::vector<FrameName> StandingNames::at(std::chrono::nanoseconds now) const {
    if (!since_) return {};
    std::vector<FrameName> names = all_;
    for (FrameName& name : names)
        name.alpha = eased(std::chrono::duration<double>(now - *since_) / fade_time);
    return names;
}

}  // namespace vitrine::player
