#include "base/system/stop_request.hpp"

#include "base/system/error.hpp"

#include <poll.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <utility>

namespace vitrine {

namespace {

sigset_t stop_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGINT);
    return signals;
}

UniqueFd opened_signals() {
    const sigset_t signals = stop_signals();
    UniqueFd fd(::signalfd(-1, &signals, SFD_CLOEXEC));
    if (!fd.is_open()) throw_errno("take the signals that end this program");
    return fd;
}

UniqueFd opened_event() {
    UniqueFd fd(::eventfd(0, EFD_CLOEXEC));
    if (!fd.is_open()) throw_errno("make an event");
    return fd;
}

/// A thread that takes no signal.
std::thread quiet_thread(std::function<void()> work) {
    sigset_t all, before;
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    std::thread thread(std::move(work));
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return thread;
}

/// @param timeout  in ms; -1: none
/// @return false where the time is over
template <std::size_t n> bool wait_for(std::array<pollfd, n>& files, int timeout) {
    int found = -1;
    do
        found = ::poll(files.data(), files.size(), timeout);
    while (found < 0 && errno == EINTR);
    return found != 0;
}

}  // namespace

StopRequest::StopRequest(EventLoop& loop, Limit limit, std::function<void()> stop)
    : limit_(limit), signals_(opened_signals()), asked_(opened_event()), over_(opened_event()) {
    const sigset_t signals = stop_signals();
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    source_ = loop.watch(asked_.get(), EPOLLIN, [this, stop = std::move(stop)](std::uint32_t) {
        stop();
        source_ = {};
    });
    thread_ = quiet_thread([this] { wait(); });
}

StopRequest::~StopRequest() {
    ::eventfd_write(over_.get(), 1);
    thread_.join();
}

/// Runs in the thread.
void StopRequest::wait() const {
    const pollfd over{.fd = over_.get(), .events = POLLIN, .revents = 0};
    std::array both{over, pollfd{.fd = signals_.get(), .events = POLLIN, .revents = 0}};
    wait_for(both, -1);
    if (both[0].revents != 0) return;
    ::eventfd_write(asked_.get(), 1);
    std::array last{over};
    if (wait_for(last, static_cast<int>(limit_.patience.count()))) return;
    ::_exit(limit_.exit_code);
}

}  // namespace vitrine
