#include "analyzer/store/store.hpp"

#include "tests/temporary_directory.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <array>
#include <limits>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

namespace {

const std::string id_a(16, 'a');
const std::string id_b(16, 'b');

MediaRecord film(const std::string& path, const std::vector<std::string>& files) {
    MediaRecord record{.path = path, .kind = MediaKind::film, .state = MediaState::ready};
    for (const std::string& file : files)
        record.shots.push_back({.begin = {},
                                .end = {},
                                .region = {},
                                .stored = StoredShot{.file = file, .width = 8, .height = 8}});
    return record;
}

struct Shelf {
    /// @param age  seconds since it was used
    void put(const std::string& name, int age = 0, std::size_t bytes = 10) const {
        const fs::path file = home.write("store/" + name, std::string(bytes, 'x'));
        std::array<timespec, 2> times{};
        times.fill({.tv_sec = 1'700'000'000 - age, .tv_nsec = 0});
        REQUIRE(::utimensat(AT_FDCWD, file.c_str(), times.data(), 0) == 0);
    }

    bool has(const std::string& name) const { return fs::exists(directory / name); }

    TemporaryDirectory home;
    fs::path directory = home.path / "store";
};

}  // namespace

TEST_CASE("what no record names is taken out at the second look, what one names stays") {
    const Shelf shelf;
    shelf.put(id_a + "/0-1.mp4");
    shelf.put(id_a + "/1-2.mp4.new");  // a crash left it
    shelf.put(id_b + "/photo");
    Store store(shelf.directory, {.max_bytes = 1000});
    store.note_record(film("a", {id_a + "/0-1.mp4"}));
    store.sweep();
    CHECK(shelf.has(id_b + "/photo"));
    store.sweep();
    CHECK(shelf.has(id_a + "/0-1.mp4"));
    CHECK_FALSE(shelf.has(id_a + "/1-2.mp4.new"));
    CHECK_FALSE(shelf.has(id_b));
    store.forget_file("a");
    store.sweep();
    store.sweep();
    CHECK_FALSE(shelf.has(id_a));
}

TEST_CASE("where a child is at work nothing is taken out that is not named yet") {
    const Shelf shelf;
    shelf.put(id_a + "/0-1.mp4", 50);
    Store store(shelf.directory, {.max_bytes = 5});
    store.begin_writing(id_a);
    store.sweep();
    store.sweep();
    store.make_room();
    CHECK(shelf.has(id_a + "/0-1.mp4"));
    store.end_writing(id_a);
    store.make_room();
    CHECK_FALSE(shelf.has(id_a + "/0-1.mp4"));
}

TEST_CASE("beyond its bytes the store gives up what was not used for longest, and the record says so") {
    const Shelf shelf;
    shelf.put(id_a + "/0-1.mp4", 100);
    shelf.put(id_a + "/1-2.mp4", 300);
    shelf.put(id_b + "/0-1.mp4", 200);
    Store store(shelf.directory, {.max_bytes = 25});
    MediaRecord a = film("a", {id_a + "/0-1.mp4", id_a + "/1-2.mp4"});
    store.note_record(a);
    CHECK(store.make_room().empty());
    store.note_record(film("b", {id_b + "/0-1.mp4"}));
    CHECK(store.make_room() == std::set<std::string>{"a"});
    CHECK(store.make_room().empty());
    CHECK_FALSE(shelf.has(id_a + "/1-2.mp4"));
    store.mark_dropped(a);
    CHECK_FALSE(a.shots[0].stored->is_dropped);
    CHECK(a.shots[1].stored->is_dropped);
    CHECK_FALSE(store.lacks(a));  // it is not made again
}

TEST_CASE("a full disk is no different from a full store") {
    const Shelf shelf;
    shelf.put(id_a + "/0-1.mp4");
    Store store(shelf.directory,
                {.max_bytes = 1000, .min_free_bytes = std::numeric_limits<std::uint64_t>::max()});
    store.note_record(film("a", {id_a + "/0-1.mp4"}));
    CHECK(store.make_room() == std::set<std::string>{"a"});
    CHECK_FALSE(shelf.has(id_a + "/0-1.mp4"));
}

TEST_CASE("a store that is off is emptied, and asks for nothing") {
    const Shelf shelf;
    shelf.put(id_a + "/0-1.mp4");
    Store store(shelf.directory, {.max_bytes = 0});
    MediaRecord a = film("a", {id_a + "/0-1.mp4"});
    store.note_record(a);
    CHECK(store.make_room().empty());
    CHECK_FALSE(shelf.has(id_a));
    store.mark_dropped(a);
    CHECK_FALSE(a.shots[0].stored->is_dropped);  // on again, it is made again
    CHECK_FALSE(store.lacks(a));
}

TEST_CASE("a shot that is nowhere in the store, or not where its record says, is lacking") {
    const Shelf shelf;
    shelf.put(id_a + "/0-1.mp4");
    const Store store(shelf.directory, {.max_bytes = 1000});
    CHECK_FALSE(store.lacks(film("a", {id_a + "/0-1.mp4"})));
    CHECK(store.lacks(film("a", {id_a + "/0-1.mp4", id_a + "/1-2.mp4"})));
    MediaRecord record = film("a", {id_a + "/0-1.mp4"});
    record.shots[0].stored.reset();
    CHECK(store.lacks(record));
    record.state = MediaState::failed;
    CHECK_FALSE(store.lacks(record));
}

TEST_CASE("a clip made for a much smaller screen is lacking, unless its film has no more to give") {
    const Shelf shelf;
    shelf.put(id_a + "/0-1.mp4");
    const Store store(shelf.directory, {.max_bytes = 1000, .clip_side = 1280});
    MediaRecord record = film("a", {id_a + "/0-1.mp4"});
    record.width = 1080;
    record.height = 1920;
    for (const auto& [height, is_lacking] : {std::pair{848, true}, {960, false}, {1280, false}}) {
        record.shots[0].stored->height = height;
        CHECK(store.lacks(record) == is_lacking);
    }
    record.shots[0].stored->height = 640;
    record.height = 640;
    record.width = 360;
    CHECK_FALSE(store.lacks(record));
    record.height = 1920;
    record.shots[0].stored->is_dropped = true;
    CHECK_FALSE(store.lacks(record));
}

TEST_CASE("a film's sound is held like its shots, and named when it has lost its place") {
    const Shelf shelf;
    shelf.put(id_a + "/0-1.mp4", 0, 10);
    shelf.put(id_a + "/sound", 50, 10);
    Store store(shelf.directory, {.max_bytes = 15});
    MediaRecord record = film("a", {id_a + "/0-1.mp4"});
    record.sound = StoredSound{.file = id_a + "/sound"};
    store.note_record(record);
    CHECK(store.make_room() == std::set<std::string>{"a"});
    CHECK(shelf.has(id_a + "/0-1.mp4"));
    CHECK_FALSE(shelf.has(id_a + "/sound"));
    store.mark_dropped(record);
    CHECK(record.sound->is_dropped);
    CHECK_FALSE(record.shots.front().stored->is_dropped);
}

TEST_CASE("a film lacks its sound where none was looked for, or what was kept is not there") {
    const Shelf shelf;
    const Store store(shelf.directory, {.max_bytes = 1000});
    MediaRecord record = film("a", {});
    CHECK(store.lacks_sound(record));
    record.sound = StoredSound{.file = id_a + "/sound"};
    CHECK(store.lacks_sound(record));
    shelf.put(id_a + "/sound");
    CHECK_FALSE(store.lacks_sound(record));
    record.sound = StoredSound{};  // it has none
    CHECK_FALSE(store.lacks_sound(record));
    record.sound = StoredSound{.file = id_b + "/sound", .is_dropped = true};
    CHECK_FALSE(store.lacks_sound(record));
    record = film("a", {});
    record.is_complete = false;
    CHECK_FALSE(store.lacks_sound(record));
}
