// vitrine-link tells a box of the others.

#include "base/settings/settings.hpp"
#include "base/system/event_loop.hpp"
#include "base/wall/line_listener.hpp"
#include "base/wall/wall_message.hpp"
#include "player/control/player_report.hpp"
#include "player/playback/source_pool.hpp"
#include "player/scene/acts/box_note.hpp"
#include "player/stage/output_canvas.hpp"
#include "player/stage/stages.hpp"
#include "player/wall_link/wall_link.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// A box that follows, and the end of vitrine-link to which it talks.
struct Hall {
    Hall() {
        settings.wall = {.role = WallRole::follow,
                         .name = "lobby",
                         .box = "here",
                         .socket = (folder.path / "link.sock").string(),
                         .fetch_fault = (folder.path / "fault").string()};
        listener.emplace(loop, settings.wall.socket,
                         LineListener::Handlers{.begin = [](LineListener::Id) {},
                                                .line = [](LineListener::Id, const std::string&) {},
                                                .end = [](LineListener::Id, const std::string&) {}});
        link.emplace(loop, settings);
        REQUIRE(comes([&] { return listener->connections() == 1; }));
    }

    /// Lets the box hear a message until that has come true. @return  false: it did not within seconds
    bool hears(const WallMessage& message, const std::function<bool()>& holds) {
        listener->send_all(line_of(message));
        return comes(holds);
    }

    bool hears_link(bool is_connected) {
        return hears(
            {.topic = {.kind = WallTopic::Kind::link}, .payload = link_payload(is_connected, "said")},
            [&] { return others().are_awake == is_connected; });
    }

    const OtherOutputs& others() const { return *link->others(); }

    bool comes(const std::function<bool()>& holds) {
        const auto end = std::chrono::steady_clock::now() + 20s;
        while (!holds()) {
            if (std::chrono::steady_clock::now() > end) return false;
            loop.run_once(20ms);
            link->direct(stages, {}, now += 20ms);
        }
        return true;
    }

    TemporaryDirectory folder;
    Settings settings;
    EventLoop loop;
    std::chrono::nanoseconds now{0};
    SourcePool sources{{.media = {}, .store = {}}};
    Stages stages{settings, sources, false, nullptr};
    std::optional<LineListener> listener;
    std::optional<WallLink> link;
};

}  // namespace

TEST_CASE("a box that is cut off counts no other as touched, and goes by its own hours") {
    Hall hall;
    CHECK(hall.hears({.topic = {.kind = WallTopic::Kind::box, .box = "left"},
                      .payload = to_json(BoxNote{.leads = true,
                                                 .is_awake = true,
                                                 .outputs = {{.name = "DP-1", .width = 16, .height = 9}},
                                                 .fetch_fault = "rsync: no route"})},
                     [&] { return hall.others().outputs.size() == 1; }));
    CHECK(hall.link->report()->boxes.back().fetch_fault == "rsync: no route");
    CHECK_FALSE(hall.others().are_awake);  // the link has no connection yet
    CHECK(hall.hears_link(true));
    CHECK(hall.hears_link(false));
    CHECK(hall.others().outputs.size() == 1);
    CHECK(hall.hears_link(true));
}
