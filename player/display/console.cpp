#include "player/display/console.hpp"

#include <fcntl.h>
#include <linux/kd.h>
#include <sys/ioctl.h>

#include <array>

namespace vitrine {

// The terminal that a service was given, else the one in front.
QuietConsole::QuietConsole() {
    constexpr std::array<const char*, 3> terminals{"/dev/stdin", "/dev/tty0", "/dev/tty1"};
    for (const char* path : terminals) {
        UniqueFd terminal(::open(path, O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
        int mode = 0;
        if (!terminal.is_open() || ::ioctl(terminal.get(), KDGETMODE, &mode) != 0) continue;
        if (mode != KD_GRAPHICS && ::ioctl(terminal.get(), KDSETMODE, KD_GRAPHICS) == 0)
            terminal_ = std::move(terminal);
        return;
    }
}

QuietConsole::~QuietConsole() {
    if (terminal_.is_open()) ::ioctl(terminal_.get(), KDSETMODE, KD_TEXT);
}

}  // namespace vitrine
