#pragma once

#include "base/wall/wall_message.hpp"
#include "player/input/contact.hpp"
#include "player/scene/acts/box_note.hpp"
#include "player/scene/show.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// A box of a wall at the moment of a frame.
struct BoxMoment {
    std::chrono::nanoseconds now{0};    // the box's time of the frame
    std::chrono::nanoseconds epoch{0};  // shared time, since 1970, at the box's time 0
    BoxNote own = {};                   // its outputs and its clock
};

/// The messages of a box to the others of its wall, and theirs to it: the leader's half and a follower's.
/// Knows no network, no clock and no files.
class BoxTalk {
  public:
    explicit BoxTalk(std::string box) : box_(std::move(box)) {}

    BoxTalk(const BoxTalk&) = delete;
    BoxTalk& operator=(const BoxTalk&) = delete;
    BoxTalk(BoxTalk&&) = delete;
    BoxTalk& operator=(BoxTalk&&) = delete;
    virtual ~BoxTalk() = default;

    /// Hears a message of another box. @throws std::runtime_error with one sentence; then nothing has changed
    void hear(const WallMessage& message);

    /// Call before each frame: gives the show what was heard.
    virtual void direct(Show& /*show*/, const BoxMoment& /*moment*/) {}

    /// Call after each frame of the show. @return messages to the others
    std::vector<WallMessage> speak(Show& show, const BoxMoment& moment);

    /// Call when the show has been replaced by another one.
    virtual void begin_anew() {}

    /// Says all that is kept once more, because the connection is new.
    virtual void say_again() { told_.reset(); }

    /// The notes of the other boxes by their names, also of those that are gone.
    const std::map<std::string, BoxNote>& others() const { return others_; }

    const std::string& box() const { return box_; }

    /// The last facts that this box has told of itself.
    const std::optional<BoxNote>& told() const { return told_; }

    /// A sentence on what this box could not tell the others the last time. Empty: nothing.
    virtual std::string complaint() const { return {}; }

    /// Touches on other boxes since the last call, at this box's times.
    virtual std::vector<InputEvent> take_touches(const BoxMoment& /*moment*/) { return {}; }

  protected:
    virtual void hear_more(const WallMessage& message) = 0;

    /// @param note  this box's own, to be completed
    virtual std::vector<WallMessage> speak_more(Show& show, const BoxMoment& moment, BoxNote& note) = 0;

  private:
    std::string box_;
    std::map<std::string, BoxNote> others_;
    std::optional<BoxNote> told_;  // none: it must be told anew
    std::chrono::nanoseconds told_at_{0};
};

}  // namespace vitrine::player
