#pragma once

#include "player/input/contact.hpp"

#include <chrono>
#include <map>
#include <vector>

namespace vitrine::player {

/// A visitor's touches on a box that follows, until the leader is told. Of a finger's moves within 40 ms only
/// the last counts. A finger that rests is told again and again, as a move to the same place. Otherwise
/// the leader could not know that it was not lifted. Canvas px.
class NotedTouches {
  public:
    void note(const InputEvent& event);

    /// The touches since the last call, then the fingers that rest.
    std::vector<InputEvent> take(std::chrono::nanoseconds now);

  private:
    void follow(const Contact& contact);

    std::vector<InputEvent> touches_;
    std::map<int, Contact> fingers_;  // those that touch: the last contact of each
};

}  // namespace vitrine::player
