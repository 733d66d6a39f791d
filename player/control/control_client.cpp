#include "player/control/control_client.hpp"

#include "player/control/bus_handles.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>

namespace vitrine::player {

namespace {

constexpr const char* player = "org.vitrine.Player1";
constexpr const char* object = "/org/vitrine/Player1";
constexpr std::uint64_t patience_us = 150'000'000;  // somebody may have to type a password
constexpr std::uint32_t longest_side = 32768;       // px

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

int checked(int result) {
    if (result < 0) throw ControlError(ControlError::Kind::failed, std::strerror(-result));
    return result;
}

std::string read_bytes(sd_bus_message* reply) {
    const void* bytes = nullptr;
    std::size_t size = 0;
    checked(sd_bus_message_read_array(reply, 'y', &bytes, &size));
    return {static_cast<const char*>(bytes), size};
}

std::string read_text(sd_bus_message* reply) {
    const char* text = nullptr;
    checked(sd_bus_message_read(reply, "s", &text));
    return text;
}

Picture read_picture(int file, std::uint32_t width, std::uint32_t height) {
    if (width > longest_side || height > longest_side)
        throw ControlError(ControlError::Kind::failed, "the player gave a picture that makes no sense");
    Picture picture{.width = static_cast<int>(width), .height = static_cast<int>(height), .pixels = {}};
    picture.pixels.resize(std::size_t{width} * height * 4);
    for (std::size_t done = 0; done < picture.pixels.size();) {
        const std::span<std::byte> left = std::span(picture.pixels).subspan(done);
        const ssize_t n = ::pread(file, left.data(), left.size(), static_cast<off_t>(done));
        if (n <= 0) throw ControlError(ControlError::Kind::failed, "the player gave a part of a picture");
        done += static_cast<std::size_t>(n);
    }
    return picture;
}

}  // namespace

class ControlClient::Call {
  public:
    Call(ControlClient& client, const char* method) : bus_(client.bus_.get()) {
        sd_bus_message* made = nullptr;
        checked(sd_bus_message_new_method_call(bus_, &made, player, object, player, method));
        message_.reset(made);
        checked(sd_bus_message_set_allow_interactive_authorization(made, ::isatty(STDIN_FILENO)));
    }

    Call& bytes(const std::string& text) {
        checked(sd_bus_message_append_array(message_.get(), 'y', text.data(), text.size()));
        return *this;
    }

    /// A file, and where it was named.
    Call& file(const std::string& name) {
        return bytes(name).bytes(std::filesystem::current_path().string());
    }

    Call& flag(bool is_on) {
        checked(sd_bus_message_append(message_.get(), "b", is_on ? 1 : 0));
        return *this;
    }

    Call& number(unsigned value) {
        checked(sd_bus_message_append(message_.get(), "u", value));
        return *this;
    }

    MessageHandle answer() {
        Error error;
        sd_bus_message* reply = nullptr;
        const int result = sd_bus_call(bus_, message_.get(), patience_us, error.get(), &reply);
        if (result < 0) error.raise(result);
        return MessageHandle(reply);
    }

  private:
    sd_bus* bus_;  // outlives this
    MessageHandle message_;
};

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

std::string ControlClient::status() {
    return read_text(Call(*this, "Status").answer().get());
}

std::string ControlClient::why(const std::string& file) {
    return read_text(Call(*this, "Why").file(file).answer().get());
}

std::vector<ControlClient::Shot> ControlClient::screenshot() {
    const MessageHandle reply = Call(*this, "Screenshot").answer();
    std::vector<Shot> shots;
    checked(sd_bus_message_enter_container(reply.get(), 'a', "(suuh)"));
    const char* output = nullptr;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int file = -1;
    while (checked(sd_bus_message_read(reply.get(), "(suuh)", &output, &width, &height, &file)) > 0)
        shots.push_back({.output = output, .picture = read_picture(file, width, height)});
    return shots;
}

void ControlClient::next() {
    Call(*this, "Next").answer();
}

void ControlClient::pause(bool is_on) {
    Call(*this, "Pause").flag(is_on).answer();
}

std::string ControlClient::pin(const std::string& file, bool is_on) {
    return read_bytes(Call(*this, "Pin").file(file).flag(is_on).answer().get());
}

void ControlClient::pin_slot(unsigned slot, bool is_on) {
    Call(*this, "PinSlot").number(slot).flag(is_on).answer();
}

std::string ControlClient::remove(const std::string& file) {
    return read_bytes(Call(*this, "Remove").file(file).answer().get());
}

void ControlClient::reload() {
    Call(*this, "Reload").answer();
}

}  // namespace vitrine::player
