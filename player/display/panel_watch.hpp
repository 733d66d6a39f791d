#pragma once

#include "base/system/unique_fd.hpp"

namespace vitrine::player {

/// Tells when panels may have come, gone or changed: a moment after the kernel says so, as it says it several
/// times, and every few seconds because it does not always. Also wakes for what the card itself reports.
class PanelWatch {
  public:
    struct Events {
        bool card = false;    // the card has something to read
        bool panels = false;  // the kernel has said that panels or cards changed
        bool tick = false;    // two seconds have gone by
    };

    /// @param card  file descriptor, outlives this
    /// @throws std::system_error
    explicit PanelWatch(int card);

    /// Readable when there are events.
    int fd() const { return all_.get(); }

    /// What has happened since the last call; does not wait.
    Events read_events();

  private:
    void await_rest();

    int card_;
    UniqueFd all_;
    UniqueFd timer_;
    UniqueFd settled_;  // a moment after the kernel's first word
    UniqueFd kernel_;   // -1: the kernel does not tell us
};

}  // namespace vitrine::player
