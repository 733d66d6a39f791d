#include "base/system/stop_request.hpp"

#include "base/system/event_loop.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <functional>
#include <optional>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

constexpr int own_code = 3;
constexpr int late_code = 7;
constexpr auto patience = 200ms;

/// A process of its own that says by one byte that it is about to do its work, and is then asked to stop.
/// @return its exit code; none where it has not ended within half a minute
std::optional<int> code_after(int signal, const std::function<void(EventLoop&)>& work) {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
        EventLoop loop;
        {
            const StopRequest stop(loop, {.patience = patience, .exit_code = late_code},
                                   [&] { loop.quit(); });
            if (::write(ends[1], "x", 1) != 1) ::_exit(1);
            work(loop);
        }
        ::_exit(own_code);
    }
    ::close(ends[1]);
    char ready = 0;
    CHECK(::read(ends[0], &ready, 1) == 1);
    ::close(ends[0]);
    ::kill(child, signal);
    EventLoop waiting;
    int status = 0;
    for (const auto end = EventLoop::Clock::now() + 30s; EventLoop::Clock::now() < end;
         waiting.run_once(10ms))
        if (::waitpid(child, &status, WNOHANG) == child)
            return WIFEXITED(status) ? std::optional(WEXITSTATUS(status)) : std::nullopt;
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    return std::nullopt;
}

void hang() {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) ::_exit(1);
    char never = 0;
    while (::read(ends[0], &never, 1) < 0) {  // the other end is open, so it waits for ever
    }
}

}  // namespace

TEST_CASE("a program that is asked to stop ends by itself") {
    for (const int signal : {SIGTERM, SIGINT})
        CHECK(code_after(signal, [](EventLoop& loop) { loop.run(); }) == own_code);
}

TEST_CASE("a program that hangs in a call ends all the same, a little later") {
    for (const int signal : {SIGTERM, SIGINT})
        CHECK(code_after(signal, [](EventLoop&) { hang(); }) == late_code);
}

TEST_CASE("a program that hangs on its way out ends, too") {
    CHECK(code_after(SIGTERM, [](EventLoop& loop) {
              loop.run();
              hang();
          }) == late_code);
}

TEST_CASE("nothing ends a process whose stop was not asked for") {
    EventLoop loop;
    bool is_stopped = false;
    {
        const StopRequest stop(loop, {.patience = 0ms, .exit_code = late_code}, [&] { is_stopped = true; });
        loop.run_once(50ms);
    }
    CHECK_FALSE(is_stopped);
}
