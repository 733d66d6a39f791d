#pragma once

#include "player/scene/acts/act_json.hpp"
#include "player/scene/acts/box_talk.hpp"
#include "player/scene/acts/led_show.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The leader's half of the talk: it says acts, preparations and what hands hold, and hears who is ready and
/// who is touched. A box that was not ready in time is not waited for until it was ready once.
class LeaderTalk final : public BoxTalk {
  public:
    /// The longest act that is told, bytes: the line around it needs some.
    static constexpr std::size_t max_told_bytes = max_act_bytes - 65536;

    /// @param run        another number at each start
    /// @param max_bytes  of an act
    LeaderTalk(std::string box, std::int64_t run, std::size_t max_bytes = max_told_bytes)
        : BoxTalk(std::move(box)), run_(run), max_bytes_(max_bytes) {}

    /// Begins another run: the acts and preparations of the new show count from 1 again.
    void begin_anew() override;

    void say_again() override;

    std::string complaint() const override;

    std::vector<InputEvent> take_touches(const BoxMoment& moment) override;

  private:
    /// The parts of the last act that the others were told.
    enum class Told {
        whole,
        without_way,  // the end of its change: they fade to it
        nothing,      // they keep what they show
    };

    void hear_more(const WallMessage& message) override;
    std::vector<WallMessage> speak_more(Show& show, const BoxMoment& moment, BoxNote& note) override;
    std::optional<std::uint64_t> others_ready() const;
    std::string text_of_act(WallAct& act);
    void say_lifted(const LedNews& news, std::chrono::nanoseconds epoch, std::vector<WallMessage>& said);

    std::int64_t run_;
    std::size_t max_bytes_;
    std::uint64_t preparation_ = 0;                             // the last one said
    std::map<std::string, std::uint64_t> ready_;                // the last preparation that a box has
    std::optional<ActName> said_;                               // the last act
    std::optional<std::chrono::nanoseconds> epoch_;             // of the last act
    std::vector<std::pair<std::string, std::string>> touches_;  // box, payload
    std::vector<WallMessage> kept_;                             // the last act and the last preparation
    std::string lifted_;                     // the last message on what hands do; empty: nothing
    std::chrono::nanoseconds lifted_at_{0};  // when that was said
    bool says_again_ = false;
    Told told_ = Told::whole;
    std::uint64_t skipped_ = 0;  // numbers of acts that no act has
};

}  // namespace vitrine::player
