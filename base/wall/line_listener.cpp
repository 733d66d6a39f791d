#include "base/wall/line_listener.hpp"

#include "base/system/error.hpp"
#include "base/wall/unix_address.hpp"

#include <sys/epoll.h>
#include <sys/stat.h>

#include <system_error>
#include <utility>

namespace vitrine {

namespace {

constexpr int backlog = 8;
constexpr mode_t socket_mode = 0660;

UniqueFd listening_socket(const std::filesystem::path& path) {
    const UnixAddress address(path);
    UniqueFd socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!socket.is_open()) throw_errno("make a socket");
    std::error_code error;
    if (std::filesystem::is_socket(path, error)) std::filesystem::remove(path, error);
    if (::bind(socket.get(), address.get(), sizeof address.address) < 0)
        throw_errno("bind to '{}'", path.native());
    if (::chmod(path.c_str(), socket_mode) < 0) throw_errno("set the mode of '{}'", path.native());
    if (::listen(socket.get(), backlog) < 0) throw_errno("listen at '{}'", path.native());
    return socket;
}

}  // namespace

LineListener::LineListener(EventLoop& loop, std::filesystem::path path, Handlers handlers)
    : loop_(loop),
      path_(std::move(path)),
      handlers_(std::move(handlers)),
      socket_(listening_socket(path_)),
      source_(loop.watch(socket_.get(), EPOLLIN, [this](std::uint32_t) { accept(); })) {}

LineListener::~LineListener() {
    std::error_code error;
    std::filesystem::remove(path_, error);
}

void LineListener::accept() {
    UniqueFd end(::accept4(socket_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!end.is_open() || connections_.size() >= max_connections) return;
    const Id id = ++last_;
    connections_[id] = std::make_unique<LineConnection>(
        loop_, std::move(end),
        LineConnection::Handlers{.line = [this, id](const std::string& line) { handlers_.line(id, line); },
                                 .end =
                                     [this, id](const std::string& why) {
                                         connections_.erase(id);
                                         handlers_.end(id, why);
                                     }});
    handlers_.begin(id);
}

void LineListener::send(Id to, std::string_view line) {
    if (const auto found = connections_.find(to); found != connections_.end()) found->second->send(line);
}

void LineListener::send_all(std::string_view line) {
    for (const auto& [id, connection] : connections_)
        connection->send(line);
}

}  // namespace vitrine
