#pragma once

#include "base/system/unique_fd.hpp"

namespace vitrine {

/// Tells when panels may have come, gone or changed: when the kernel says so, and every few seconds because
/// it does not always. Also wakes for what the card itself reports.
class PanelWatch {
  public:
    struct Events {
        bool card = false;    // the card has something to read
        bool panels = false;  // the kernel says that panels changed
        bool tick = false;    // some seconds have gone by
    };

    /// @param card  file descriptor, outlives this
    /// @throws std::system_error
    explicit PanelWatch(int card);

    /// Readable when there are events.
    int fd() const { return all_.get(); }

    /// What has happened since the last call; does not wait.
    Events take();

  private:
    int card_;
    UniqueFd all_;
    UniqueFd timer_;
    UniqueFd kernel_;  // -1: the kernel does not tell us
};

}  // namespace vitrine
