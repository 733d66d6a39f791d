#pragma once

#include "base/system/error.hpp"
#include "base/system/handle.hpp"
#include "player/control/commands.hpp"

#include <systemd/sd-bus.h>

#include <string>
#include <string_view>

// The calls and answers of commands as messages of sd-bus. A Command's signatures give their content.

namespace vitrine::player {

using BusHandle = Handle<sd_bus, &sd_bus_flush_close_unref>;
using MessageHandle = Handle<sd_bus_message, &sd_bus_message_unref>;
using SlotHandle = Handle<sd_bus_slot, &sd_bus_slot_unref>;

constexpr const char* bus_name = "org.vitrine.Player1";  // also the name of the interface
constexpr const char* bus_path = "/org/vitrine/Player1";

/// sd-bus returns -errno. @throws std::system_error saying what was tried
inline int bus_checked(int result, const std::string& what) {
    if (result >= 0) return result;
    errno = -result;
    throw_errno("{}", what);
}

/// All four throw std::system_error if the content does not match. read_answer() also throws
/// std::runtime_error if a picture is too large or cut off.
void append_call(sd_bus_message& message, std::string_view arguments, const CommandCall& call);
CommandCall read_call(sd_bus_message& message, std::string_view arguments);
void append_answer(sd_bus_message& message, std::string_view result, const CommandAnswer& answer);
CommandAnswer read_answer(sd_bus_message& message, std::string_view result);

}  // namespace vitrine::player
