#include "player/control/control_client.hpp"

#include "player/control/bus_messages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <string_view>

namespace vitrine::player {

namespace {

constexpr std::uint64_t patience_us = 150'000'000;  // somebody may have to type a password

class Error {
  public:
    Error() = default;
    Error(const Error&) = delete;
    Error& operator=(const Error&) = delete;
    Error(Error&&) = delete;
    Error& operator=(Error&&) = delete;

    ~Error() { sd_bus_error_free(&error_); }

    sd_bus_error* get() { return &error_; }

    [[noreturn]] void raise(int result) const {
        using Kind = ControlError::Kind;
        const std::string_view name = error_.name != nullptr ? error_.name : "";
        const std::string text = error_.message != nullptr ? error_.message : std::strerror(-result);
        for (const char* gone : {SD_BUS_ERROR_SERVICE_UNKNOWN, SD_BUS_ERROR_NAME_HAS_NO_OWNER,
                                 SD_BUS_ERROR_NO_REPLY, SD_BUS_ERROR_DISCONNECTED})
            if (name == gone)
                throw ControlError(
                    Kind::not_running,
                    "the player is not running, or not on the system bus (systemctl status vitrine-player)");
        if (name == SD_BUS_ERROR_ACCESS_DENIED) throw ControlError(Kind::not_allowed, "not allowed: " + text);
        throw ControlError(Kind::failed, text);
    }

  private:
    sd_bus_error error_{};
};

/// Makes the message of a call; polkit may ask a person at a terminal for a password.
MessageHandle message_of(sd_bus* bus, const Command& command, const CommandCall& call) {
    sd_bus_message* made = nullptr;
    bus_checked(sd_bus_message_new_method_call(bus, &made, bus_name, bus_path, bus_name, command.method),
                "make a call");
    MessageHandle message(made);
    bus_checked(sd_bus_message_set_allow_interactive_authorization(made, ::isatty(STDIN_FILENO)),
                "make a call");
    append_call(*made, command.arguments, call);
    return message;
}

}  // namespace

void ControlClient::Unref::operator()(sd_bus* bus) const {
    sd_bus_flush_close_unref(bus);
}

ControlClient::ControlClient() {
    sd_bus* bus = nullptr;
    const int result = sd_bus_open_system(&bus);
    if (result < 0)
        throw ControlError(ControlError::Kind::not_running,
                           fmt::format("the system bus cannot be reached: {}", std::strerror(-result)));
    bus_.reset(bus);
}

CommandAnswer ControlClient::call(const Command& command, const CommandCall& call) {
    try {
        const MessageHandle message = message_of(bus_.get(), command, call);
        Error error;
        sd_bus_message* made = nullptr;
        const int result = sd_bus_call(bus_.get(), message.get(), patience_us, error.get(), &made);
        if (result < 0) error.raise(result);
        const MessageHandle answer(made);
        return read_answer(*made, command.result);
    } catch (const ControlError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw ControlError(ControlError::Kind::failed, error.what());
    }
}

}  // namespace vitrine::player
