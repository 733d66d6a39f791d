#pragma once

#include "base/wall/line_connection.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// Connects to a LineListener, and connects again whenever that is gone: the player's end.
class LineCaller {
  public:
    struct Handlers {
        std::function<void()> begin;                        // connected
        std::function<void(const std::string& line)> line;  // BrokenLine ends the connection
        std::function<void(const std::string& why)> end;    // the connection is gone; another will be tried
    };

    /// Tries at once as soon as the loop runs.
    /// @param loop   outlives this
    /// @param pause  between two tries
    /// @throws std::invalid_argument if the path is too long
    LineCaller(EventLoop& loop, std::filesystem::path path, Handlers handlers,
               std::chrono::milliseconds pause = std::chrono::seconds(1));

    bool is_connected() const { return connection_.has_value(); }

    /// Sends a line. It is dropped while there is no connection: `begin` is the time to send what counts.
    void send(std::string_view line);

  private:
    void call();

    EventLoop& loop_;
    std::filesystem::path path_;
    Handlers handlers_;
    std::chrono::milliseconds pause_;
    std::optional<LineConnection> connection_;
    EventLoop::Source timer_;
};

}  // namespace vitrine
