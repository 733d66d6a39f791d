#pragma once

#include "player/scene/acts/box_talk.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The leader's half of the talk: it says acts and preparations, and hears who is ready and who is touched. A
/// box that was not ready in time is not waited for until it was ready once.
class LeaderTalk final : public BoxTalk {
  public:
    /// @param run  another number at each start
    LeaderTalk(std::string box, std::int64_t run) : BoxTalk(std::move(box)), run_(run) {}

    void say_again() override;

    std::vector<InputEvent> take_touches(std::chrono::nanoseconds now) override;

  private:
    void hear_more(const WallMessage& message) override;
    std::vector<WallMessage> speak_more(Show& show, const BoxMoment& moment, BoxNote& note) override;
    std::optional<std::uint64_t> others_ready() const;

    std::int64_t run_;
    std::uint64_t preparation_ = 0;                             // the last one said
    std::map<std::string, std::uint64_t> ready_;                // the last preparation that a box has
    std::optional<ActName> said_;                               // the last act
    std::optional<std::chrono::nanoseconds> epoch_;             // of the last act
    std::vector<std::pair<std::string, std::string>> touches_;  // box, payload
    std::vector<WallMessage> kept_;                             // the last act and the last preparation
    bool says_again_ = false;
};

}  // namespace vitrine::player
