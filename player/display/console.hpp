#pragma once

#include "base/system/unique_fd.hpp"

#include <csignal>

namespace vitrine::player {

/// The terminal that the wall is shown over. While this lives the terminal draws no text, and when somebody
/// switches to another terminal (Ctrl+Alt+F2) the kernel asks for the screen by a signal. Does nothing if the
/// machine has no terminal, or none is ours.
class Console {
  public:
    static constexpr int leave_signal = SIGUSR1;  // block both signals before this is made
    static constexpr int enter_signal = SIGUSR2;

    Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;
    Console(Console&&) = delete;
    Console& operator=(Console&&) = delete;
    ~Console();

    /// Allows the other terminal to come to the front. Call after leave_signal, once the graphics card has
    /// been left.
    void leave();

    /// Takes the screen back. Call after enter_signal, before the graphics card is taken back.
    void enter();

    /// Leaves the terminal in graphics mode when this ends, so that the last picture stays. In text mode the
    /// kernel would show the console, no matter which program has the card. The kernel restores the text when
    /// somebody switches to another terminal, as it does after a crash.
    void keep() { terminal_.reset(); }

    /// False from leave() to enter().
    bool is_in_front() const { return is_in_front_; }

  private:
    UniqueFd terminal_;  // open while this keeps it in graphics mode
    bool is_in_front_ = true;
};

}  // namespace vitrine::player
