#pragma once

#include "base/system/event_loop.hpp"
#include "player/control/authority.hpp"
#include "player/display/picture.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

struct sd_bus;
struct sd_bus_message;
struct sd_bus_slot;

namespace vitrine::player {

/// What the player does when it is asked over the bus. Each may throw std::runtime_error with words for who
/// asked.
struct Controls {
    struct Shot {
        std::string output;
        Picture picture;
    };

    // what anyone may ask
    std::function<std::string()> status;                                                 // JSON
    std::function<std::string(const std::string& file, const std::string& folder)> why;  // JSON
    std::function<std::vector<Shot>()> screenshot;

    // what is for some
    std::function<void()> next;
    std::function<void(bool)> pause;
    std::function<std::string(const std::string& file, const std::string& folder, bool)>
        pin;  // what it is called
    std::function<void(int slot, bool)> pin_slot;
    std::function<std::string(const std::string& file, const std::string& folder)> remove;
    std::function<void()> reload;
};

/// The player on the system bus: /org/vitrine/Player1 of org.vitrine.Player1. Runs in the loop it is given;
/// where there is no bus, or it goes, that is logged once and tried again every now and then.
///
///     Status() -> s                    JSON
///     Why(ay file, ay folder) -> s     JSON
///     Screenshot() -> a(suuh)          output, px, px, a file with RGBA from the top
///     Next()  Pause(b)  Reload()
///     Pin(ay file, ay folder, b) -> ay     PinSlot(u, b)     Remove(ay file, ay folder) -> ay
class BusObject {
  public:
    static constexpr const char* name = "org.vitrine.Player1";
    static constexpr const char* path = "/org/vitrine/Player1";

    /// @param loop  outlives this
    BusObject(EventLoop& loop, Controls controls, std::unique_ptr<Authority> authority);
    BusObject(const BusObject&) = delete;
    BusObject& operator=(const BusObject&) = delete;
    BusObject(BusObject&&) = delete;
    BusObject& operator=(BusObject&&) = delete;
    ~BusObject();

    /// One call that has come; answers it now or, when the authority has answered, later.
    void answer(sd_bus_message& call);

  private:
    void connect();
    void open();
    void close();
    void complain(const std::string& reason);
    void change(sd_bus_message& call, const std::function<void(sd_bus_message& reply)>& deed);
    std::function<void(sd_bus_message&)> change_asked_by(sd_bus_message& call);
    void reply_pictures(sd_bus_message& reply);

    struct Unref {
        void operator()(sd_bus* bus) const;
        void operator()(sd_bus_slot* slot) const;
    };

    EventLoop& loop_;  // outlives this
    Controls controls_;
    std::unique_ptr<sd_bus, Unref> bus_;
    std::unique_ptr<sd_bus_slot, Unref> object_;
    std::unique_ptr<sd_bus_slot, Unref> gone_;
    std::unique_ptr<sd_bus_slot, Unref> named_;
    std::unique_ptr<Authority> authority_;  // has questions under way on the bus: ends before it
    EventLoop::Source retry_;
    std::string complaint_;  // as last told
};

}  // namespace vitrine::player
