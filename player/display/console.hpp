#pragma once

#include "base/system/unique_fd.hpp"

#include <csignal>

namespace vitrine::player {

/// The terminal that the wall is shown over. Its text is kept from being drawn for as long as this lives, and
/// when somebody switches to another terminal (Ctrl+Alt+F2) the kernel asks for the screen by a signal. Does
/// nothing on a machine without terminals, or where none is ours.
class Console {
  public:
    static constexpr int leave_signal = SIGUSR1;  // both must be blocked before this is made
    static constexpr int enter_signal = SIGUSR2;

    Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;
    Console(Console&&) = delete;
    Console& operator=(Console&&) = delete;
    ~Console();

    /// After leave_signal, when the graphics card has been left: lets the other terminal come.
    void leave();

    /// After enter_signal, before the graphics card is taken back.
    void enter();

    /// The last picture stays when this ends, and with it graphics mode: with its text the kernel would show
    /// the console, whoever has the card. As after a crash it helps itself when somebody switches.
    void keep() { terminal_.reset(); }

    /// False between the two.
    bool is_in_front() const { return is_in_front_; }

  private:
    UniqueFd terminal_;  // open while it is in graphics mode because of us
    bool is_in_front_ = true;
};

}  // namespace vitrine::player
