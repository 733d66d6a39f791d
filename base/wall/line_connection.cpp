#include "base/wall/line_connection.hpp"

#include "base/wall/broken_line.hpp"
#include "base/wall/wall_message.hpp"

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace vitrine {

namespace {

bool must_wait(int error) {
    return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

}  // namespace

std::vector<std::string> LineSplitter::push(std::string_view piece) {
    std::vector<std::string> lines;
    while (!piece.empty()) {
        const std::size_t end = piece.find('\n');
        begun_.append(piece.substr(0, end));
        if (begun_.size() > max_line_)
            throw BrokenLine(fmt::format("a line has more than {} bytes", max_line_));
        if (end == std::string_view::npos) break;
        lines.push_back(std::exchange(begun_, {}));
        piece.remove_prefix(end + 1);
    }
    return lines;
}

LineConnection::LineConnection(EventLoop& loop, UniqueFd end, Handlers handlers)
    : loop_(loop), end_(std::move(end)), handlers_(std::move(handlers)), splitter_(max_wall_line) {
    watch();
}

void LineConnection::send(std::string_view line) {
    if (!why_.empty()) return;
    out_.append(line);
    out_ += '\n';
    write();
    if (out_.size() > max_waiting) break_off("the other end takes no lines");
}

void LineConnection::watch() {
    is_writing_ = !out_.empty();
    source_ = {};  // a descriptor is watched once
    const std::uint32_t events = is_writing_ ? EPOLLIN | EPOLLOUT : EPOLLIN;
    source_ = loop_.watch(end_.get(), events, [this](std::uint32_t came) { handle(came); });
}

void LineConnection::handle(std::uint32_t events) {
    if (why_.empty() && (events & EPOLLOUT) != 0) write();
    if (!why_.empty() || !read()) finish();
}

/// @return  false: the connection is at its end
bool LineConnection::read() {
    std::array<char, 65536> piece{};
    const ssize_t got = ::recv(end_.get(), piece.data(), piece.size(), MSG_DONTWAIT);
    if (got < 0 && must_wait(errno)) return true;
    if (got <= 0) {
        why_ = got == 0 ? "the other end has closed" : std::generic_category().message(errno);
        return false;
    }
    try {
        for (const std::string& line : splitter_.push({piece.data(), static_cast<std::size_t>(got)}))
            handlers_.line(line);
    } catch (const BrokenLine& broken) {
        why_ = broken.what();
    }
    return why_.empty();
}

void LineConnection::write() {
    const ssize_t sent = ::send(end_.get(), out_.data(), out_.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0 && !must_wait(errno)) return break_off(std::generic_category().message(errno));
    if (sent > 0) out_.erase(0, static_cast<std::size_t>(sent));
    if (is_writing_ == out_.empty()) watch();
}

/// Ends the connection from the loop: the caller may be in the middle of something.
void LineConnection::break_off(const std::string& why) {
    if (!why_.empty()) return;
    why_ = why;
    ::shutdown(end_.get(), SHUT_RDWR);
}

void LineConnection::finish() {
    source_ = {};
    end_.reset();
    const auto end = std::move(handlers_.end);
    end(std::string(why_));
}

}  // namespace vitrine
