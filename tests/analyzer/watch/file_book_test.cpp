#include "analyzer/watch/file_book.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

const std::string stored = std::string(16, 'a') + "/0-1.mp4";  // a clip in the store
const FileFacts facts{.bytes = 10, .mtime_ns = 1};

MediaRecord film(const std::string& path, std::size_t shots, bool is_complete) {
    MediaRecord record{.path = path,
                       .kind = MediaKind::film,
                       .bytes = facts.bytes,
                       .mtime_ns = facts.mtime_ns,
                       .state = MediaState::ready,
                       .width = 4,
                       .height = 3};
    record.is_complete = is_complete;
    for (std::size_t i = 0; i < shots; ++i)
        record.shots.push_back({.begin = 1s * i, .end = 1s * (i + 1)});
    return record;
}

MediaRecord waiting(const std::string& path) {
    return {.path = path, .state = MediaState::waiting, .reason = "half of it is here"};
}

/// A book of one film that is stored on a disk with much room.
struct Desk {
    /// The schedule has a child for this file.
    void start(const std::string& path) {
        schedule.see_file(path, facts, now);
        now += 10s;
        schedule.see_file(path, facts, now);
        REQUIRE(schedule.next_actions(now).size() == 1);
    }

    void put_into_store(const std::string& name) const { home.write("store/" + name, "clip"); }

    bool has_stored(const std::string& name) const {
        return std::filesystem::exists(home.path / "store" / name);
    }

    /// Sweeps so often that an unnamed file is gone.
    void sweep() {
        book.sweep({});
        book.sweep({});
    }

    TemporaryDirectory home;
    EventLoop loop;
    Schedule::Time now{1h};
    Schedule schedule{Pace{.children = 2}};
    Weaver weaver{loop, {.root = home.path / "media", .state = home.path}, [] {}};
    Refiner refiner{loop, {}, [](const std::vector<MediaRecord>&) {}};
    FileBook book{loop,
                  {.catalogue = home.path / "catalogue",
                   .store = home.path / "store",
                   .bounds = {.max_bytes = 1000},
                   .thumbnails = home.path / "thumbnails"},
                  schedule,
                  {.weaver = weaver, .refiner = refiner}};
};

}  // namespace

TEST_CASE("a photo takes its region from the network only while it is the same content") {
    Desk desk;
    MediaRecord plain{.path = "a",
                      .kind = MediaKind::photo,
                      .bytes = 7,
                      .mtime_ns = 1,
                      .inode = 5,
                      .state = MediaState::ready,
                      .width = 4,
                      .height = 3,
                      .shots = {Shot{}}};
    desk.book.store(plain);
    MediaRecord refined = plain;
    refined.inode = 0;
    refined.shots.front().certainty = 0.9;
    refined.shots.front().region.polygon = {{0, 0}, {2, 0}, {0, 2}};
    MediaRecord other = refined;
    other.mtime_ns = 2;
    desk.book.refine({other});
    CHECK(desk.book.record("a") == plain);
    desk.book.refine({refined});
    refined.inode = 5;
    CHECK(desk.book.record("a") == refined);
}

TEST_CASE("a renamed film has its record, its clips and its thumbnail under the new name alone") {
    Desk desk;
    desk.put_into_store(stored);
    desk.home.write("thumbnails/" + record_id("a") + "/thumbnail.jpg", "picture");
    MediaRecord record = film("a", 1, true);
    record.shots[0].stored = {.file = stored, .width = 4, .height = 3};
    desk.book.store(record);

    REQUIRE(desk.book.move("a", "b"));

    CHECK_FALSE(desk.book.record("a"));
    REQUIRE(desk.book.record("b"));
    CHECK(desk.book.record("b")->shots == record.shots);
    CHECK(std::filesystem::exists(desk.home.path / "thumbnails" / record_id("b") / "thumbnail.jpg"));
    desk.sweep();
    CHECK(desk.has_stored(stored));
    desk.book.remove("b");
    desk.sweep();
    CHECK_FALSE(desk.has_stored(stored));
}

TEST_CASE("a renamed file is forgotten as a whole: the next one of its name begins anew") {
    Desk desk;
    desk.start("a");
    desk.book.begin_analysis("a", facts);
    desk.book.add_growth(film("a", 2, false));
    REQUIRE(desk.book.record("a"));
    REQUIRE(desk.book.is_news(waiting("a")));
    REQUIRE_FALSE(desk.book.is_news(waiting("a")));

    REQUIRE(desk.book.move("a", "b"));

    CHECK(desk.book.is_news(waiting("a")));
    desk.book.begin_analysis("a", facts);
    desk.book.add_growth(film("a", 1, false));
    desk.book.end_analysis("a", facts);
    REQUIRE(desk.book.record("a"));  // its one shot is not taken for one of the two that were known
    CHECK(desk.book.record("a")->shots.size() == 1);
}

TEST_CASE("a film that is analysed again keeps its shots until more of them are known") {
    Desk desk;
    desk.book.store(film("a", 2, true));
    desk.start("a");
    desk.book.begin_analysis("a", facts);
    desk.book.add_growth(film("a", 1, false));
    desk.book.end_analysis("a", facts);
    REQUIRE(desk.book.record("a"));
    CHECK(desk.book.record("a")->shots.size() == 2);
    CHECK(desk.book.record("a")->is_complete);
}

TEST_CASE("a removed file is forgotten as a whole, with what its child still says") {
    Desk desk;
    desk.start("a");
    desk.book.begin_analysis("a", facts);
    REQUIRE(desk.book.is_news(waiting("a")));

    desk.book.remove("a");
    desk.book.add_growth(film("a", 2, false));
    desk.book.end_analysis("a", facts);

    CHECK_FALSE(desk.book.record("a"));
    CHECK(desk.book.is_news(waiting("a")));
}

TEST_CASE("a record that the disk refused goes with its file") {
    Desk desk;
    std::filesystem::create_directories(desk.home.path / "catalogue" / (record_id("a") + ".json") / "full");
    desk.book.store(film("a", 1, true));
    CHECK(desk.book.backlog().records == 1);

    desk.book.remove("a");

    CHECK(desk.book.backlog().records == 0);
    CHECK(desk.book.backlog().removals == 1);
    std::filesystem::remove_all(desk.home.path / "catalogue" / (record_id("a") + ".json"));
    desk.book.retry_writes();
    CHECK(desk.book.backlog().removals == 0);
}

TEST_CASE("a film whose record is not renamed for want of one stays as it was") {
    Desk desk;
    CHECK_FALSE(desk.book.move("a", "b"));
    CHECK_FALSE(desk.book.record("b"));
}
