#include "analyzer/watch/refiner.hpp"

#include "base/state/record_json.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <functional>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// Finds a region with the network in every photo; "bad" ones bring it down.
constexpr const char* network = R"(
    name=${1##*/}
    echo "$name" >> "$0.log"
    case "$name" in bad*) echo 'out of order' >&2; exit 1;; esac
    echo '{"version":3,"path":"'"$name"'","kind":"photo","bytes":7,"mtime_ns":1,"state":"ready","complete":true,'\
         '"reason":"","width":4,"height":3,"duration_ns":0,"shots":[{"begin_ns":0,"end_ns":0,"ends_with":"end",'\
         '"region":{"polygon":[[0,0],[1,0],[0,1]],"drift":[0,0]},"certainty":0.9}]}')";

MediaRecord photo(const std::string& path, std::int64_t mtime_ns = 1) {
    return {.path = path,
            .kind = MediaKind::photo,
            .bytes = 7,
            .mtime_ns = mtime_ns,
            .state = MediaState::ready,
            .width = 4,
            .height = 3,
            .shots = {Shot{}}};
}

struct Desk {
    Desk() : script(home.write("network.sh", network)) {}

    bool comes_true(const std::function<bool()>& condition) {
        const auto end = EventLoop::Clock::now() + 60s;
        while (!condition() && EventLoop::Clock::now() < end)
            loop.run_once(100ms);
        return condition();
    }

    std::vector<std::string> looked_at() const {
        std::vector<std::string> names;
        std::ifstream log(script.string() + ".log");
        for (std::string name; std::getline(log, name);)
            names.push_back(name);
        return names;
    }

    TemporaryDirectory home;
    fs::path script;
    EventLoop loop;
    std::vector<std::vector<MediaRecord>> handed_over;
    Refiner refiner{loop,
                    {.root = home.path, .command = {"/bin/sh", script.string()}, .limits = {}, .children = 1},
                    [this](const std::vector<MediaRecord>& records) {
                        if (!records.empty()) handed_over.push_back(records);
                    }};
};

}  // namespace

TEST_CASE("photos are looked at once nothing is analysed, the newest first, and handed over together") {
    Desk desk;
    desk.refiner.note_record(photo("old", 1));
    desk.refiner.note_record(photo("new", 2));
    desk.refiner.advance(false);
    for (int i = 0; i < 10; ++i)
        desk.loop.run_once(20ms);
    CHECK(desk.looked_at().empty());
    desk.refiner.advance(true);
    REQUIRE(desk.comes_true([&] { return desk.refiner.backlog() == 0; }));
    CHECK(desk.looked_at() == std::vector<std::string>{"new", "old"});
    REQUIRE(desk.handed_over.size() == 1);
    REQUIRE(desk.handed_over.front().size() == 2);
    CHECK(desk.handed_over.front().front().shots.front().certainty == 0.9);
}

TEST_CASE("films, photos that are not ready and those that the network has seen are left alone") {
    Desk desk;
    MediaRecord film = photo("film");
    film.kind = MediaKind::film;
    MediaRecord waiting = photo("waiting");
    waiting.state = MediaState::waiting;
    MediaRecord seen = photo("seen");
    seen.shots.front().certainty = 0.5;
    for (const MediaRecord& record : {film, waiting, seen})
        desk.refiner.note_record(record);
    CHECK(desk.refiner.backlog() == 0);
}

TEST_CASE("a photo is looked at once, and again when its content is another") {
    Desk desk;
    for (const std::int64_t mtime : {1, 1, 2}) {
        desk.refiner.note_record(photo("a", mtime));
        desk.refiner.advance(true);
        REQUIRE(desk.comes_true([&] { return desk.refiner.backlog() == 0; }));
    }
    CHECK(desk.looked_at().size() == 2);
}

TEST_CASE("a network that fails again and again is given up, and one photo that fails is not") {
    Desk desk;
    for (const char* path : {"bad1", "good", "bad2"}) {
        desk.refiner.note_record(photo(path));
        desk.refiner.advance(true);
        REQUIRE(desk.comes_true([&] { return desk.refiner.backlog() == 0; }));
    }
    CHECK(desk.handed_over.size() == 1);
    for (const char* path : {"bad3", "bad4", "bad5", "bad6"})
        desk.refiner.note_record(photo(path));
    desk.refiner.advance(true);
    REQUIRE(desk.comes_true([&] { return desk.refiner.backlog() == 0; }));
    CHECK(desk.looked_at().size() == 5);
    desk.refiner.note_record(photo("late"));
    CHECK(desk.refiner.backlog() == 0);
}

TEST_CASE("a photo that goes meanwhile is not looked at") {
    Desk desk;
    desk.refiner.note_record(photo("gone"));
    desk.refiner.forget_file("gone");
    desk.refiner.advance(true);
    CHECK(desk.refiner.backlog() == 0);
}
