#pragma once

#include <functional>
#include <memory>
#include <string>

struct sd_bus_message;

namespace vitrine::player {

/// Decides who may change what is on the wall.
class Authority {
  public:
    /// @param refusal  the reason in plain words; empty: allowed
    using Answer = std::function<void(const std::string& refusal)>;

    Authority() = default;
    Authority(const Authority&) = delete;
    Authority& operator=(const Authority&) = delete;
    Authority(Authority&&) = delete;
    Authority& operator=(Authority&&) = delete;
    virtual ~Authority() = default;

    /// Answers at once or later, from the event loop; never after this is destroyed.
    /// @param call  lent; its sender is asked about
    virtual void ask(sd_bus_message& call, Answer answer) = 0;

    /// Drops all questions without an answer: the bus of their calls is gone.
    virtual void drop_questions() {}
};

/// Asks polkit, over the bus of the call, if the sender may do org.vitrine.player.control. Without polkit,
/// root and this process' own user may.
std::unique_ptr<Authority> polkit_authority();

}  // namespace vitrine::player
