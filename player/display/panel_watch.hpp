#pragma once

#include "base/system/unique_fd.hpp"

namespace vitrine::player {

/// Reports that panels may have come, gone or changed: a moment after the kernel's message, because the
/// kernel sends several for one change; and every two seconds, because it does not always send one. Also
/// wakes for the card's own events.
class PanelWatch {
  public:
    struct Events {
        bool card = false;    // the card has an event to read
        bool panels = false;  // the kernel has reported a change of panels or cards
        bool tick = false;    // two seconds have passed
    };

    /// @param card  file descriptor, outlives this
    /// @throws std::system_error
    explicit PanelWatch(int card);

    /// Readable when there are events.
    int fd() const { return all_.get(); }

    /// The events since the last call; does not wait.
    Events read_events();

  private:
    void await_rest();

    int card_;
    UniqueFd all_;
    UniqueFd timer_;
    UniqueFd settled_;  // a timer: a moment after the kernel's first message
    UniqueFd kernel_;   // -1: no messages from the kernel
};

}  // namespace vitrine::player
