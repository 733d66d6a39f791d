#include "player/display/console.hpp"

#include <fcntl.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <sys/ioctl.h>

#include <array>

namespace vitrine::player {

namespace {

// The terminal that systemd has given to the service; without one, the terminal in front.
UniqueFd open_terminal() {
    constexpr std::array<const char*, 3> terminals{"/dev/stdin", "/dev/tty0", "/dev/tty1"};
    for (const char* path : terminals) {
        UniqueFd terminal(::open(path, O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
        int mode = 0;
        if (terminal.is_open() && ::ioctl(terminal.get(), KDGETMODE, &mode) == 0) return terminal;
    }
    return {};
}

}  // namespace

// Without VT_PROCESS the kernel cannot ask for the screen: the other terminals then show the wall as well.
Console::Console() {
    UniqueFd terminal = open_terminal();
    if (!terminal.is_open() || ::ioctl(terminal.get(), KDSETMODE, KD_GRAPHICS) != 0) return;
    vt_mode asks{};
    asks.mode = VT_PROCESS;
    asks.relsig = leave_signal;
    asks.acqsig = enter_signal;
    (void)::ioctl(terminal.get(), VT_SETMODE, &asks);
    terminal_ = std::move(terminal);
}

Console::~Console() {
    if (!terminal_.is_open()) return;
    vt_mode usual{};
    usual.mode = VT_AUTO;
    (void)::ioctl(terminal_.get(), VT_SETMODE, &usual);
    (void)::ioctl(terminal_.get(), KDSETMODE, KD_TEXT);
}

void Console::leave() {
    is_in_front_ = false;
    constexpr int may_go = 1;
    if (terminal_.is_open()) (void)::ioctl(terminal_.get(), VT_RELDISP, may_go);
}

void Console::enter() {
    is_in_front_ = true;
    if (terminal_.is_open()) (void)::ioctl(terminal_.get(), VT_RELDISP, VT_ACKACQ);
}

}  // namespace vitrine::player
