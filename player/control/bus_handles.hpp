#pragma once

#include "base/system/error.hpp"
#include "base/system/handle.hpp"

#include <systemd/sd-bus.h>

#include <string>

namespace vitrine::player {

using BusHandle = Handle<sd_bus, &sd_bus_flush_close_unref>;
using MessageHandle = Handle<sd_bus_message, &sd_bus_message_unref>;
using SlotHandle = Handle<sd_bus_slot, &sd_bus_slot_unref>;

/// sd-bus returns -errno. @throws std::system_error saying what was tried
inline int bus_checked(int result, const std::string& what) {
    if (result >= 0) return result;
    errno = -result;
    throw_errno("{}", what);
}

}  // namespace vitrine::player
