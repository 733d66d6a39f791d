#pragma once

#include "player/input/contact.hpp"

#include <utility>
#include <vector>

namespace vitrine::player {

/// A visitor's touches on a box that follows, until the leader is told. Of each finger's moves only the last
/// counts. Canvas px.
class NotedTouches {
  public:
    void note(const InputEvent& event);

    /// The touches since the last call.
    std::vector<InputEvent> take() { return std::exchange(touches_, {}); }

  private:
    std::vector<InputEvent> touches_;
};

}  // namespace vitrine::player
