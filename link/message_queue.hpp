#pragma once

#include "base/wall/wall_message.hpp"

#include <cstddef>
#include <deque>
#include <optional>

namespace vitrine::link {

/// True for topics of hands: what they did a while ago counts no more.
bool is_of_a_moment(WallTopic::Kind kind);

/// True for topics of which only the newest message counts; the broker keeps it. `ready` is one: a leader
/// that comes back after a follower would not hear it else.
bool is_kept(WallTopic::Kind kind);

/// Messages that wait, within bounds. A newer message takes the place of an older one of the same topic,
/// where only the newest counts. When it is full, the oldest of the others goes, and if there is none, the
/// oldest.
class MessageQueue {
  public:
    static constexpr std::size_t max_messages = 256;
    static constexpr std::size_t max_bytes = std::size_t{16} << 20;

    void put(WallMessage message);
    std::optional<WallMessage> take();

    std::size_t size() const { return messages_.size(); }

  private:
    void drop_oldest();

    std::deque<WallMessage> messages_;
    std::size_t bytes_ = 0;
};

}  // namespace vitrine::link
