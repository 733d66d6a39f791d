#include "base/wall/broken_line.hpp"
#include "base/wall/line_caller.hpp"
#include "base/wall/line_listener.hpp"
#include "base/wall/unix_address.hpp"
#include "base/wall/wall_message.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

/// A listener that answers each line with the same line, as the link's end, and a caller, as the player's.
struct Ends {
    Ends() { listen(); }

    void listen() {
        listener.emplace(
            loop, folder.path / "link.sock",
            LineListener::Handlers{
                .begin = [this](LineListener::Id) { ++begun; },
                .line =
                    [this](LineListener::Id id, const std::string& line) {
                        if (line == "broken") throw BrokenLine("it is broken");
                        ++heard;
                        if (answers) listener->send(id, line);
                    },
                .end = [this](LineListener::Id, const std::string& why) { ends.push_back(why); }});
    }

    LineCaller caller() {
        return LineCaller(loop, folder.path / "link.sock",
                          {.begin = [this] { ++connected; },
                           .line = [this](const std::string& line) { lines.push_back(line); },
                           .end = [this](const std::string& why) { losses.push_back(why); }},
                          5ms);
    }

    /// Runs the loop until this holds. @return false: it did not within seconds
    bool comes(const std::function<bool()>& holds) {
        const auto end = std::chrono::steady_clock::now() + 20s;
        while (!holds()) {
            if (std::chrono::steady_clock::now() > end) return false;
            loop.run_once(20ms);
        }
        return true;
    }

    TemporaryDirectory folder;
    EventLoop loop;
    std::optional<LineListener> listener;
    std::vector<std::string> ends, losses, lines;
    int begun = 0, connected = 0, heard = 0;
    bool answers = true;
};

}  // namespace

TEST_CASE("lines go both ways and keep their order") {
    Ends ends;
    LineCaller caller = ends.caller();
    REQUIRE(ends.comes([&] { return ends.connected == 1; }));
    caller.send("one");
    caller.send("two");
    REQUIRE(ends.comes([&] { return ends.lines.size() == 2; }));
    ends.listener->send_all("three");
    REQUIRE(ends.comes([&] { return ends.lines.size() == 3; }));
    CHECK(ends.lines == std::vector<std::string>{"one", "two", "three"});
}

TEST_CASE("the longest line arrives, though the socket takes it in pieces") {
    Ends ends;
    LineCaller caller = ends.caller();
    REQUIRE(ends.comes([&] { return ends.connected == 1; }));
    const std::string line(max_wall_line, 'x');
    caller.send(line);
    caller.send("after it");
    REQUIRE(ends.comes([&] { return ends.lines.size() == 2; }));
    CHECK(ends.lines[0] == line);
}

TEST_CASE("a longer or a broken line ends the connection, and the caller comes again") {
    Ends ends;
    LineCaller caller = ends.caller();
    REQUIRE(ends.comes([&] { return ends.connected == 1; }));
    caller.send(std::string(max_wall_line + 1, 'x'));
    REQUIRE(ends.comes([&] { return ends.connected == 2; }));
    caller.send("broken");
    REQUIRE(ends.comes([&] { return ends.connected == 3; }));
    REQUIRE(ends.ends.size() == 2);
    CHECK(ends.ends[0] == "a line has more than 1048576 bytes");
    CHECK(ends.ends[1] == "it is broken");
    caller.send("whole");
    CHECK(ends.comes([&] { return ends.lines.size() == 1; }));
}

TEST_CASE("a caller waits for its listener, and finds the next one") {
    Ends ends;
    ends.listener.reset();
    LineCaller caller = ends.caller();
    for (int k = 0; k < 5; ++k)
        ends.loop.run_once(5ms);
    CHECK_FALSE(caller.is_connected());
    caller.send("nobody hears this");
    ends.listen();
    REQUIRE(ends.comes([&] { return ends.connected == 1; }));
    ends.listener.reset();
    REQUIRE(ends.comes([&] { return ends.losses.size() == 1; }));
    CHECK_FALSE(caller.is_connected());
    ends.listen();
    REQUIRE(ends.comes([&] { return ends.connected == 2; }));
    caller.send("again");
    REQUIRE(ends.comes([&] { return ends.lines.size() == 1; }));
    CHECK(ends.lines[0] == "again");
}

TEST_CASE("an end that takes no lines is let go before they fill the memory") {
    Ends ends;
    // Given a caller whose loop never runs again
    LineCaller caller = ends.caller();
    REQUIRE(ends.comes([&] { return ends.begun == 1; }));
    EventLoop other;
    UniqueFd deaf(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const UnixAddress address(ends.folder.path / "link.sock");
    REQUIRE(::connect(deaf.get(), address.get(), sizeof address.address) == 0);
    REQUIRE(ends.comes([&] { return ends.begun == 2; }));
    // When more lines come than may wait
    const std::string line(max_wall_line, 'x');
    for (std::size_t k = 0; k < 2 * LineConnection::max_waiting / max_wall_line; ++k) {
        ends.listener->send(2, line);
        ends.loop.run_once(0ms);
    }
    // Then that connection ends and no other
    REQUIRE(ends.comes([&] { return !ends.ends.empty(); }));
    CHECK(ends.ends[0] == "the other end takes no lines");
    CHECK(ends.listener->connections() == 1);
}

TEST_CASE("no more connections are held than the limit") {
    Ends ends;
    std::vector<UniqueFd> many;
    const UnixAddress address(ends.folder.path / "link.sock");
    for (std::size_t k = 0; k < LineListener::max_connections + 3; ++k) {
        many.emplace_back(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
        REQUIRE(::connect(many.back().get(), address.get(), sizeof address.address) == 0);
        ends.loop.run_once(20ms);
    }
    for (int k = 0; k < 5; ++k)
        ends.loop.run_once(1ms);
    CHECK(ends.listener->connections() == LineListener::max_connections);
}

TEST_CASE("a path that is too long for a socket is told at once") {
    EventLoop loop;
    CHECK_THROWS_AS(LineCaller(loop, std::string(200, 'x'), {}), std::invalid_argument);
}
