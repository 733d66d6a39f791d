#include "player/display/panel_watch.hpp"

#include "base/system/error.hpp"

#include <linux/netlink.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/timerfd.h>

#include <array>
#include <string_view>

namespace vitrine {

namespace {

constexpr time_t tick_seconds = 2;
constexpr int most_messages = 256;  // read in one go; more of them wake us again

UniqueFd kernel_events() {
    UniqueFd socket(::socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT));
    sockaddr_nl address{};
    address.nl_family = AF_NETLINK;
    address.nl_groups = 1;  // from the kernel itself, not from udev
    if (socket.is_open() &&
        ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        socket.reset();
    return socket;
}

// A message is a list of words, each ended by a 0.
bool is_about_panels(std::string_view message) {
    return message.find("SUBSYSTEM=drm") != std::string_view::npos;
}

bool take_messages(int socket) {
    bool found = false;
    for (int i = 0; i < most_messages; ++i) {
        std::array<char, 4096> message{};
        const ssize_t size = ::recv(socket, message.data(), message.size(), 0);
        if (size < 0 && errno == ENOBUFS) return true;  // some are lost: look
        if (size <= 0) break;
        found |= is_about_panels({message.data(), static_cast<std::size_t>(size)});
    }
    return found;
}

}  // namespace

PanelWatch::PanelWatch(int card)
    : card_(card),
      all_(::epoll_create1(EPOLL_CLOEXEC)),
      timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK)),
      kernel_(kernel_events()) {
    if (!all_.is_open()) throw_errno("make an epoll set for the graphics card");
    if (!timer_.is_open()) throw_errno("make a timer for the graphics card");
    const itimerspec period{.it_interval = {.tv_sec = tick_seconds}, .it_value = {.tv_sec = tick_seconds}};
    if (::timerfd_settime(timer_.get(), 0, &period, nullptr) != 0) throw_errno("start a timer");
    for (const int fd : {card_, timer_.get(), kernel_.get()}) {
        epoll_event event{.events = EPOLLIN, .data = {.fd = fd}};
        if (fd >= 0 && ::epoll_ctl(all_.get(), EPOLL_CTL_ADD, fd, &event) != 0)
            throw_errno("wait for the graphics card");
    }
}

PanelWatch::Events PanelWatch::take() {
    Events events;
    std::array<epoll_event, 3> ready{};
    const int count = ::epoll_wait(all_.get(), ready.data(), static_cast<int>(ready.size()), 0);
    for (int i = 0; i < count; ++i) {
        const int fd = ready[static_cast<std::size_t>(i)].data.fd;
        std::uint64_t ticks = 0;
        if (fd == card_) events.card = true;
        if (fd == timer_.get()) events.tick = ::read(fd, &ticks, sizeof ticks) == sizeof ticks;
        if (fd == kernel_.get()) events.panels = take_messages(fd);
    }
    return events;
}

}  // namespace vitrine
