#include "base/system/event_loop.hpp"

#include "base/system/unique_fd.hpp"

#include <doctest/doctest.h>
#include <sys/epoll.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <string>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

struct Pipe {
    Pipe() {
        std::array<int, 2> ends{};
        REQUIRE(::pipe(ends.data()) == 0);
        read.reset(ends[0]);
        write.reset(ends[1]);
    }

    UniqueFd read, write;
};

}  // namespace

TEST_CASE("a descriptor that can be read calls back until its source is gone") {
    EventLoop loop;
    const Pipe pipe;
    int calls = 0;
    EventLoop::Source source = loop.watch(pipe.read.get(), EPOLLIN, [&](std::uint32_t events) {
        CHECK((events & EPOLLIN) != 0);
        ++calls;
    });
    CHECK_FALSE(loop.run_once(0s));
    REQUIRE(::write(pipe.write.get(), "x", 1) == 1);
    CHECK(loop.run_once(10s));
    CHECK(loop.run_once(10s));
    CHECK(calls == 2);

    source = {};
    CHECK_FALSE(loop.run_once(0s));
    CHECK(calls == 2);
}

TEST_CASE("timers call once each time they are armed, in the order of their times") {
    EventLoop loop;
    std::string order;
    EventLoop::Source late = loop.timer([&] {
        order += 'l';
        loop.quit();
    });
    EventLoop::Source soon = loop.timer([&] { order += 's'; });
    EventLoop::Source never = loop.timer([&] { order += 'n'; });
    late.arm(20ms);
    soon.arm(1ms);
    never.arm(2ms);
    never.disarm();
    loop.run();
    CHECK(order == "sl");
}

TEST_CASE("a signal is taken in turn like any event") {
    EventLoop loop;
    int calls = 0;
    const EventLoop::Source source = loop.signal(SIGUSR1, [&] {
        ++calls;
        loop.quit();
    });
    ::kill(::getpid(), SIGUSR1);
    CHECK(calls == 0);
    loop.run();
    CHECK(calls == 1);
}

TEST_CASE("what a callback throws comes out of run, not through the library") {
    EventLoop loop;
    const EventLoop::Source source = loop.defer([] { throw std::runtime_error("the disk is on fire"); });
    CHECK_THROWS_WITH(loop.run(), "the disk is on fire");
}

TEST_CASE("a callback may end its own source and use what it captured afterwards") {
    EventLoop loop;
    EventLoop::Source source;
    std::string told;
    source =
        loop.timer([&, word = std::string("a word that is too long to stay inside the function itself")] {
            source = {};
            told = word;
            loop.quit();
        });
    source.arm(0s);
    loop.run();
    CHECK(told.size() > 20);
}
