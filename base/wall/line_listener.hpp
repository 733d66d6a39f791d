#pragma once

#include "base/wall/line_connection.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace vitrine {

/// Listens at a path for connections of lines: the end of vitrine-link.
class LineListener {
  public:
    static constexpr std::size_t max_connections = 4;  // more are closed at once

    using Id = std::uint64_t;

    struct Handlers {
        std::function<void(Id)> begin;
        std::function<void(Id, const std::string& line)> line;  // BrokenLine ends that connection
        std::function<void(Id, const std::string& why)> end;
    };

    /// Takes the place of a socket that an earlier process left. The owner and the group of the process may
    /// connect.
    /// @param loop  outlives this
    /// @throws std::system_error, std::invalid_argument
    LineListener(EventLoop& loop, std::filesystem::path path, Handlers handlers);
    LineListener(const LineListener&) = delete;
    LineListener& operator=(const LineListener&) = delete;
    ~LineListener();

    /// Sends a line to one connection, if it is still there.
    void send(Id to, std::string_view line);

    /// Sends a line to all connections.
    void send_all(std::string_view line);

    std::size_t connections() const { return connections_.size(); }

  private:
    void accept();

    EventLoop& loop_;
    std::filesystem::path path_;
    Handlers handlers_;
    UniqueFd socket_;
    std::map<Id, std::unique_ptr<LineConnection>> connections_;
    Id last_ = 0;
    EventLoop::Source source_;
};

}  // namespace vitrine
