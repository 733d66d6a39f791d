#pragma once

#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Puts lines together from the pieces in which a stream delivers them.
class LineSplitter {
  public:
    explicit LineSplitter(std::size_t max_line) : max_line_(max_line) {}

    /// The lines that this piece completes, without their newlines.
    /// @throws BrokenLine if a line is longer than max_line, whether it is complete or not
    std::vector<std::string> push(std::string_view piece);

  private:
    std::size_t max_line_;
    std::string begun_;
};

/// One end of a stream socket that carries lines between vitrine-link and the player. It never waits.
class LineConnection {
  public:
    static constexpr std::size_t max_waiting = std::size_t{8}
                                               << 20;  // bytes that the other end has not taken yet

    struct Handlers {
        /// Gets a line without its newline. BrokenLine ends the connection. It must not destroy the
        /// connection.
        std::function<void(const std::string& line)> line;
        /// Called once, as the last of all, with a sentence. It may destroy the connection.
        std::function<void(const std::string& why)> end;
    };

    /// @param loop  outlives this
    /// @param end   does not block
    LineConnection(EventLoop& loop, UniqueFd end, Handlers handlers);

    /// Sends a line, or keeps it until the other end takes it. A connection on which too much waits ends: the
    /// other end connects again and learns what counts then.
    void send(std::string_view line);

    /// The bytes that wait for the other end.
    std::size_t waiting() const { return out_.size(); }

  private:
    void handle(std::uint32_t events);
    bool read();
    void write();
    void watch();
    void break_off(const std::string& why);
    void finish();

    EventLoop& loop_;
    UniqueFd end_;
    Handlers handlers_;
    LineSplitter splitter_;
    std::string out_;
    std::string why_;  // the connection breaks off; empty: it holds
    bool is_writing_ = false;
    EventLoop::Source source_;
};

}  // namespace vitrine
