#include "base/settings/settings.hpp"
#include "player/display/offscreen_display.hpp"
#include "player/playback/sound/wall_sound.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/acts/followed_wall.hpp"
#include "player/scene/show.hpp"
#include "player/scene/show_controls.hpp"
#include "player/scene/wall_cells.hpp"
#include "player/stage/output_canvas.hpp"
#include "player/stage/stage.hpp"
#include "tests/player/playback/numbered_film.hpp"
#include "tests/player/playback/sound/sounding_film.hpp"

#include <doctest/doctest.h>

#include <thread>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

MediaRecord record_of(const std::string& path) {
    const Polygon region = to_polygon(Box{{20, 10}, {44, 38}});
    MediaRecord record{.path = path,
                       .kind = MediaKind::film,
                       .state = MediaState::ready,
                       .width = 64,
                       .height = 48,
                       .duration = 6s};
    record.sound = StoredSound{.file = path};  // the film itself is its sound in the store
    record.shots = {Shot{.begin = 2s, .end = 6s, .region = {.polygon = region}}};
    return record;
}

Settings one_film_at_a_time() {
    Settings settings;
    settings.layout.slots = 1;
    settings.layout.max_enlargement = 100;
    settings.show.order = ShotOrder::name;
    settings.show.dwell = 10s;
    settings.show.motion = 0ms;
    return settings;
}

/// Two films that take turns, of which one is to be heard.
struct Theatre {
    explicit Theatre(const std::string& canvas = "", WallRole role = WallRole::lead) {
        if (!canvas.empty() || role == WallRole::follow) settings.wall = {.role = role, .box = "here"};
        settings.output.canvas = canvas;
        if (!canvas.empty()) others->outputs = {{"there/DP-1", 160, 120, {}}};
        write_sounding_film(folder.path / "a.mp4");
        write_sounding_film(folder.path / "sound b.mp4");
        stage.emplace(settings,
                      StageOptions{.number = 0, .folder = {}, .awaits_sources = true, .others = others},
                      sources);
        stage->set_catalogue(std::vector{record_of("a.mp4"), record_of("sound b.mp4")},
                             {{"sound b.mp4", {.sound = true}}});
    }

    void show(std::chrono::nanoseconds time) {
        const auto screens = display.screens();
        stage->set_screens({screens.begin(), screens.end()}, time);
        stage->show(time, &renderer);
    }

    /// Lets what is on the wall be heard. @return  how often the second of the film was heard that belongs to
    /// the time of the shot; nothing where another was
    std::optional<int> hear(WallSound& sound, SoundRecorder& recorder) {
        const std::vector<AudibleShot> shots = stage->audible();
        sound.follow(shots, std::chrono::steady_clock::now().time_since_epoch());
        while (recorder.sinks() == 0)
            std::this_thread::yield();
        int right = 0;
        std::chrono::nanoseconds loud = 1h;
        for (const SoundRecorder::Piece& piece : recorder.take(6s)) {
            loud = std::min(loud, piece.time + 200ms);
            const auto at = 2s + piece.time % 4s;  // in the film
            const bool is_clear = at % 1s > 100ms && at % 1s < 850ms && piece.time > loud;
            if (!is_clear) continue;
            if (second_heard(piece.samples.data(), piece.samples.size(), piece.rate) != at / 1s) return {};
            ++right;
        }
        return right;
    }

    Folder folder;
    std::shared_ptr<OtherOutputs> others = std::make_shared<OtherOutputs>();
    Settings settings = one_film_at_a_time();
    OffscreenDisplay display{{.screens = {{160, 120}}}, {}, 30};
    Renderer renderer{1, 1};
    SourcePool sources{{.media = folder.path.string(), .store = folder.path.string()}};
    std::optional<Stage> stage;
};

/// The act of another box, whose wall shows the film that is to be heard.
WallAct act_with_sound() {
    MediaRecord record = record_of("sound b.mp4");
    record.shots[0].stored = StoredShot{.file = record.path, .begin = 2s, .width = 64, .height = 48};
    WallAct act{.name = {.run = 1, .generation = 1}, .canvas = {160, 120}};
    act.shown = {{.shot = wall_shot(record, {.path = record.path}, 7, 0), .placement = {.scale = 2}}};
    give_cells(act.shown, Canvas(act.canvas), act.cells);
    return act;
}

}  // namespace

TEST_CASE("a film whose name says so is heard in time with its picture, and nothing of another") {
    Theatre theatre;
    SoundRecorder recorder;
    WallSound sound({.media = {}, .store = theatre.folder.path.string()}, recorder.sink());
    for (auto time = 0s; time < 5s; time += 1s)
        theatre.show(time);
    REQUIRE(theatre.stage->wall().standing().at(0).key.path == "a.mp4");
    CHECK(theatre.stage->audible().empty());
    int next = 5;
    for (; theatre.stage->wall().standing().at(0).key.path == "a.mp4" && next < 60; ++next)
        theatre.show(std::chrono::seconds(next));
    theatre.show(std::chrono::seconds(next));
    REQUIRE(theatre.stage->audible().size() == 1);

    CHECK(theatre.hear(sound, recorder).value_or(0) > 50);
}

TEST_CASE("of several boxes with one wall the one that shows a film's middle lets it be heard") {
    Theatre theatre("offscreen-1 0,0; there/DP-1 170,0");
    int here = 0;
    int there = 0;
    for (int second = 0; second < 60; ++second) {
        theatre.show(std::chrono::seconds(second));
        for (const AudibleShot& shot : theatre.stage->audible()) {
            CHECK(shot.is_elsewhere == (shot.middle.x > 165));
            ++(shot.is_elsewhere ? there : here);
        }
    }
    CHECK(here > 5);
    CHECK(there > 5);
}

TEST_CASE("on a box that follows nothing is heard while the leader's wall is paused") {
    Theatre theatre("", WallRole::follow);
    FollowedWall& followed = *theatre.stage->wall().followed();
    followed.set_clock(0s, true);
    WallAct act = act_with_sound();
    std::vector<std::size_t> heard;
    int second = 0;
    for (const bool is_paused : {false, true, false}) {
        act.is_paused = is_paused;
        followed.take(act);
        ++act.name.generation;
        for (const int end = second + 3; second < end; ++second)
            theatre.show(std::chrono::seconds(second));
        heard.push_back(theatre.stage->audible().size());
    }
    CHECK(heard == std::vector<std::size_t>{1, 0, 1});
}

TEST_CASE("nothing is heard of a wall that is paused, or that no screen shows") {
    Theatre theatre;
    int next = 0;
    for (; theatre.stage->audible().empty() && next < 60; ++next)
        theatre.show(std::chrono::seconds(next));
    REQUIRE_FALSE(theatre.stage->audible().empty());
    theatre.stage->set_controls({.is_paused = true});
    CHECK(theatre.stage->audible().empty());
    theatre.stage->set_controls({});
    CHECK_FALSE(theatre.stage->audible().empty());
    theatre.stage->set_screens({}, std::chrono::seconds(next));
    CHECK(theatre.stage->audible().empty());
}
