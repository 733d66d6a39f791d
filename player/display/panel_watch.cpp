#include "player/display/panel_watch.hpp"

#include "base/system/error.hpp"

#include <linux/netlink.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/timerfd.h>

#include <array>
#include <string_view>

namespace vitrine::player {

namespace {

constexpr timespec tick{.tv_sec = 2, .tv_nsec = 0};
constexpr timespec settle_time{.tv_sec = 0, .tv_nsec = 300'000'000};
constexpr int max_messages = 256;  // read at once; further ones wake the loop again

UniqueFd kernel_events() {
    UniqueFd socket(::socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT));
    sockaddr_nl address{};
    address.nl_family = AF_NETLINK;
    address.nl_groups = 1;  // messages of the kernel itself, not of udev
    if (socket.is_open() &&
        ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        socket.reset();
    return socket;
}

UniqueFd timer() {
    return UniqueFd(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK));
}

bool has_run_out(int timer) {
    std::uint64_t times = 0;
    return ::read(timer, &times, sizeof times) == sizeof times;
}

// A message is a list of words, each ended by a 0.
bool is_about_panels(std::string_view message) {
    return message.find("SUBSYSTEM=drm") != std::string_view::npos;
}

bool take_messages(int socket) {
    bool found = false;
    for (int i = 0; i < max_messages; ++i) {
        std::array<char, 4096> message{};
        const ssize_t size = ::recv(socket, message.data(), message.size(), 0);
        if (size < 0 && errno == ENOBUFS) return true;  // some messages were lost: look anyway
        if (size <= 0) break;
        found |= is_about_panels({message.data(), static_cast<std::size_t>(size)});
    }
    return found;
}

}  // namespace

PanelWatch::PanelWatch(int card)
    : card_(card),
      all_(::epoll_create1(EPOLL_CLOEXEC)),
      timer_(timer()),
      settled_(timer()),
      kernel_(kernel_events()) {
    if (!all_.is_open()) throw_errno("make an epoll set for the graphics card");
    if (!timer_.is_open() || !settled_.is_open()) throw_errno("make a timer for the graphics card");
    const itimerspec period{.it_interval = tick, .it_value = tick};
    if (::timerfd_settime(timer_.get(), 0, &period, nullptr) != 0) throw_errno("start a timer");
    for (const int fd : {card_, timer_.get(), settled_.get(), kernel_.get()}) {
        epoll_event event{.events = EPOLLIN, .data = {.fd = fd}};
        if (fd >= 0 && ::epoll_ctl(all_.get(), EPOLL_CTL_ADD, fd, &event) != 0)
            throw_errno("wait for the graphics card");
    }
}

PanelWatch::Events PanelWatch::read_events() {
    Events events;
    std::array<epoll_event, 4> ready{};
    const int count = ::epoll_wait(all_.get(), ready.data(), static_cast<int>(ready.size()), 0);
    for (int i = 0; i < count; ++i) {
        const int fd = ready[static_cast<std::size_t>(i)].data.fd;
        const bool is_broken = (ready[static_cast<std::size_t>(i)].events & (EPOLLHUP | EPOLLERR)) != 0;
        if (fd == card_) events.card = true;
        if (fd == card_ && is_broken) events.panels = true;
        if (fd == timer_.get()) events.tick = has_run_out(fd);
        if (fd == settled_.get()) events.panels = has_run_out(fd);
        if (fd == kernel_.get() && take_messages(fd)) await_rest();
    }
    return events;
}

// The time counts from the first message: a panel that never stops sending is looked at all the same.
void PanelWatch::await_rest() {
    itimerspec left{};
    if (::timerfd_gettime(settled_.get(), &left) == 0 && left.it_value.tv_nsec != 0) return;
    const itimerspec once{.it_interval = {}, .it_value = settle_time};
    if (::timerfd_settime(settled_.get(), 0, &once, nullptr) != 0) throw_errno("start a timer");
}

}  // namespace vitrine::player
