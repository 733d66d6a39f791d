#include "player/playback/film_loop.hpp"
#include "player/playback/source_pool.hpp"
#include "tests/player/playback/numbered_film.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr auto patience = 20s;
/// A key picture every ten, in between B-frames that no other picture needs.
const std::string mp4 =
    "x264enc bframes=2 b-adapt=false b-pyramid=false key-int-max=10 speed-preset=veryfast ! mp4mux";

/// The next picture of a film, whatever its time.
struct Seen {
    int number = -1;
    std::uint64_t loop = 0;
};

Seen next(SampleQueue& queue) {
    if (!queue.wait(patience)) return {};
    const auto taken = queue.take_if([](const LoopedSample&) { return true; });
    return {number(taken->sample), taken->loop};
}

/// Takes pictures until one is at or after a place.
Seen first_from(SampleQueue& queue, int number, std::uint64_t loop) {
    for (int i = 0; i < 200; ++i) {
        const Seen seen = next(queue);
        if (seen.loop > loop || (seen.loop == loop && seen.number >= number)) return seen;
    }
    return {};
}

/// A film that gives some pictures each time it is built, then stands still without a word.
struct Stalling final : FilmFeed {
    Stalling(const FilmPart& part, SampleQueue& to, int pictures, std::chrono::nanoseconds cost = 0s)
        : queue(to), cost_(cost) {
        static const std::vector<std::byte> pixels(16);
        for (int i = 0; i < pictures; ++i) {
            const auto time = part.begin + part.at % part.duration() + i * 40ms;
            queue.put(
                {.sample = {.width = 2, .height = 2, .stride = 8, .pixels = pixels, .stream_time = time},
                 .loop = static_cast<std::uint64_t>(part.at / part.duration()),
                 .duration = 40ms});
        }
    }

    void resize(int, int) override {}

    void play_from(Detail, std::chrono::nanoseconds) override {}

    std::chrono::nanoseconds spent() const override { return cost_; }

    void stop() override { queue.close(); }

    bool has_ended() const override { return true; }

    std::optional<std::string> failure() const override { return std::nullopt; }

    SampleQueue& queue;
    std::chrono::nanoseconds cost_;
};

/// A machine that films are decoded on, as fast as its cores allow, in a time of its own.
struct Machine {
    static constexpr auto period = 33ms;                           // time between the films' pictures
    static constexpr auto ahead = 5 * period;                      // decoded at most
    static constexpr std::chrono::nanoseconds keys = 10 * period;  // from one key picture to the next

    struct Decoding final : FilmFeed {
        Decoding(Machine& machine_, const FilmPart& part_, SampleQueue& to)
            : machine(machine_), part(part_), queue(to), next(part_.at) {
            machine.films.push_back(this);
        }

        ~Decoding() override { std::erase(machine.films, this); }

        void resize(int, int) override {}

        void play_from(Detail wanted, std::chrono::nanoseconds at) override {
            detail = wanted;
            next = at / step() * step();
            done = 0ns;
        }

        std::chrono::nanoseconds spent() const override { return cost; }

        void stop() override { queue.close(); }

        bool has_ended() const override { return true; }

        std::optional<std::string> failure() const override { return std::nullopt; }

        std::chrono::nanoseconds step() const {
            return detail == Detail::keys ? keys : detail == Detail::references ? 2 * period : period;
        }

        bool has_work() const { return detail != Detail::still && next < machine.now + ahead; }

        void work(std::chrono::nanoseconds time) {
            cost += time;
            done += time;
            while (done >= machine.cost_of_picture && has_work()) {
                done -= machine.cost_of_picture;
                static const std::vector<std::byte> pixels(16);
                const auto at = part.begin + next % part.duration();
                queue.put(
                    {.sample = {.width = 2, .height = 2, .stride = 8, .pixels = pixels, .stream_time = at},
                     .loop = static_cast<std::uint64_t>(next / part.duration()),
                     .duration = step()});
                next += step();
            }
        }

        Machine& machine;
        FilmPart part;
        SampleQueue& queue;
        Detail detail = Detail::all;
        std::chrono::nanoseconds next;
        std::chrono::nanoseconds done{0};  // when the next picture is done
        std::chrono::nanoseconds cost{0};
    };

    /// Until then, in slices that the films which have work share.
    void run_until(std::chrono::nanoseconds then) {
        for (; now < then; now += 1ms) {
            const auto working = std::ranges::count_if(films, &Decoding::has_work);
            for (Decoding* film : films)
                if (film->has_work()) film->work(std::min(1'000'000ns, 1'000'000ns * cores / working));
        }
    }

    std::chrono::nanoseconds cost_of_picture = 12ms;
    int cores = 2;
    std::chrono::nanoseconds now{0};
    std::vector<Decoding*> films{};
};

ShotRequest request(SourceId source) {
    return {.source = source,
            .path = "film",
            .kind = MediaKind::film,
            .shot = {.begin = 0s, .end = 4s},
            .width = 160,
            .height = 96};
}

Frame frame_at(std::chrono::nanoseconds time) {
    Frame frame{.canvas = {160, 96}, .time = time};
    frame.items.push_back({.source = 1, .local = time});
    return frame;
}

}  // namespace

TEST_CASE("a film goes on elsewhere, in the loop and at the place asked for") {
    const Folder folder;
    const std::string file = folder.path / "film";
    for (const char* muxer : {"mp4mux", "matroskamux", "mpegtsmux"}) {
        CAPTURE(std::string(muxer));
        write_film(file, {.pictures = 100, .rate = 25, .chain = mp4.substr(0, mp4.find("mp4mux")) + muxer});
        SampleQueue queue(4);
        FilmLoop loop({.file = file, .begin = 0s, .end = 4s, .width = 160, .height = 96}, queue);
        CHECK(next(queue).number == 0);
        loop.play_from(Detail::all, 9s);  // a second into the third loop
        const Seen seen = first_from(queue, 25, 2);
        CHECK(seen.loop == 2);
        CHECK(seen.number >= 24);
        CHECK(seen.number <= 27);
        for (int i = 1; i <= 20; ++i)
            CHECK(next(queue).number == seen.number + i);
        CHECK_FALSE(loop.failure());
    }
}

TEST_CASE("a film that is built anew begins where it would be by now") {
    const Folder folder;
    const std::string file = folder.path / "film";
    write_film(file, {.pictures = 100, .rate = 25, .chain = mp4});
    SampleQueue queue(4);
    const FilmLoop loop({.file = file, .begin = 0s, .end = 4s, .width = 160, .height = 96, .at = 6s}, queue);
    const Seen seen = next(queue);
    CHECK(seen.loop == 1);
    CHECK(seen.number >= 49);
    CHECK(seen.number <= 51);
}

TEST_CASE("with less detail the pictures that no other needs are left out, then all but the keys, and back") {
    const Folder folder;
    const std::string file = folder.path / "film";
    write_film(file, {.pictures = 100, .rate = 25, .chain = mp4});
    SampleQueue queue(4);
    FilmLoop loop({.file = file, .begin = 0s, .end = 4s, .width = 160, .height = 96}, queue);
    const auto shown_in_a_loop = [&](std::uint64_t number) {
        first_from(queue, 0, number);
        int pictures = 1;
        while (next(queue).loop == number)
            ++pictures;
        return pictures;
    };
    loop.play_from(Detail::references, 8s);
    const int references = shown_in_a_loop(2);
    CHECK(references > 20);
    CHECK(references < 60);
    loop.play_from(Detail::keys, 40s);
    CHECK(shown_in_a_loop(10) == 10);
    CHECK(shown_in_a_loop(11) >= 8);
    loop.play_from(Detail::all, 80s);
    CHECK(shown_in_a_loop(20) == 100);
    CHECK_FALSE(loop.failure());
}

TEST_CASE(
    "a film without a key picture in the part stands still and does not fail where only keys are wanted") {
    const Folder folder;
    const std::string file = folder.path / "film";
    write_film(
        file,
        {.pictures = 100, .rate = 25, .chain = "x264enc key-int-max=100 speed-preset=veryfast ! mp4mux"});
    SampleQueue queue(4);
    FilmLoop loop({.file = file, .begin = 1600ms, .end = 2s, .width = 160, .height = 96}, queue);
    CHECK(next(queue).number == 40);
    loop.play_from(Detail::keys, 4s);
    loop.play_from(Detail::all, 40s);
    CHECK(first_from(queue, 40, 100).loop == 100);
    CHECK_FALSE(loop.failure());
}

TEST_CASE("a film that keeps time skips pictures instead of falling behind") {
    const Folder folder;
    write_film(folder.path / "film", {.pictures = 100, .rate = 25, .chain = mp4});
    ShotSource source(folder.path / "film", request(1), {.keeps_time = true});
    source.wait_until_ready(patience);
    source.picture_at(0s);
    source.picture_at(1000s + 3s);  // far too late: it is sent there
    CHECK(source.counts().late == 1);
    for (int i = 0; i < 3; ++i) {
        const auto local = 1000s + 3400ms + i * 40ms;
        REQUIRE(source.wait_for(local, patience));
        CHECK(number(source.picture_at(local).value()) == 85 + i);
    }
}

TEST_CASE("a film that stands still takes no pictures and is never late or starved, and goes on again") {
    const Folder folder;
    write_film(folder.path / "film", {.pictures = 100, .rate = 25, .chain = mp4});
    ShotSource source(folder.path / "film", request(1), {.keeps_time = true});
    REQUIRE(source.wait_for(40ms, patience));
    const int shown = number(source.picture_at(40ms).value());
    source.set_detail(Detail::still);
    CHECK(number(source.picture_at(2s).value()) == shown);
    CHECK_FALSE(source.is_starved());
    CHECK(source.counts().late == 0);
    source.picture_at(20s);
    source.set_detail(Detail::all);
    source.picture_at(21s);
    REQUIRE(source.wait_for(22s, patience));
    CHECK(number(source.picture_at(22s).value()) == 50);
}

TEST_CASE(
    "a film that stops without a word is built anew, at last in software, then given up with a reason") {
    std::vector<FilmOptions> built;
    std::vector<std::chrono::nanoseconds> at;
    const SourceOptions options{.film = {.decoders = {{"avdec_h264", "vah264dec"}}},
                                .make_film =
                                    [&](const FilmPart& part, SampleQueue& queue, const FilmOptions& film) {
                                        built.push_back(film);
                                        at.push_back(part.at);
                                        return std::make_unique<Stalling>(part, queue, 3);
                                    },
                                .keeps_time = true};
    SourcePool pool({.media = "", .store = ""}, options);
    pool.request(request(1));
    REQUIRE(pool.update().empty());
    CHECK_FALSE(pool.update().at(0).failure);
    std::optional<std::string> failure;
    std::chrono::nanoseconds failed{0};
    for (std::chrono::nanoseconds now = 0s; now < 30s && !failure; now += 33ms) {
        Frame frame = frame_at(now);
        pool.advance(frame);
        CHECK(pool.sample(1).has_value());  // also while it is built anew
        for (const SourceEvent& event : pool.update())
            failure = event.failure;
        failed = now;
    }
    REQUIRE(built.size() == 5);
    for (const std::size_t i : {0U, 1U, 2U, 3U})
        CHECK_FALSE(built[i].decoders.empty());
    CHECK(built[4].decoders.empty());
    CHECK(at[1] > 2s);
    CHECK(at[1] < 3s);
    CHECK(failure.value_or("").size() > 10);
    CHECK(failed > 10s);
    CHECK(failed < 13s);
}

TEST_CASE(
    "films that hang before their first picture, on a share that has gone, do not keep others waiting") {
    int built = 0;
    const SourceOptions options{.make_film =
                                    [&](const FilmPart& part, SampleQueue& queue, const FilmOptions&) {
                                        return std::make_unique<Stalling>(part, queue, ++built <= 3 ? 0 : 1);
                                    },
                                .opening_patience = 100ms};
    SourcePool pool({.media = "", .store = ""}, options);
    for (SourceId id = 1; id <= 4; ++id)
        pool.request(request(id));
    CHECK(pool.update().empty());
    CHECK(built == 3);
    std::this_thread::sleep_for(200ms);
    pool.update();
    CHECK(built == 4);
    const std::vector<SourceEvent> events = pool.update();
    REQUIRE(events.size() == 1);
    CHECK(events[0].source == 4);
    CHECK(pool.queue() == 3);
}

TEST_CASE("a film whose pictures come late gives way after a second") {
    const SourceOptions options{
        .make_film = [&](const FilmPart& part, SampleQueue& queue,
                         const FilmOptions&) { return std::make_unique<Stalling>(part, queue, 1, 500ms); },
        .keeps_time = true};
    SourcePool pool({.media = "", .store = ""}, options);
    pool.request(request(1));
    pool.update();
    pool.update();
    std::chrono::nanoseconds now = 0s;
    for (; now < 1900ms; now += 33ms) {
        Frame frame = frame_at(now);
        pool.advance(frame);
    }
    CHECK(pool.states().at(0).detail == Detail::references);
}

TEST_CASE(
    "nine films on a machine for five give way until none is late, and all play whole once it is free") {
    Machine machine;  // nine films of 0.36 cores on two
    int built = 0;
    const SourceOptions options{.make_film =
                                    [&](const FilmPart& part, SampleQueue& queue, const FilmOptions&) {
                                        ++built;
                                        return std::make_unique<Machine::Decoding>(machine, part, queue);
                                    },
                                .keeps_time = true};
    SourcePool pool({.media = "", .store = ""}, options);
    for (SourceId id = 1; id <= 9; ++id)
        pool.request(request(id));
    const auto late_within = [&](std::chrono::nanoseconds duration) {
        const std::uint64_t before = pool.late();
        for (const auto end = machine.now + duration; machine.now < end;) {
            machine.run_until(machine.now + 33ms);
            REQUIRE(pool.update().size() <= 9);
            Frame frame{.canvas = {160, 96}, .time = machine.now};
            for (SourceId id = 1; id <= 9; ++id)
                frame.items.push_back({.source = id, .local = machine.now});
            pool.advance(frame);
        }
        return static_cast<double>(pool.late() - before) / (9.0 * duration / 33ms);
    };
    late_within(1s);
    CHECK(late_within(3s) > 0.1);
    late_within(60s);
    CHECK(late_within(10s) < 0.05);
    const auto count = [&](auto has_detail) {
        const std::vector<SourceState> films = pool.states();
        return std::ranges::count_if(films, has_detail, &SourceState::detail);
    };
    CHECK(count([](Detail detail) { return detail == Detail::references || detail == Detail::keys; }) > 0);
    CHECK(count([](Detail detail) { return detail != Detail::still; }) > 4);  // no more stand than have to
    machine.cores = 8;
    late_within(400s);
    CHECK(count([](Detail detail) { return detail == Detail::all; }) == 9);
    CHECK(late_within(10s) == 0);
    CHECK(built == 9);  // none was built anew
}

TEST_CASE("a film that a hardware decoder fails on is decoded by the processor") {
    const Folder folder;
    write_film(folder.path / "film", {.pictures = 25, .rate = 25, .chain = mp4});
    SourcePool pool({.media = folder.path},
                    {.film = {.decoders = {{"avdec_h264", "jpegdec"}}}});  // which cannot
    pool.request(request(1));
    const std::vector<SourceEvent> events = pool.wait_until_ready(patience);
    REQUIRE(events.size() == 1);
    CHECK_FALSE(events[0].failure);
}
