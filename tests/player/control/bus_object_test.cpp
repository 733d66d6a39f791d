#include "player/control/bus_object.hpp"

#include "base/system/unique_fd.hpp"
#include "player/control/bus_messages.hpp"
#include "player/control/control_client.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// A bus of the test's own, which takes the system bus' place.
class PrivateBus {
  public:
    PrivateBus() : address_("unix:path=" + (directory_.path / "bus").string()) {
        ::setenv("DBUS_SYSTEM_BUS_ADDRESS", address_.c_str(), 1);
    }

    ~PrivateBus() { stop(); }

    PrivateBus(const PrivateBus&) = delete;
    PrivateBus& operator=(const PrivateBus&) = delete;
    PrivateBus(PrivateBus&&) = delete;
    PrivateBus& operator=(PrivateBus&&) = delete;

    /// Starts the bus and waits until it takes connections. It writes its address then.
    void start() {
        const std::string option = "--address=" + address_;
        std::array<int, 2> pipe{};
        REQUIRE(::pipe2(pipe.data(), O_CLOEXEC) == 0);
        const UniqueFd written(pipe[0]);
        UniqueFd output(pipe[1]);
        daemon_ = ::fork();
        if (daemon_ == 0) {
            ::prctl(PR_SET_PDEATHSIG, SIGKILL);
            ::dup2(output.get(), STDOUT_FILENO);
            ::execlp("dbus-daemon", "dbus-daemon", "--session", "--nofork", "--nopidfile", "--print-address",
                     option.c_str(), nullptr);
            ::_exit(127);
        }
        output.reset();
        char first = 0;
        REQUIRE_MESSAGE(::read(written.get(), &first, 1) == 1, "dbus-daemon does not start");
    }

    void stop() {
        if (daemon_ <= 0) return;
        ::kill(daemon_, SIGKILL);
        ::waitpid(daemon_, nullptr, 0);
        daemon_ = -1;
    }

  private:
    TemporaryDirectory directory_;
    std::string address_;
    pid_t daemon_ = -1;
};

/// The line of the table with this D-Bus method.
const Command& method(std::string_view name) {
    return *std::ranges::find(commands(), name, &Command::method);
}

std::string text(ControlClient& client, std::string_view name, const CommandCall& call = {}) {
    return client.call(method(name), call).text;
}

/// Says what it is told to say, as soon as the loop runs again.
class FakeAuthority final : public Authority {
  public:
    FakeAuthority(EventLoop& loop, const std::string& refusal) : loop_(loop), refusal_(refusal) {}

    void ask(sd_bus_message&, Answer answer) override {
        later_ = loop_.defer([this, answer = std::move(answer)] { answer(refusal_); });
    }

  private:
    EventLoop& loop_;
    const std::string& refusal_;
    EventLoop::Source later_;
};

/// A player that only writes down what it is asked.
struct Asked {
    EventLoop loop{};
    std::string refusal{};
    std::vector<std::string> changes{};
    std::function<void()> on_status{};
    std::function<void()> on_pictures{};  // called in the thread that makes them
    std::optional<BusObject> object{};

    CommandHandlers handlers() {
        const auto note = [this](const std::string& change) {
            changes.push_back(change);
            return CommandAnswer{};
        };
        const auto pictures = [this](const CommandCall&) {
            const auto make = [call = on_pictures] {
                if (call) call();
                return std::vector<OutputPicture>{
                    {.output = "HDMI-A-1",
                     .picture = {.width = 2, .height = 1, .pixels = std::vector<std::byte>(8, std::byte{7})}},
                    {.output = "HDMI-A-2", .picture = {.width = 0, .height = 0, .pixels = {}}}};
            };
            return CommandAnswer{.text = {}, .pictures = {}, .make_pictures = make};
        };
        const auto why = [](const CommandCall& call) {
            return CommandAnswer{.text = call.file == "a\xff\n.jpg" ? "why not" : "of what?", .pictures = {}};
        };
        const auto pin = [=](const CommandCall& call) {
            note((call.is_on ? "pin " : "unpin ") + call.file);
            return CommandAnswer{.text = "called " + call.file, .pictures = {}};
        };
        const auto remove = [](const CommandCall& call) -> CommandAnswer {
            throw std::runtime_error("there is no '" + call.file + "'");
        };
        const auto layout = [=](const CommandCall& call) {
            note("layout " + call.file);
            return CommandAnswer{.text = call.file, .pictures = {}};
        };
        return {{"SaveLayout", layout},
                {"LoadLayout", layout},
                {"ForgetLayout", layout},
                {"Layouts", [](const CommandCall&) { return CommandAnswer{.text = "[]", .pictures = {}}; }},
                {"Status",
                 [this](const CommandCall&) {
                     if (on_status) on_status();
                     return CommandAnswer{.text = R"({"state": "showing"})", .pictures = {}};
                 }},
                {"Why", why},
                {"Screenshot", pictures},
                {"Next", [=](const CommandCall&) { return note("next"); }},
                {"Pause", [=](const CommandCall& call) { return note(call.is_on ? "pause" : "resume"); }},
                {"Pin", pin},
                {"PinSlot",
                 [=](const CommandCall& call) { return note("pin slot " + std::to_string(call.slot)); }},
                {"Remove", remove},
                {"Acquit", [=](const CommandCall& call) { return note("acquit " + call.file); }},
                {"Canvas", [=](const CommandCall&) { return note("canvas"); }},
                {"Reload", [=](const CommandCall&) { return note("reload"); }}};
    }

    void start() { object.emplace(loop, handlers(), std::make_unique<FakeAuthority>(loop, refusal)); }

    /// Serves while a client asks in a thread of its own; the client's error comes out here.
    void serve(const std::function<void(ControlClient&)>& ask) {
        std::future<void> asking = std::async(std::launch::async, [&] {
            ControlClient client;
            ask(client);
        });
        while (asking.wait_for(0s) != std::future_status::ready)
            loop.run_once(10ms);
        asking.get();
    }

    /// Until the name is on the bus.
    void settle() {
        for (int tries = 0; tries < 1000; ++tries) {
            try {
                return serve([](ControlClient& client) { text(client, "Status"); });
            } catch (const ControlError&) {
                loop.run_once(10ms);
            }
        }
        FAIL("the object does not come onto the bus");
    }
};

}  // namespace

TEST_CASE("each command has a help, and each method of it one signature") {
    std::map<std::string_view, std::string_view> signatures;
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        CHECK(signatures.try_emplace(command.method, command.arguments).first->second == command.arguments);
        CHECK((*command.help != '\0' || command.operand == Operand::slot));
        CHECK((std::string_view(command.result) != "ay" || *command.done != '\0'));
    }
}

TEST_CASE("anyone may ask: what is shown, why, and what it looks like") {
    PrivateBus bus;
    bus.start();
    Asked asked;
    asked.refusal = "never";
    asked.start();
    asked.settle();
    asked.serve([](ControlClient& client) {
        CHECK(text(client, "Status") == R"({"state": "showing"})");
        CHECK(text(client, "Why", {.file = "a\xff\n.jpg"}) == "why not");
        const auto shots = client.call(method("Screenshot"), {}).pictures;
        REQUIRE(shots.size() == 2);
        CHECK(shots[0].output == "HDMI-A-1");
        CHECK(shots[0].picture.width == 2);
        CHECK(shots[0].picture.pixels == std::vector<std::byte>(8, std::byte{7}));
    });
    CHECK(asked.changes.empty());
}

TEST_CASE("while pictures are made, others are answered") {
    PrivateBus bus;
    bus.start();
    Asked asked;
    asked.start();
    asked.settle();
    std::promise<void> begun, answered;
    bool is_in_time = false;
    asked.on_pictures = [&] {
        begun.set_value();
        is_in_time = answered.get_future().wait_for(10s) == std::future_status::ready;
    };
    asked.serve([&](ControlClient& client) {
        const auto pictures = std::async(std::launch::async, [] {
            return ControlClient().call(method("Screenshot"), {}).pictures.size();
        });
        begun.get_future().wait();
        CHECK(text(client, "Status") == R"({"state": "showing"})");
        answered.set_value();
        pictures.wait();
    });
    CHECK(is_in_time);
}

TEST_CASE("pictures that cannot be made are an error, and those whose bus is gone are dropped") {
    PrivateBus bus;
    bus.start();
    Asked asked;
    asked.start();
    asked.settle();
    const auto ask = [](ControlClient& client) { client.call(method("Screenshot"), {}); };
    asked.on_pictures = [] { throw std::runtime_error("no room for pictures"); };
    CHECK_THROWS_WITH_AS(asked.serve(ask), "no room for pictures", ControlError);
    asked.on_pictures = [&] { bus.stop(); };
    CHECK_THROWS_AS(asked.serve(ask), ControlError);
    for (int i = 0; i < 20; ++i)
        asked.loop.run_once(10ms);
}

TEST_CASE("what is allowed is done, with its words") {
    PrivateBus bus;
    bus.start();
    Asked asked;
    asked.start();
    asked.settle();
    asked.serve([](ControlClient& client) {
        text(client, "Next");
        text(client, "Pause", {.is_on = true});
        text(client, "Pause", {.is_on = false});
        text(client, "PinSlot", {.slot = 3});
        CHECK(text(client, "Pin", {.file = "a.jpg", .is_on = false}) == "called a.jpg");
        CHECK(text(client, "SaveLayout", {.file = "summer"}) == "summer");
        CHECK(text(client, "Layouts") == "[]");
        text(client, "Reload");
    });
    CHECK(asked.changes == std::vector<std::string>{"next", "pause", "resume", "pin slot 3", "unpin a.jpg",
                                                    "layout summer", "reload"});
    CHECK_THROWS_WITH_AS(
        asked.serve([](ControlClient& client) { text(client, "Remove", {.file = "b.jpg"}); }),
        "there is no 'b.jpg'", ControlError);
    CHECK_THROWS_WITH_AS(
        asked.serve([](ControlClient& client) { text(client, "Remove", {.file = "\xff.jpg"}); }),
        "there is no '?.jpg'", ControlError);
}

TEST_CASE("what is refused is not done, and who asked is told why") {
    PrivateBus bus;
    bus.start();
    Asked asked;
    asked.refusal = "only the night watch may";
    asked.start();
    asked.settle();
    for (const Command& command : commands()) {
        if (command.is_for_all) continue;
        try {
            asked.serve([&](ControlClient& client) { client.call(command, {.file = "a"}); });
            FAIL("it was done");
        } catch (const ControlError& error) {
            CHECK(error.kind() == ControlError::Kind::not_allowed);
            CHECK(error.what() == std::string("not allowed: only the night watch may"));
        }
    }
    CHECK(asked.changes.empty());
}

TEST_CASE("without polkit root and the player's own user may") {
    PrivateBus bus;
    bus.start();
    Asked asked;
    asked.object.emplace(asked.loop, asked.handlers(), polkit_authority());
    asked.settle();
    asked.serve([](ControlClient& client) { text(client, "Next"); });
    CHECK(asked.changes == std::vector<std::string>{"next"});
}

TEST_CASE("without a bus the player goes on; a client is told that it is not there") {
    PrivateBus bus;  // not started
    Asked asked;
    asked.start();
    asked.loop.run_once(10ms);
    try {
        ControlClient();
        FAIL("there is a bus");
    } catch (const ControlError& error) {
        CHECK(error.kind() == ControlError::Kind::not_running);
    }
}

TEST_CASE("a bus without the player says that the player is not running") {
    PrivateBus bus;
    bus.start();
    try {
        ControlClient client;
        text(client, "Status");
        FAIL("there is a player");
    } catch (const ControlError& error) {
        CHECK(error.kind() == ControlError::Kind::not_running);
    }
}

TEST_CASE("a bus that goes takes nothing with it") {
    PrivateBus bus;
    bus.start();
    Asked asked;
    asked.start();
    asked.settle();
    bus.stop();
    for (int i = 0; i < 20; ++i)
        asked.loop.run_once(10ms);
    CHECK(asked.changes.empty());
}

TEST_CASE("a hundred users who ask without end keep a picture waiting for two or three answers") {
    PrivateBus bus;
    bus.start();
    Asked asked;
    asked.start();
    asked.settle();
    std::atomic<bool> is_over = false;
    std::atomic<int> answered = 0;
    std::vector<std::thread> users;
    for (int i = 0; i < 100; ++i)
        users.emplace_back([&] {
            try {
                for (ControlClient client; !is_over;) {
                    text(client, "Status");
                    ++answered;
                }
            } catch (const ControlError&) {  // the bus takes so many clients and no more
            }
        });
    int pictures = 0, most = 0, since_due = 0;
    EventLoop::Clock::time_point due;
    asked.on_status = [&] {
        const auto begin = EventLoop::Clock::now();
        if (begin > due) ++since_due;
        while (EventLoop::Clock::now() < begin + 2ms) {  // longer than a timer is late
        }
    };
    EventLoop::Source tick = asked.loop.timer([&] {
        if (answered > 200) most = std::max(most, since_due);
        if (answered > 200) ++pictures;
        since_due = 0;
        due = EventLoop::Clock::now() + 5ms;
        tick.arm(5ms);
    });
    due = EventLoop::Clock::now();
    tick.arm(0s);
    const auto end = EventLoop::Clock::now() + 60s;
    while (pictures < 60 && EventLoop::Clock::now() < end)
        asked.loop.run_once(100ms);
    is_over = true;
    std::future<void> ending = std::async(std::launch::async, [&] {
        for (std::thread& user : users)
            user.join();
    });
    while (ending.wait_for(0s) != std::future_status::ready)
        asked.loop.run_once(10ms);
    CHECK(pictures >= 60);
    CHECK(most <= 3);
}

namespace {

/// A call on a bus, as a player would get it from a user.
struct UserCall {
    UserCall() {
        REQUIRE(sd_bus_open_system(&bus) >= 0);
        REQUIRE(sd_bus_message_new_method_call(bus, &message, bus_name, bus_path, bus_name, "Next") >= 0);
        REQUIRE(sd_bus_message_set_sender(message, ":1.99") >= 0);
    }

    UserCall(const UserCall&) = delete;
    UserCall& operator=(const UserCall&) = delete;

    ~UserCall() {
        sd_bus_message_unref(message);
        sd_bus_flush_close_unref(bus);
    }

    sd_bus* bus = nullptr;
    sd_bus_message* message = nullptr;
};

}  // namespace

TEST_CASE("a question that cannot be asked, or whose bus is gone, is forgotten") {
    PrivateBus bus;
    bus.start();
    const auto held = std::make_shared<int>(0);
    const std::unique_ptr<Authority> authority = polkit_authority();
    UserCall call;
    authority->ask(*call.message, [held](const std::string&) {});
    CHECK(held.use_count() == 2);
    authority->drop_questions();
    CHECK(held.use_count() == 1);

    UserCall late;
    sd_bus_close(late.bus);
    CHECK_THROWS_AS(authority->ask(*late.message, [held](const std::string&) {}), std::system_error);
    CHECK(held.use_count() == 1);
}
