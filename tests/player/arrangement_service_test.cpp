#include "player/arrangement_service.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

WallArrangement wall_with(double scale) {
    return {.walls = {{"", {.canvas = {100, 50}, .shots = {{.key = {"a", 0}, .at = {scale, {}}}}}}}};
}

/// The player around the service.
struct ArrangedPlayer {
    WallArrangement present = wall_with(1);
    std::optional<WallArrangement> taken = {};
    std::chrono::nanoseconds now{0};
    ArrangementService service;

    explicit ArrangedPlayer(const std::filesystem::path& state)
        : service(state, {.present = [this] { return present; },
                          .take = [this](const WallArrangement& arrangement) { taken = arrangement; }}) {}

    void run(std::chrono::nanoseconds duration, bool is_kept = true) {
        for (const auto end = now + duration; now < end; now += 100ms)
            service.look(now, is_kept);
    }

    CommandAnswer call(const char* method, const std::string& name) {
        return service.handlers().at(method)({.file = name});
    }
};

std::optional<WallArrangement> taken_after_restart(const std::filesystem::path& state) {
    ArrangedPlayer player(state);
    player.service.take_last();
    return player.taken;
}

}  // namespace

TEST_CASE("a wall that has come to rest is kept, even if the player is killed") {
    const TemporaryDirectory state;
    {
        ArrangedPlayer player(state.path);
        player.run(5s);
        player.present = wall_with(2);
        while (ArrangementFiles(state.path).last() != wall_with(2))  // a thread writes it
            player.run(2s);
    }
    CHECK(taken_after_restart(state.path) == wall_with(2));
}

TEST_CASE("a wall that moves is not written before it rests or the run ends") {
    const TemporaryDirectory state;
    ArrangedPlayer player(state.path);
    for (int k = 1; k < 40; ++k) {
        player.present = wall_with(k);
        player.run(500ms);
    }
    CHECK_FALSE(std::filesystem::exists(state.path / "arrangement.json"));
    player.service.end_run(true);
    CHECK(taken_after_restart(state.path) == wall_with(39));
}

TEST_CASE("nothing is written if nothing shall be kept") {
    const TemporaryDirectory state;
    ArrangedPlayer player(state.path);
    player.run(20s, false);
    player.service.end_run(false);
    CHECK(std::filesystem::is_empty(state.path));
}

TEST_CASE("a wall that cannot be told, as a folder is open in it, is kept as it was") {
    const TemporaryDirectory state;
    ArrangedPlayer player(state.path);
    player.run(5s);
    player.present = {.pinned = {"b"}};
    player.run(5s);
    player.service.end_run(true);
    WallArrangement both = wall_with(1);
    both.pinned = {"b"};
    CHECK(taken_after_restart(state.path) == both);
}

TEST_CASE("a layout is saved under its name and loaded again") {
    const TemporaryDirectory state;
    ArrangedPlayer player(state.path);
    CHECK(player.call("SaveLayout", "one").text == "one");
    player.present = wall_with(2);
    CHECK(player.call("LoadLayout", "one").text == "one");
    CHECK(player.taken == wall_with(1));
    CHECK(player.call("Layouts", "").text == R"(["one"])");
    CHECK(player.call("ForgetLayout", "one").text == "one");
    CHECK(player.call("Layouts", "").text == "[]");
    CHECK_THROWS_AS(player.call("LoadLayout", "one"), std::runtime_error);
}

TEST_CASE("nothing is saved while no wall is shown") {
    const TemporaryDirectory state;
    ArrangedPlayer player(state.path);
    player.present = {};
    CHECK_THROWS_WITH(player.call("SaveLayout", "one"), "no wall is shown that could be saved");
}
