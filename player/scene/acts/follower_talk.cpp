#include "player/scene/acts/follower_talk.hpp"

#include "player/scene/acts/act_json.hpp"
#include "player/scene/acts/followed_wall.hpp"
#include "player/scene/acts/touch_json.hpp"

#include <utility>

namespace vitrine::player {

using Kind = WallTopic::Kind;

void FollowerTalk::hear_more(const WallMessage& message) {
    if (message.topic.kind == Kind::act) act_ = act_from_json(message.payload);
    if (message.topic.kind == Kind::lifted) lifted_ = lifted_from_json(message.payload);
    if (message.topic.kind == Kind::prepare) preparation_ = act_from_json(message.payload);
}

void FollowerTalk::direct(Show& show, const BoxMoment& moment) {
    FollowedWall* const followed = show.followed();
    if (followed == nullptr) return;
    followed->set_clock(moment.epoch, moment.own.has_right_clock);
    if (preparation_) followed->prepare(*preparation_);
    if (act_) followed->take(*act_);
    if (const std::optional<ToldHands> lifted = std::exchange(lifted_, std::nullopt))
        followed->take_lifted(*lifted);
}

std::vector<WallMessage> FollowerTalk::speak_more(Show& show, const BoxMoment& moment, BoxNote& note) {
    FollowedWall* const followed = show.followed();
    if (followed == nullptr) return {};
    const FollowedState state = followed->state();
    note.shown = state.shown;
    note.lacking.assign(state.lacking.begin(), state.lacking.end());
    if (note.lacking.size() > max_told_lacks) note.lacking.resize(max_told_lacks);
    std::vector<WallMessage> said;
    if (state.prepared && state.prepared != ready_) {
        ready_ = state.prepared;
        said.push_back({.topic = {.kind = Kind::ready, .box = box()},
                        .is_retained = true,
                        .payload = ready_to_json(*ready_)});
    }
    if (const std::vector<InputEvent> touches = followed->touches().take(moment.now); !touches.empty())
        said.push_back({.topic = {.kind = Kind::touch, .box = box()},
                        .is_retained = false,
                        .payload = touches_to_json(touches, moment)});
    return said;
}

void FollowerTalk::say_again() {
    BoxTalk::say_again();
    ready_.reset();
}

}  // namespace vitrine::player
