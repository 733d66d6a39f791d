#pragma once

#include "base/system/event_loop.hpp"
#include "player/control/authority.hpp"
#include "player/control/commands.hpp"
#include "player/control/picture_answers.hpp"

#include <memory>
#include <string>

struct sd_bus;
struct sd_bus_message;
struct sd_bus_slot;

namespace vitrine::player {

/// The player on the system bus: /org/vitrine/Player1 of org.vitrine.Player1, with the methods of commands().
/// Runs in the given event loop. Without a bus, or if it is lost, it logs that once and tries again from time
/// to time.
class BusObject {
  public:
    /// @param loop      outlives this
    /// @param handlers  one for each method of commands()
    BusObject(EventLoop& loop, CommandHandlers handlers, std::unique_ptr<Authority> authority);
    BusObject(const BusObject&) = delete;
    BusObject& operator=(const BusObject&) = delete;
    BusObject(BusObject&&) = delete;
    BusObject& operator=(BusObject&&) = delete;
    ~BusObject();

    /// Answers a call: now, or later if the authority must be asked or pictures are made.
    void answer(sd_bus_message& call);

  private:
    void connect();
    void open();
    void close();
    void complain(const std::string& reason);

    struct Unref {
        void operator()(sd_bus* bus) const;
        void operator()(sd_bus_slot* slot) const;
    };

    EventLoop& loop_;  // outlives this
    CommandHandlers handlers_;
    std::unique_ptr<sd_bus, Unref> bus_;
    std::unique_ptr<sd_bus_slot, Unref> object_;
    std::unique_ptr<sd_bus_slot, Unref> gone_;
    std::unique_ptr<sd_bus_slot, Unref> named_;
    std::unique_ptr<Authority> authority_;  // uses the bus: destroyed before it, as are the pictures
    PictureAnswers pictures_;
    EventLoop::Source retry_;
    std::string complaint_;  // the complaint logged last
};

}  // namespace vitrine::player
