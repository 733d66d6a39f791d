#pragma once

namespace vitrine::log {

/// True if systemd reads this file descriptor into the journal. systemd names its stream by device and inode,
/// so that a redirected descriptor is not mistaken for it.
bool is_journal(int fd);

}  // namespace vitrine::log
