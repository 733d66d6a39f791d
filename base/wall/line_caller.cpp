#include "base/wall/line_caller.hpp"

#include "base/system/error.hpp"
#include "base/wall/unix_address.hpp"

#include <utility>

namespace vitrine {

namespace {

/// None: nobody listens there, or too many wait.
UniqueFd connected_socket(const std::filesystem::path& path) {
    const UnixAddress address(path);
    UniqueFd socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!socket.is_open()) throw_errno("make a socket");
    if (::connect(socket.get(), address.get(), sizeof address.address) < 0) socket.reset();
    return socket;
}

}  // namespace

LineCaller::LineCaller(EventLoop& loop, std::filesystem::path path, Handlers handlers,
                       std::chrono::milliseconds pause)
    : loop_(loop),
      path_(std::move(path)),
      handlers_(std::move(handlers)),
      pause_(pause),
      timer_(loop.timer([this] { call(); })) {
    static_cast<void>(UnixAddress(path_));  // a path that is too long is told now
    timer_.arm(std::chrono::milliseconds(0));
}

void LineCaller::call() {
    UniqueFd socket = connected_socket(path_);
    if (!socket.is_open()) return timer_.arm(pause_);
    connection_.emplace(
        loop_, std::move(socket),
        LineConnection::Handlers{.line = handlers_.line, .end = [this](const std::string& why) {
                                     connection_.reset();
                                     timer_.arm(pause_);
                                     handlers_.end(why);
                                 }});
    handlers_.begin();
}

void LineCaller::send(std::string_view line) {
    if (connection_) connection_->send(line);
}

}  // namespace vitrine
