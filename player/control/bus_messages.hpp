#pragma once

#include "base/system/error.hpp"
#include "base/system/handle.hpp"
#include "base/system/unique_fd.hpp"
#include "player/control/commands.hpp"

#include <systemd/sd-bus.h>

#include <cstdint>
#include <functional>
#include <span>
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

constexpr const char* error_failed = "org.vitrine.Error.Failed";

/// A picture as it goes over the bus.
struct PictureFile {
    std::string output;
    std::uint32_t width = 0;  // px
    std::uint32_t height = 0;
    UniqueFd file;  // holds the pixels in the order of Picture
};

/// @throws std::system_error if there is no room for the file
PictureFile file_of(const OutputPicture& shown);

/// Answers a call: appends with `fill`, or sends the error that it throws.
void reply(sd_bus_message& call, const std::function<void(sd_bus_message&)>& fill);

/// Answers a call with an error. @param error  its name on the bus
void reply_error(sd_bus_message& call, const char* error, const std::string& why);

/// All five throw std::system_error if the content does not match. read_answer() also throws
/// std::runtime_error if a picture is too large or cut off.
void append_call(sd_bus_message& message, std::string_view arguments, const CommandCall& call);
CommandCall read_call(sd_bus_message& message, std::string_view arguments);
void append_answer(sd_bus_message& message, std::string_view result, const CommandAnswer& answer);
void append_pictures(sd_bus_message& message, std::span<const PictureFile> pictures);
CommandAnswer read_answer(sd_bus_message& message, std::string_view result);

}  // namespace vitrine::player
