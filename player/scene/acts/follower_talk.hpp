#pragma once

#include "player/scene/acts/box_talk.hpp"
#include "player/scene/acts/lifted_json.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// A follower's half of the talk: it hears acts, preparations and what hands hold, and says when it is ready,
/// what it lacks and how it is touched.
class FollowerTalk final : public BoxTalk {
  public:
    explicit FollowerTalk(std::string box) : BoxTalk(std::move(box)) {}

    void say_again() override;

    void direct(Show& show, const BoxMoment& moment) override;

  private:
    void hear_more(const WallMessage& message) override;
    std::vector<WallMessage> speak_more(Show& show, const BoxMoment& moment, BoxNote& note) override;

    std::optional<WallAct> act_;
    std::optional<WallAct> preparation_;
    std::optional<ToldHands> lifted_;  // none: no news
    std::optional<ActName> ready_;     // the preparation that it said it has
};

}  // namespace vitrine::player
