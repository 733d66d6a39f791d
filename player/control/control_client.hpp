#pragma once

#include "player/control/commands.hpp"

#include <memory>
#include <stdexcept>
#include <string>

struct sd_bus;

namespace vitrine::player {

/// The reason why the player did not carry out a call.
class ControlError : public std::runtime_error {
  public:
    enum class Kind { failed, not_allowed, not_running };

    ControlError(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}

    Kind kind() const { return kind_; }

  private:
    Kind kind_;
};

/// Calls the player over the system bus and waits for each answer.
class ControlClient {
  public:
    /// @throws ControlError
    ControlClient();

    /// @throws ControlError
    CommandAnswer call(const Command& command, const CommandCall& call);

  private:
    struct Unref {
        void operator()(sd_bus* bus) const;
    };

    std::unique_ptr<sd_bus, Unref> bus_;
};

}  // namespace vitrine::player
