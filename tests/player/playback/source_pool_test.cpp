#include "player/playback/source_pool.hpp"

#include "player/playback/film_loop.hpp"
#include "player/playback/photo_load.hpp"
#include "tests/player/playback/numbered_film.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr auto patience = 20s;
const std::string mp4 = "x264enc key-int-max=25 speed-preset=veryfast ! mp4mux";

ShotRequest request(SourceId source, std::string path) {
    return {.source = source,
            .path = std::move(path),
            .kind = MediaKind::film,
            .shot = {.begin = 0s, .end = 1s, .region = {.polygon = {}, .drift = {25, 0}}},
            .width = 160,
            .height = 96};
}

Frame frame_of(int sources, std::chrono::nanoseconds local) {
    Frame frame{.canvas = {640, 480}};
    for (int i = 1; i <= sources; ++i) {
        frame.items.push_back({.source = static_cast<SourceId>(i), .local = local});
    }
    return frame;
}

}  // namespace

TEST_CASE("every source asked for is told of once, ready or failed with a reason") {
    const Folder folder;
    write_film(folder.path / "film", {.pictures = 25, .rate = 25, .chain = mp4});
    SourcePool pool({.media = folder.path, .store = folder.path / "store"});
    for (SourceId id = 1; id <= 8; ++id)
        pool.request(request(id, id == 5 ? "missing" : "film"));
    std::multiset<SourceId> ready;
    std::multiset<SourceId> failed;
    for (const SourceEvent& event : pool.wait_until_ready(patience)) {
        (event.failure ? failed : ready).insert(event.source);
    }
    CHECK(ready == std::multiset<SourceId>{1, 2, 3, 4, 6, 7, 8});
    CHECK(failed == std::multiset<SourceId>{5});
    CHECK(pool.update().empty());
}

TEST_CASE("a frame's sources are taken to its time, and each picture has its own slide") {
    const Folder folder;
    write_film(folder.path / "film", {.pictures = 25, .rate = 25, .chain = mp4});
    SourcePool pool({.media = folder.path, .store = folder.path / "store"});
    for (SourceId id = 1; id <= 3; ++id)
        pool.request(request(id, "film"));
    pool.wait_until_ready(patience);
    for (int i = 0; i < 60; ++i) {
        const Frame frame = frame_of(3, i * 40ms + 13ms);
        REQUIRE(pool.wait_for(frame, patience));
        pool.advance(frame);
        for (const DrawItem& item : frame.items) {
            const Sample sample = pool.sample(item.source).value();
            REQUIRE(number(sample) == i % 25);
            CHECK(length(sample.slide - Vec2{25 * 0.04 * (i % 25), 0}) < 1e-6);
        }
    }
    CHECK(pool.late() == 0);
}

TEST_CASE("photos asked for in another size are read anew, while they are shown") {
    const Folder folder;
    write_photo(folder.path / "photo.bmp");
    SourcePool pool({.media = folder.path, .store = folder.path / "store"});
    const auto ask = [&](SourceId id, int width) {
        ShotRequest wanted = request(id, "photo.bmp");
        wanted.kind = MediaKind::photo;
        wanted.width = width;
        wanted.height = width / 2;
        pool.request(wanted);
    };
    const auto shows = [&](SourceId id) {
        Frame frame = frame_of(4, 0s);
        pool.advance(frame);
        return pool.sample(id)->width;
    };
    for (SourceId id = 1; id <= 4; ++id)
        ask(id, 20);
    pool.wait_until_ready(patience);
    CHECK(shows(1) == 20);
    for (SourceId id = 1; id <= 4; ++id)
        ask(id, 40);
    for (SourceId id = 1; id <= 4; ++id)
        while (shows(id) != 40)
            pool.update();
    CHECK(pool.update().empty());  // told of once
}

TEST_CASE(
    "a film that the store gets while it plays goes over to the clip at a seam, and no picture is lost") {
    const Folder folder;
    const std::string clip = "0123456789abcdef/clip.mp4";
    const auto store = folder.path / "store";
    std::filesystem::create_directories((store / clip).parent_path());
    write_film(folder.path / "film", {.pictures = 25, .rate = 25, .chain = mp4});
    write_film(store / clip, {.pictures = 25, .rate = 25, .chain = mp4});
    SourcePool pool({.media = folder.path, .store = store});
    ShotRequest wanted = request(1, "film");
    pool.request(wanted);
    pool.wait_until_ready(patience);
    int before = 160;
    int changes = 0;
    for (int i = 0; i < 2000 && changes == 0; ++i) {
        if (i == 10) {
            wanted.shot.stored = {.file = clip, .width = 80, .height = 48};
            pool.request(wanted);
        }
        pool.update();
        Frame frame = frame_of(1, i * 40ms);
        REQUIRE(pool.wait_for(frame, patience));
        pool.advance(frame);
        const Sample sample = pool.sample(1).value();
        REQUIRE(number(sample) == i % 25);
        if (sample.width == before) continue;
        CHECK(i % 25 == 0);
        ++changes;
        before = sample.width;
    }
    CHECK(before == 80);
    CHECK(pool.late() == 0);
}

TEST_CASE("a film whose clip is damaged plays on from the media folder") {
    const Folder folder;
    const std::string clip = "0123456789abcdef/clip.mp4";
    const auto store = folder.path / "store";
    std::filesystem::create_directories((store / clip).parent_path());
    write_film(folder.path / "film", {.pictures = 25, .rate = 25, .chain = mp4});
    std::ofstream(store / clip) << "no film at all";
    SourcePool pool({.media = folder.path, .store = store});
    ShotRequest wanted = request(1, "film");
    pool.request(wanted);
    pool.wait_until_ready(patience);
    wanted.shot.stored = {.file = clip, .width = 80, .height = 48};
    pool.request(wanted);
    for (int i = 0; i < 200; ++i) {
        CHECK(pool.update().empty());
        Frame frame = frame_of(1, i * 40ms);
        REQUIRE(pool.wait_for(frame, patience));
        pool.advance(frame);
        REQUIRE(number(pool.sample(1).value()) == i % 25);
    }
}

TEST_CASE("what retires is gone at once, whether it waits, reads or plays") {
    const Folder folder;
    write_film(folder.path / "film", {.pictures = 25, .rate = 25, .chain = mp4});
    for (int i = 0; i < 10; ++i) {
        SourcePool pool({.media = folder.path, .store = folder.path / "store"});
        for (SourceId id = 1; id <= 8; ++id)
            pool.request(request(id, "film"));
        pool.update();
        if (i % 2 == 0) pool.wait_until_ready(patience);
        for (SourceId id = 1; id <= 8; ++id)
            pool.retire(id);
        CHECK(pool.update().empty());
        CHECK_FALSE(pool.sample(1).has_value());
        Frame frame = frame_of(8, 0s);
        pool.advance(frame);
    }
}

TEST_CASE("a shot is read from the store, and from the media folder where the store has lost or damaged it") {
    const Folder folder;
    const std::string clip = "0123456789abcdef/clip.mp4";
    const auto store = folder.path / "store";
    std::filesystem::create_directories((store / clip).parent_path());
    write_film(folder.path / "film", {.pictures = 50, .rate = 25, .chain = mp4});
    ShotRequest wanted = request(1, "film");
    wanted.shot.stored = {.file = clip, .width = 80, .height = 48};
    const auto told = [&] {
        SourcePool pool({.media = folder.path, .store = store});
        pool.request(wanted);
        const std::vector<SourceEvent> events = pool.wait_until_ready(patience);
        REQUIRE(events.size() == 1);
        CHECK_FALSE(events[0].failure);
        Frame frame = frame_of(1, 0ms);
        pool.wait_for(frame, patience);
        pool.advance(frame);
        const int width = pool.sample(1)->width;
        return std::pair(events[0].unstored, width);
    };
    CHECK(told() == std::pair(std::string("film"), 160));
    std::ofstream(store / clip) << "no film at all";
    CHECK(told() == std::pair(std::string("film"), 160));
    write_film(store / clip, {.pictures = 25, .rate = 25, .chain = mp4});
    CHECK(told() == std::pair(std::string(), 80));
    std::filesystem::remove(folder.path / "film");
    CHECK(told() == std::pair(std::string(), 80));
}

TEST_CASE("files of the media folder go to the factories for uploads, those of the store do not") {
    const Folder folder;
    const std::string store = folder.path / "store";
    std::filesystem::create_directory(store);
    write_film(folder.path / "film", {.pictures = 25, .rate = 25, .chain = mp4});
    write_film(store + "/clip", {.pictures = 25, .rate = 25, .chain = mp4});
    write_photo(folder.path / "photo");
    std::set<std::string> uploads;
    SourceOptions options;
    options.uploads.make_film = [&](const FilmPart& part, SampleQueue& queue, const FilmOptions& film) {
        uploads.insert(part.file);
        return std::make_unique<FilmLoop>(part, queue, film);
    };
    options.uploads.make_photo = [&](const PhotoWish& wish, SampleQueue& queue) {
        uploads.insert(wish.file);
        return std::make_unique<PhotoLoad>(wish, queue);
    };
    SourcePool pool({.media = folder.path, .store = store}, options);
    ShotRequest photo = request(2, "photo");
    photo.kind = MediaKind::photo;
    ShotRequest clip = request(3, "gone");
    clip.shot.stored = StoredShot{.file = "clip", .width = 160, .height = 96};
    for (const ShotRequest& one : {request(1, "film"), photo, clip})
        pool.request(one);
    const std::vector<SourceEvent> events = pool.wait_until_ready(patience);
    CHECK(events.size() == 3);
    CHECK(std::ranges::none_of(events, [](const SourceEvent& event) { return event.failure.has_value(); }));
    CHECK(uploads == std::set<std::string>{folder.path / "film", folder.path / "photo"});
}
