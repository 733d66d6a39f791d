#include "player/control/bus_object.hpp"

#include "base/system/log.hpp"
#include "base/system/unique_fd.hpp"
#include "player/control/bus_handles.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <exception>
#include <span>
#include <string_view>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto retry_pause = 10s;
constexpr const char* failed = "org.vitrine.Error.Failed";

std::string read_bytes(sd_bus_message& call) {
    const void* bytes = nullptr;
    std::size_t size = 0;
    bus_checked(sd_bus_message_read_array(&call, 'y', &bytes, &size), "read a name");
    return {static_cast<const char*>(bytes), size};
}

bool read_flag(sd_bus_message& call) {
    int flag = 0;
    bus_checked(sd_bus_message_read(&call, "b", &flag), "read a flag");
    return flag != 0;
}

void append_bytes(sd_bus_message& reply, const std::string& bytes) {
    bus_checked(sd_bus_message_append_array(&reply, 'y', bytes.data(), bytes.size()), "answer a name");
}

void append_text(sd_bus_message& reply, const std::string& text) {
    bus_checked(sd_bus_message_append(&reply, "s", text.c_str()), "answer");
}

void reply_error(sd_bus_message& call, const char* error, const std::string& why) {
    if (sd_bus_reply_method_errorf(&call, error, "%s", why.c_str()) >= 0) return;
    std::string plain = why;  // the bus takes only UTF-8, which names need not be
    std::ranges::replace_if(
        plain, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
    if (sd_bus_reply_method_errorf(&call, error, "%s", plain.c_str()) < 0)
        log::debug("nobody waits for: {}", why);
}

/// Answers a call with what `fill` appends, or with what it throws.
void reply(sd_bus_message& call, const std::function<void(sd_bus_message&)>& fill) {
    try {
        sd_bus_message* made = nullptr;
        bus_checked(sd_bus_message_new_method_return(&call, &made), "make an answer");
        const MessageHandle message(made);
        fill(*made);
        bus_checked(sd_bus_send(nullptr, made, nullptr), "answer");
    } catch (const std::exception& error) {  // goes to who asked
        reply_error(call, failed, error.what());
    }
}

UniqueFd file_of(const Picture& picture) {
    UniqueFd file(::memfd_create("picture", MFD_CLOEXEC));
    if (!file.is_open()) throw_errno("make a file for a picture");
    for (std::span<const std::byte> left = picture.pixels; !left.empty();) {
        const ssize_t n = ::write(file.get(), left.data(), left.size());
        if (n < 0) throw_errno("write a picture");
        left = left.subspan(static_cast<std::size_t>(n));
    }
    return file;
}

int on_call(sd_bus_message* call, void* self, sd_bus_error*) {
    try {
        static_cast<BusObject*>(self)->answer(*call);
    } catch (const std::exception& error) {
        reply_error(*call, failed, error.what());
    }
    return 1;
}

// The macros of sd-bus are C.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wold-style-cast"
constexpr std::uint64_t open_to_all = SD_BUS_VTABLE_UNPRIVILEGED;
const std::array<sd_bus_vtable, 11> methods{{
    SD_BUS_VTABLE_START(0),
    SD_BUS_METHOD("Status", "", "s", on_call, open_to_all),
    SD_BUS_METHOD("Why", "ayay", "s", on_call, open_to_all),
    SD_BUS_METHOD("Screenshot", "", "a(suuh)", on_call, open_to_all),
    SD_BUS_METHOD("Next", "", "", on_call, open_to_all),
    SD_BUS_METHOD("Pause", "b", "", on_call, open_to_all),
    SD_BUS_METHOD("Pin", "ayayb", "ay", on_call, open_to_all),
    SD_BUS_METHOD("PinSlot", "ub", "", on_call, open_to_all),
    SD_BUS_METHOD("Remove", "ayay", "ay", on_call, open_to_all),
    SD_BUS_METHOD("Reload", "", "", on_call, open_to_all),
    SD_BUS_VTABLE_END,
}};
#pragma GCC diagnostic pop

}  // namespace

void BusObject::Unref::operator()(sd_bus* bus) const {
    sd_bus_flush_close_unref(bus);
}

void BusObject::Unref::operator()(sd_bus_slot* slot) const {
    sd_bus_slot_unref(slot);
}

BusObject::BusObject(EventLoop& loop, Controls controls, std::unique_ptr<Authority> authority)
    : loop_(loop),
      controls_(std::move(controls)),
      authority_(std::move(authority)),
      retry_(loop.timer([this] { connect(); })) {
    connect();
}

BusObject::~BusObject() {
    close();
}

void BusObject::connect() {
    close();
    try {
        open();
    } catch (const std::system_error& error) {  // the wall needs no bus
        complain(error.what());
    }
}

void BusObject::open() {
    sd_bus* bus = nullptr;
    bus_checked(sd_bus_open_system(&bus), "reach the system bus");
    bus_.reset(bus);
    // All that was asked is answered before another picture, which on a slow machine takes its time.
    bus_checked(sd_bus_attach_event(bus, loop_.get(), SD_EVENT_PRIORITY_IMPORTANT),
                "wait for the system bus");
    sd_bus_slot* slot = nullptr;
    bus_checked(sd_bus_add_object_vtable(bus, &slot, path, name, methods.data(), this),
                "be on the system bus");
    object_.reset(slot);
    const auto on_gone = [](sd_bus_message*, void* self, sd_bus_error*) {
        auto& object = *static_cast<BusObject*>(self);
        object.complain("the system bus has gone");
        return 0;
    };
    bus_checked(sd_bus_match_signal_async(bus, &slot, "org.freedesktop.DBus.Local", nullptr,
                                          "org.freedesktop.DBus.Local", "Disconnected", on_gone, nullptr,
                                          this),
                "follow the system bus");
    gone_.reset(slot);
    const auto on_named = [](sd_bus_message* reply, void* self, sd_bus_error*) {
        auto& object = *static_cast<BusObject*>(self);
        const sd_bus_error* error = sd_bus_message_get_error(reply);
        if (error != nullptr)
            object.complain(error->message != nullptr ? error->message : error->name);
        else
            object.complaint_.clear();
        return 0;
    };
    bus_checked(sd_bus_request_name_async(bus, &slot, name, 0, on_named, this),
                "have a name on the system bus");
    named_.reset(slot);
}

void BusObject::close() {
    named_.reset();
    gone_.reset();
    object_.reset();
    if (bus_) sd_bus_detach_event(bus_.get());
    bus_.reset();
}

void BusObject::complain(const std::string& reason) {
    if (complaint_ != reason) log::warning("vitrinectl cannot reach the player: {}", reason);
    complaint_ = reason;
    retry_.arm(retry_pause);
}

void BusObject::answer(sd_bus_message& call) {
    const std::string_view asked = sd_bus_message_get_member(&call);
    if (asked == "Status") {
        reply(call, [&](sd_bus_message& made) { append_text(made, controls_.status()); });
    } else if (asked == "Why") {
        const std::string file = read_bytes(call);
        const std::string folder = read_bytes(call);
        reply(call, [&](sd_bus_message& made) { append_text(made, controls_.why(file, folder)); });
    } else if (asked == "Screenshot") {
        reply(call, [&](sd_bus_message& made) { reply_pictures(made); });
    } else {
        change(call, change_asked_by(call));
    }
}

/// What is to be done once it is allowed.
std::function<void(sd_bus_message&)> BusObject::change_asked_by(sd_bus_message& call) {
    const std::string_view asked = sd_bus_message_get_member(&call);
    if (asked == "Next") return [this](sd_bus_message&) { controls_.next(); };
    if (asked == "Reload") return [this](sd_bus_message&) { controls_.reload(); };
    if (asked == "Pause") return [this, is_on = read_flag(call)](sd_bus_message&) { controls_.pause(is_on); };
    if (asked == "PinSlot") {
        std::uint32_t slot = 0;
        bus_checked(sd_bus_message_read(&call, "u", &slot), "read a number");
        const bool is_on = read_flag(call);
        return [this, slot, is_on](sd_bus_message&) { controls_.pin_slot(static_cast<int>(slot), is_on); };
    }
    const std::string file = read_bytes(call);
    const std::string folder = read_bytes(call);
    if (asked == "Remove")
        return [=, this](sd_bus_message& made) { append_bytes(made, controls_.remove(file, folder)); };
    const bool is_on = read_flag(call);
    return [=, this](sd_bus_message& made) { append_bytes(made, controls_.pin(file, folder, is_on)); };
}

void BusObject::change(sd_bus_message& call, const std::function<void(sd_bus_message&)>& deed) {
    // Shared: the answer is a std::function, which is copied.
    const std::shared_ptr<sd_bus_message> kept(sd_bus_message_ref(&call), &sd_bus_message_unref);
    authority_->ask(call, [kept, deed](const std::string& refusal) {
        if (!refusal.empty()) return reply_error(*kept, SD_BUS_ERROR_ACCESS_DENIED, refusal);
        reply(*kept, deed);
    });
}

void BusObject::reply_pictures(sd_bus_message& reply) {
    bus_checked(sd_bus_message_open_container(&reply, 'a', "(suuh)"), "answer pictures");
    for (const Controls::Shot& shot : controls_.screenshot()) {
        const UniqueFd file = file_of(shot.picture);
        bus_checked(sd_bus_message_append(&reply, "(suuh)", shot.output.c_str(),
                                          static_cast<std::uint32_t>(shot.picture.width),
                                          static_cast<std::uint32_t>(shot.picture.height), file.get()),
                    "answer a picture");
    }
    bus_checked(sd_bus_message_close_container(&reply), "answer pictures");
}

}  // namespace vitrine::player
