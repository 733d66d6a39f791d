#include "player/player.hpp"

// What visitors do, and what a rehearsal does in their place.

namespace vitrine::player {

void Player::rehearse(std::chrono::nanoseconds time) {
    if (options_.rehearsal->advance(time)) give_catalogue();
    for (const InputEvent& event : options_.rehearsal->touches())
        stages_.front()->take(event);
}

void Player::take(const Screen& screen, InputEvent event) {
    const auto found = stage_of_.find(screen.name());
    Stage& stage = *stages_[found == stage_of_.end() ? 0 : found->second];
    const auto place = [&](auto& one) {
        if constexpr (requires { one.at; }) one.at = stage.canvas_point(screen, one.at);
    };
    std::visit(place, event);
    stage.take(event);
}

}  // namespace vitrine::player
