#include "player/control/bus_object.hpp"

#include "base/system/log.hpp"
#include "player/control/bus_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto retry_pause = 10s;

int on_call(sd_bus_message* call, void* self, sd_bus_error*) {
    try {
        static_cast<BusObject*>(self)->answer(*call);
    } catch (const std::exception& error) {
        reply_error(*call, error_failed, error.what());
    }
    return 1;
}

// The macros of sd-bus are C.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wold-style-cast"

std::vector<sd_bus_vtable> vtable_of_commands() {
    std::vector<sd_bus_vtable> vtable{SD_BUS_VTABLE_START(0)};
    std::set<std::string_view> methods;
    for (const Command& command : commands())
        if (methods.insert(command.method).second)
            vtable.push_back(SD_BUS_METHOD(command.method, command.arguments, command.result, on_call,
                                           SD_BUS_VTABLE_UNPRIVILEGED));
    vtable.push_back(SD_BUS_VTABLE_END);
    return vtable;
}

#pragma GCC diagnostic pop

/// Static, because sd-bus keeps a pointer to it.
const std::vector<sd_bus_vtable>& vtable() {
    static const std::vector<sd_bus_vtable> made = vtable_of_commands();
    return made;
}

}  // namespace

void BusObject::Unref::operator()(sd_bus* bus) const {
    sd_bus_flush_close_unref(bus);
}

void BusObject::Unref::operator()(sd_bus_slot* slot) const {
    sd_bus_slot_unref(slot);
}

BusObject::BusObject(EventLoop& loop, CommandHandlers handlers, std::unique_ptr<Authority> authority)
    : loop_(loop),
      handlers_(std::move(handlers)),
      authority_(std::move(authority)),
      pictures_(loop),
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
    } catch (const std::system_error& error) {  // the wall works without the bus
        complain(error.what());
    }
}

void BusObject::open() {
    sd_bus* bus = nullptr;
    bus_checked(sd_bus_open_system(&bus), "reach the system bus");
    bus_.reset(bus);
    // Calls and pictures take turns: users who ask without end delay a picture by one answer, which takes a
    // few milliseconds at most, and on a machine that is too slow for its pictures calls are answered all the
    // same.
    bus_checked(sd_bus_attach_event(bus, loop_.get(), SD_EVENT_PRIORITY_NORMAL), "wait for the system bus");
    sd_bus_slot* slot = nullptr;
    bus_checked(sd_bus_add_object_vtable(bus, &slot, bus_path, bus_name, vtable().data(), this),
                "export the player on the system bus");
    object_.reset(slot);
    const auto on_gone = [](sd_bus_message*, void* self, sd_bus_error*) {
        auto& object = *static_cast<BusObject*>(self);
        object.complain("the system bus was lost");
        return 0;
    };
    bus_checked(sd_bus_match_signal_async(bus, &slot, "org.freedesktop.DBus.Local", nullptr,
                                          "org.freedesktop.DBus.Local", "Disconnected", on_gone, nullptr,
                                          this),
                "watch the system bus");
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
    bus_checked(sd_bus_request_name_async(bus, &slot, bus_name, 0, on_named, this),
                "take the player's name on the system bus");
    named_.reset(slot);
}

void BusObject::close() {
    authority_->drop_questions();
    pictures_.drop_calls();
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
    const std::string_view method = sd_bus_message_get_member(&call);
    const auto command = std::ranges::find(commands(), method, &Command::method);
    if (command == commands().end()) throw std::runtime_error("there is no such method");
    const CommandHandler& handler = handlers_.at(command->method);
    const auto answer_call = [this, result = command->result, &handler,
                              asked = read_call(call, command->arguments)](sd_bus_message& to) {
        try {
            CommandAnswer answer = handler(asked);
            if (answer.make_pictures) return pictures_.answer(to, std::move(answer.make_pictures));
            reply(to, [&](sd_bus_message& made) { append_answer(made, result, answer); });
        } catch (const std::exception& error) {  // the caller gets it
            reply_error(to, error_failed, error.what());
        }
    };
    if (command->is_for_all) return answer_call(call);
    // Shared: the authority's answer is a std::function, which is copied.
    const std::shared_ptr<sd_bus_message> kept(sd_bus_message_ref(&call), &sd_bus_message_unref);
    authority_->ask(call, [kept, answer_call](const std::string& refusal) {
        if (!refusal.empty()) return reply_error(*kept, SD_BUS_ERROR_ACCESS_DENIED, refusal);
        answer_call(*kept);
    });
}

}  // namespace vitrine::player
