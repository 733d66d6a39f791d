#pragma once

namespace vitrine::log {

/// Whether systemd reads this file descriptor into the journal: it names its stream by device and inode, so
/// that a redirected one is not mistaken for it.
bool is_journal(int fd);

}  // namespace vitrine::log
