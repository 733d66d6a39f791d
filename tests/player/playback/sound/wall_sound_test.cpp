#include "player/playback/sound/wall_sound.hpp"

#include "tests/player/playback/numbered_film.hpp"
#include "tests/player/playback/sound/sounding_film.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <stdexcept>
#include <thread>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

std::chrono::nanoseconds now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

AudibleShot shot(SourceId source, const std::string& path, double area = 1000) {
    return {.source = source,
            .path = path,
            .begin = {},
            .end = 2s,
            .stored = StoredSound{.file = path},
            .local = {},
            .area = area};
}

struct Hall {
    explicit Hall(const SoundSink& other = {}) : sound(places, other ? other : recorder.sink()) {
        std::filesystem::create_directory(places.media);
        std::filesystem::create_directory(places.store);
    }

    /// Has the wall be followed until something has come true.
    bool comes_true(const std::vector<AudibleShot>& shots, const std::function<bool()>& condition) {
        for (int i = 0; i < 5000 && !condition(); ++i) {
            sound.follow(shots, begin);
            for (const SoundEvent& event : sound.take_events())
                events.push_back(event);
            std::this_thread::sleep_for(2ms);
        }
        return condition();
    }

    Folder folder;
    MediaPlaces places{.media = folder.path / "media", .store = folder.path / "store"};
    SoundRecorder recorder;
    WallSound sound;
    std::chrono::nanoseconds begin = now();
    std::vector<SoundEvent> events;
};

}  // namespace

TEST_CASE("one of two films is heard, and the other when that one has gone") {
    Hall hall;
    write_sounding_film(hall.places.store + "/a.mp4", {.seconds = 2});
    write_sounding_film(hall.places.store + "/b.mp4", {.seconds = 2});
    CHECK(hall.comes_true({shot(1, "a.mp4"), shot(2, "b.mp4", 900)},
                          [&] { return hall.recorder.sinks() == 1; }));
    CHECK(hall.sound.heard() == SourceId{1});
    CHECK(hall.comes_true({shot(2, "b.mp4", 900)}, [&] { return hall.recorder.sinks() == 2; }));
    CHECK(hall.sound.heard() == SourceId{2});
    hall.sound.follow({}, {});
    CHECK_FALSE(hall.sound.heard().has_value());
}

TEST_CASE("while another box lets a film be heard this one is silent, and does not choose another film") {
    Hall hall;
    write_sounding_film(hall.places.store + "/a.mp4", {.seconds = 2});
    write_sounding_film(hall.places.store + "/b.mp4", {.seconds = 2});
    AudibleShot one = shot(1, "a.mp4");
    one.local = 4s;  // it came first
    one.is_elsewhere = true;
    CHECK(hall.comes_true({one, shot(2, "b.mp4", 900)}, [&, i = 0]() mutable { return ++i > 20; }));
    CHECK(hall.comes_true({one, shot(2, "b.mp4", 1200)}, [&, i = 0]() mutable { return ++i > 20; }));
    CHECK(hall.recorder.sinks() == 0);
    one.is_elsewhere = false;  // it has moved
    CHECK(hall.comes_true({one, shot(2, "b.mp4", 1200)}, [&] { return hall.recorder.sinks() == 1; }));
    CHECK(hall.sound.heard() == SourceId{1});
}

TEST_CASE("a film is silent until its sound is in the store, and the journal says so") {
    Hall hall;
    write_sounding_film(hall.places.media + "/a.mp4", {.seconds = 2});
    write_sounding_film(hall.places.store + "/sound", {.muxer = "matroskamux", .seconds = 2});
    AudibleShot one = shot(1, "a.mp4");
    one.stored.reset();
    CHECK(hall.comes_true({one}, [&, i = 0]() mutable { return ++i > 50; }));
    CHECK(hall.recorder.sinks() == 0);
    REQUIRE(hall.events.size() == 1);
    CHECK(hall.events.front().text == "'a.mp4' is silent until its sound is in the store");
    one.stored = StoredSound{.file = "sound"};
    CHECK(hall.comes_true({one}, [&] { return hall.recorder.sinks() == 1; }));
    CHECK_FALSE(hall.recorder.take(100ms).empty());
    CHECK(hall.events.size() == 1);
}

TEST_CASE("a sound whose picture is elsewhere by now begins anew there") {
    Hall hall;
    write_sounding_film(hall.places.store + "/a.mp4", {.seconds = 2});
    AudibleShot one = shot(1, "a.mp4");
    CHECK(hall.comes_true({one}, [&] { return hall.recorder.sinks() == 1; }));
    one.local = 60ms;
    CHECK(hall.comes_true({one}, [&, i = 0]() mutable { return ++i > 20; }));
    CHECK(hall.recorder.sinks() == 1);
    one.local = 500ms;
    CHECK(hall.comes_true({one}, [&] { return hall.recorder.sinks() == 2; }));
}

TEST_CASE("that there is no device is told once, be there ever so many films") {
    Hall hall([]() -> GstPtr<GstElement> { throw std::runtime_error("no sound card"); });
    write_sounding_film(hall.places.store + "/a.mp4", {.seconds = 2});
    std::filesystem::copy(hall.places.store + "/a.mp4", hall.places.store + "/b.mp4");
    for (SourceId source = 1; source <= 4; ++source)
        CHECK(hall.comes_true({shot(source, source % 2 ? "a.mp4" : "b.mp4")},
                              [&, i = 0]() mutable { return ++i > 50 && !hall.sound.heard(); }));
    CHECK(std::ranges::count(hall.events, "no sound card", &SoundEvent::text) == 1);
}

TEST_CASE("a film without sound is named once, and nothing is tried with it again while it stays") {
    Hall hall;
    write_sounding_film(hall.places.store + "/a.mp4", {.encoder = "", .seconds = 2});
    CHECK(hall.comes_true({shot(1, "a.mp4")}, [&] { return hall.events.size() == 1; }));
    CHECK(hall.events.back().text == "the sound of 'a.mp4' is not played: the film has no sound");
    CHECK(hall.comes_true({shot(1, "a.mp4")}, [&, i = 0]() mutable { return ++i > 50; }));
    CHECK(hall.recorder.sinks() == 1);
    CHECK(hall.comes_true({shot(2, "a.mp4")}, [&] { return hall.recorder.sinks() == 2; }));
    CHECK(hall.events.size() == 1);
}
