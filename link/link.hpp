#pragma once

#include "base/system/event_loop.hpp"
#include "base/wall/line_listener.hpp"
#include "link/broker_client.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace vitrine::link {

/// Carries messages between the player of this box and the other boxes of its wall.
class Link {
  public:
    static constexpr std::size_t max_boxes = 64;  // of a wall; others are refused

    /// @param loop    outlives this
    /// @param socket  where the player connects; a `prepare` and another tapestry change the file `wanted`
    ///                beside it
    /// @throws std::system_error, std::invalid_argument
    Link(EventLoop& loop, const BrokerAccount& account, const std::filesystem::path& socket);

  private:
    void greet(LineListener::Id player);
    void send(const std::string& line);
    void leave(const std::string& why);
    void follow_state(bool is_connected, const std::string& says);
    void hear(const WallMessage& message);
    void refuse(const std::string& fault);
    void tell_state();
    void sum_up();
    bool tells_other_tapestry(const WallMessage& message);
    void want_files() const;

    WallPlace place_;
    std::filesystem::path wanted_;
    std::map<std::string, WallMessage> sent_;   // the newest of the player's of each topic that is kept
    std::map<std::string, WallMessage> heard_;  // the same, of the other boxes
    bool is_connected_ = false;
    std::string says_ = "not connected yet";
    std::string tapestry_;     // that the last message `lifted` told of; empty: none
    std::size_t refused_ = 0;  // since the last line of the log about it
    EventLoop::Source summary_;
    LineListener players_;
    BrokerClient broker_;
};

}  // namespace vitrine::link
