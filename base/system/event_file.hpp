#pragma once

#include "base/system/error.hpp"
#include "base/system/unique_fd.hpp"

#include <sys/eventfd.h>

// A file that is readable after one thread has rung, until another one, whose loop waits for it, quiets it.

namespace vitrine {

/// @throws std::system_error without a descriptor to be had
inline UniqueFd event_file() {
    UniqueFd file(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
    if (!file.is_open()) throw_errno("make an event file");
    return file;
}

/// Thread-safe. @param file  of an event_file()
inline void ring(int file) {
    ::eventfd_write(file, 1);  // fails only where it is readable anyway
}

inline void quiet(int file) {
    eventfd_t count = 0;
    ::eventfd_read(file, &count);  // nothing to read is quiet, too
}

}  // namespace vitrine
