#pragma once

#include <functional>
#include <memory>
#include <string>

struct sd_bus_message;

namespace vitrine::player {

/// Decides who may change what is on the wall.
class Authority {
  public:
    /// @param refusal  why not, in plain words; empty: allowed
    using Answer = std::function<void(const std::string& refusal)>;

    Authority() = default;
    Authority(const Authority&) = delete;
    Authority& operator=(const Authority&) = delete;
    Authority(Authority&&) = delete;
    Authority& operator=(Authority&&) = delete;
    virtual ~Authority() = default;

    /// Answers at once or later, from the event loop, and not at all once this is gone.
    /// @param call  lent; its sender is the one who asks
    virtual void ask(sd_bus_message& call, Answer answer) = 0;
};

/// polkit, asked over the bus that the call came by whether its sender may do org.vitrine.player.control.
/// Where there is no polkit, root and this process' own user may.
std::unique_ptr<Authority> polkit_authority();

}  // namespace vitrine::player
