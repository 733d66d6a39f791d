#include "player/control/authority.hpp"

#include "player/control/bus_messages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <map>
#include <utility>

namespace vitrine::player {

namespace {

constexpr const char* action = "org.vitrine.player.control";
constexpr std::uint64_t patience_us = 120'000'000;  // somebody may have to type a password

class Polkit final : public Authority {
  public:
    void ask(sd_bus_message& call, Answer answer) override {
        const std::uint64_t number = ++last_;
        Question& question = questions_[number];
        question.authority = this;
        question.number = number;
        const char* sender = sd_bus_message_get_sender(&call);
        question.sender = sender != nullptr ? sender : "";
        question.bus = sd_bus_message_get_bus(&call);
        question.answer = std::move(answer);
        const bool may_ask_back = sd_bus_message_get_allow_interactive_authorization(&call) > 0;
        try {
            ask_polkit(question, may_ask_back);
        } catch (...) {
            questions_.erase(number);
            throw;
        }
    }

    void drop_questions() override { questions_.clear(); }

  private:
    struct Question {
        Polkit* authority = nullptr;  // owns the question
        std::uint64_t number = 0;
        std::string sender;
        sd_bus* bus = nullptr;  // outlives the question
        Answer answer;
        SlotHandle slot;
    };

    void ask_polkit(Question& question, bool may_ask_back) {
        sd_bus_message* made = nullptr;
        bus_checked(sd_bus_message_new_method_call(question.bus, &made, "org.freedesktop.PolicyKit1",
                                                   "/org/freedesktop/PolicyKit1/Authority",
                                                   "org.freedesktop.PolicyKit1.Authority",
                                                   "CheckAuthorization"),
                    "ask polkit");
        const MessageHandle message(made);
        bus_checked(sd_bus_message_append(made, "(sa{sv})sa{ss}us", "system-bus-name", 1, "name", "s",
                                          question.sender.c_str(), action, 0, may_ask_back ? 1U : 0U, ""),
                    "ask polkit");
        send(question, made, &on_polkit);
    }

    /// Asks the bus for the user of the sender's process.
    static void ask_bus(Question& question) {
        sd_bus_message* made = nullptr;
        bus_checked(sd_bus_message_new_method_call(question.bus, &made, "org.freedesktop.DBus",
                                                   "/org/freedesktop/DBus", "org.freedesktop.DBus",
                                                   "GetConnectionUnixUser"),
                    "ask the bus for a user");
        const MessageHandle message(made);
        bus_checked(sd_bus_message_append(made, "s", question.sender.c_str()), "ask the bus for a user");
        send(question, made, &on_user);
    }

    static void send(Question& question, sd_bus_message* message, sd_bus_message_handler_t call) {
        sd_bus_slot* slot = nullptr;
        bus_checked(sd_bus_call_async(question.bus, &slot, message, call, &question, patience_us),
                    "ask the bus");
        question.slot.reset(slot);
    }

    static int on_polkit(sd_bus_message* reply, void* self, sd_bus_error*) {
        auto& question = *static_cast<Question*>(self);
        if (sd_bus_message_is_method_error(reply, nullptr) > 0) return guarded(question, &ask_bus);
        int is_allowed = 0;
        const int result = sd_bus_message_enter_container(reply, 'r', "bba{ss}");
        if (result <= 0 || sd_bus_message_read(reply, "b", &is_allowed) <= 0)
            question.authority->end(question, "the answer of polkit cannot be read");
        else
            question.authority->end(question, is_allowed != 0
                                                  ? ""
                                                  : "polkit does not allow it: only members of the group "
                                                    "'vitrine-admin' may change what is shown");
        return 0;
    }

    static int on_user(sd_bus_message* reply, void* self, sd_bus_error*) {
        auto& question = *static_cast<Question*>(self);
        std::uint32_t user = 0;
        const bool is_known =
            sd_bus_message_is_method_error(reply, nullptr) == 0 && sd_bus_message_read(reply, "u", &user) > 0;
        const bool is_allowed = is_known && (user == 0 || user == ::geteuid());
        question.authority->end(question, is_allowed ? ""
                                                     : "polkit is not running: only root and "
                                                       "the player's own user may change what is shown");
        return 0;
    }

    /// Keeps exceptions from sd-bus.
    static int guarded(Question& question, void (*deed)(Question&)) {
        try {
            deed(question);
        } catch (const std::exception& error) {
            question.authority->end(question, error.what());
        }
        return 0;
    }

    void end(Question& question, const std::string& refusal) {
        const auto ended = questions_.extract(question.number);
        ended.mapped().answer(refusal);
    }

    std::map<std::uint64_t, Question> questions_;  // questions that are not answered yet
    std::uint64_t last_ = 0;
};

}  // namespace

std::unique_ptr<Authority> polkit_authority() {
    return std::make_unique<Polkit>();
}

}  // namespace vitrine::player
