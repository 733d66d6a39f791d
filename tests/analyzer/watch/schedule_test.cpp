#include "analyzer/watch/schedule.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
using Kind = Action::Kind;
using Actions = std::vector<Action>;

namespace {

/// A schedule with a clock that only the test moves. Every file it says to look at is found unchanged.
struct Bench {
    explicit Bench(std::size_t children = 1) : schedule(Pace{.children = children}) {}

    void see(const std::string& path, const FileFacts& facts) {
        files[path] = facts;
        schedule.see_file(path, facts, now);
    }

    void lose(const std::string& path) {
        files.erase(path);
        schedule.lose_file(path, now);
    }

    Actions after(std::chrono::milliseconds wait) {
        now += wait;
        for (const std::string& path : schedule.files_to_look_at(now))
            schedule.see_file(path, files.at(path), now);
        return schedule.next_actions(now);
    }

    Verdict finish(const std::string& path, Answer answer = Answer::final) {
        return schedule.finish_analysis(path, answer, now);
    }

    /// Sees a file, analyses it to its end.
    void settle(const std::string& path, const FileFacts& facts) {
        see(path, facts);
        REQUIRE(after(2s) == Actions{start(path, facts)});
        REQUIRE(finish(path) == Verdict::store);
    }

    static Action start(const std::string& path, const FileFacts& facts, bool is_last_try = false) {
        return {.kind = Kind::start, .path = path, .facts = facts, .is_last_try = is_last_try};
    }

    Schedule schedule;
    Schedule::Time now{1h};
    std::map<std::string, FileFacts> files;
};

const FileFacts small{.bytes = 10, .mtime_ns = 1, .blocks = 8, .inode = 7};
const FileFacts grown{.bytes = 20, .mtime_ns = 2, .blocks = 8, .inode = 7};
const FileFacts grown_more{.bytes = 30, .mtime_ns = 3, .blocks = 8, .inode = 7};

}  // namespace

TEST_CASE("a new file is analysed once it has been quiet, and then never again") {
    Bench bench;
    bench.see("a.jpg", small);
    CHECK(bench.after(1999ms).empty());
    CHECK(bench.after(1ms) == Actions{Bench::start("a.jpg", small)});
    CHECK(bench.finish("a.jpg") == Verdict::store);

    bench.see("a.jpg", small);
    CHECK(bench.after(1h).empty());
    CHECK(bench.schedule.is_idle());
    CHECK_FALSE(bench.schedule.next_wake().has_value());
}

TEST_CASE("on a network share quiet takes longer, whatever the times of its files say") {
    Bench bench;
    bench.files["a"] = small;
    bench.schedule.see_file("a", small, bench.now, LookKind::remote);
    CHECK(bench.after(5999ms).empty());
    CHECK(bench.after(1ms) == Actions{Bench::start("a", small)});
}

TEST_CASE("a file that grows is not analysed before it stops, and its record says so meanwhile") {
    Bench bench;
    bench.see("film.mp4", small);
    bench.now += 1s;
    bench.see("film.mp4", grown);
    CHECK(bench.after(0s) == Actions{{.kind = Kind::hold, .path = "film.mp4", .facts = grown}});
    bench.now += 1500ms;
    bench.see("film.mp4", grown_more);
    CHECK(bench.after(1999ms).empty());
    CHECK(bench.after(1ms) == Actions{Bench::start("film.mp4", grown_more)});
}

TEST_CASE("a copy that only fills the space it reserved is still changing") {
    Bench bench;
    FileFacts facts = small;
    bench.see("film.mp4", facts);
    facts.blocks = 16;
    bench.now += 2s;
    bench.see("film.mp4", facts);
    CHECK(bench.after(1s).size() == 1);  // hold
    CHECK(bench.after(1s) == Actions{Bench::start("film.mp4", facts)});
}

TEST_CASE("a record of an earlier run holds for the same bytes and time, another is analysed") {
    Bench bench;
    bench.schedule.add_recorded("same.jpg", {.bytes = 10, .mtime_ns = 1}, true, false);
    bench.schedule.add_recorded("other.jpg", {.bytes = 11, .mtime_ns = 1}, true, false);
    bench.schedule.add_recorded("waiting.jpg", {.bytes = 10, .mtime_ns = 1}, false, true);
    CHECK(bench.schedule.is_idle());
    bench.see("same.jpg", small);
    bench.see("other.jpg", small);
    CHECK(bench.after(2s) == Actions{Bench::start("other.jpg", small)});
    CHECK(bench.finish("other.jpg") == Verdict::store);
    bench.see("waiting.jpg", small);
    CHECK(bench.after(2s) == Actions{Bench::start("waiting.jpg", small)});
}

TEST_CASE("the record of a file that was deleted between two runs goes") {
    Bench bench;
    bench.schedule.add_recorded("old.jpg", small, true, false);
    bench.lose("old.jpg");
    CHECK_FALSE(bench.schedule.is_idle());
    CHECK(bench.after(499ms).empty());
    CHECK(bench.after(1ms) == Actions{{.kind = Kind::remove, .path = "old.jpg"}});
    CHECK(bench.schedule.is_idle());
}

TEST_CASE("a file replaced while it is analysed has its child stopped and is analysed again") {
    Bench bench;
    bench.see("a.jpg", small);
    CHECK(bench.after(2s).size() == 1);
    bench.see("a.jpg", grown);
    CHECK(bench.after(0s) == Actions{{.kind = Kind::stop, .path = "a.jpg"}});
    CHECK(bench.after(5s).empty());  // the stopped child is still there
    CHECK(bench.finish("a.jpg", Answer::died) == Verdict::discard);
    CHECK(bench.after(0s) == Actions{Bench::start("a.jpg", grown)});
}

TEST_CASE("a file deleted while it is analysed leaves nothing behind") {
    Bench bench;
    bench.see("a.jpg", small);
    CHECK(bench.after(2s).size() == 1);
    bench.lose("a.jpg");
    CHECK(bench.after(0s) == Actions{{.kind = Kind::stop, .path = "a.jpg"}});
    CHECK(bench.finish("a.jpg") == Verdict::discard);
    CHECK(bench.after(1h).empty());
    CHECK(bench.schedule.paths_below("").empty());
}

TEST_CASE("a rename moves the record, in whatever folder the file turns up") {
    Bench bench;
    bench.settle("a.jpg", small);
    bench.lose("a.jpg");
    bench.now += 100ms;
    bench.see("folder/b.jpg", small);
    CHECK(bench.after(0s) ==
          Actions{{.kind = Kind::move, .path = "folder/b.jpg", .from = "a.jpg", .facts = small}});
    CHECK(bench.after(1h).empty());
}

TEST_CASE("a rename over another file has that one analysed anew") {
    Bench bench;
    FileFacts other = grown;
    other.inode = 8;
    bench.settle("a.jpg", small);
    bench.settle("b.jpg", other);
    bench.lose("a.jpg");
    bench.see("b.jpg", small);
    CHECK(bench.after(500ms) == Actions{{.kind = Kind::remove, .path = "a.jpg"}});
    CHECK(bench.after(1500ms) == Actions{Bench::start("b.jpg", small)});
}

TEST_CASE("another file with the inode of a deleted one is a new file") {
    Bench bench;
    bench.settle("a.jpg", small);
    bench.lose("a.jpg");
    bench.see("b.jpg", grown);
    CHECK(bench.after(500ms) == Actions{{.kind = Kind::remove, .path = "a.jpg"}});
    CHECK(bench.after(1500ms) == Actions{Bench::start("b.jpg", grown)});
}

TEST_CASE("a file that vanishes for a moment keeps its record") {
    Bench bench;
    bench.settle("a.jpg", small);
    bench.lose("a.jpg");
    bench.see("a.jpg", small);
    CHECK(bench.after(1h).empty());
}

TEST_CASE("a waiting file is tried again after ever longer pauses, and given up in the end") {
    Bench bench;
    bench.see("half.mp4", small);
    std::chrono::milliseconds pause = 5s;
    CHECK(bench.after(2s) == Actions{Bench::start("half.mp4", small)});
    for (int i = 0; i < 8; ++i) {
        CHECK(bench.finish("half.mp4", Answer::waiting) == Verdict::store);
        CHECK(bench.schedule.is_idle());
        CHECK(bench.after(pause - 1ms).empty());
        CHECK(bench.after(1ms) == Actions{Bench::start("half.mp4", small, i == 7)});
        pause *= 2;
    }
    CHECK(bench.finish("half.mp4", Answer::waiting) == Verdict::give_up);
    CHECK(bench.after(24h).empty());

    bench.see("half.mp4", grown);
    CHECK(bench.after(2s) == Actions{Bench::start("half.mp4", grown)});
}

TEST_CASE("a file that kills its child twice is quarantined until it changes") {
    Bench bench;
    bench.see("evil.jpg", small);
    CHECK(bench.after(2s).size() == 1);
    CHECK(bench.finish("evil.jpg", Answer::died) == Verdict::retry);
    CHECK(bench.after(0s) == Actions{Bench::start("evil.jpg", small)});
    CHECK(bench.finish("evil.jpg", Answer::died) == Verdict::quarantine);
    CHECK(bench.after(24h).empty());

    bench.see("evil.jpg", grown);
    CHECK(bench.after(2s) == Actions{Bench::start("evil.jpg", grown)});
    CHECK(bench.finish("evil.jpg", Answer::died) == Verdict::retry);
}

TEST_CASE("a file is not quarantined within an hour in which the reader of another crashed") {
    Bench bench;
    bench.see("other.jpg", grown);
    CHECK(bench.after(2s).size() == 1);
    CHECK(bench.finish("other.jpg", Answer::died) == Verdict::retry);
    CHECK(bench.after(0s).size() == 1);
    CHECK(bench.finish("other.jpg") == Verdict::store);

    bench.see("evil.jpg", small);
    CHECK(bench.after(2s).size() == 1);
    CHECK(bench.finish("evil.jpg", Answer::died) == Verdict::retry);
    CHECK(bench.after(0s).size() == 1);
    CHECK(bench.finish("evil.jpg", Answer::died) == Verdict::postpone);
    CHECK(bench.schedule.is_idle());  // it waits
    CHECK(bench.after(5s) == Actions{Bench::start("evil.jpg", small)});
    bench.now += 1h;
    CHECK(bench.finish("evil.jpg", Answer::died) == Verdict::quarantine);
}

TEST_CASE("another file of the same size and time is another file on a disk, not on a share") {
    FileFacts other = small;
    other.inode = 8;
    Bench bench;
    bench.settle("a.jpg", small);
    bench.see("a.jpg", other);
    CHECK(bench.after(2s) == Actions{Bench::start("a.jpg", other)});

    bench.schedule.see_file("b.jpg", small, bench.now, LookKind::remote);
    bench.files["b.jpg"] = small;
    CHECK(bench.after(0s).empty());
    bench.schedule.see_file("b.jpg", other, bench.now, LookKind::remote);
    CHECK(bench.schedule.next_actions(bench.now).empty());  // no `hold`: it did not change
}

TEST_CASE("a file that becomes readable is analysed, though nothing in it changed") {
    Bench bench;
    FileFacts locked = small;
    locked.is_readable = false;
    bench.settle("a.jpg", locked);
    bench.see("a.jpg", small);
    CHECK(bench.after(2s) == Actions{Bench::start("a.jpg", small)});
}

TEST_CASE("no more children run than allowed, and the newest file comes first") {
    Bench bench(2);
    for (int i = 1; i <= 4; ++i)
        bench.see("f" + std::to_string(i), {.bytes = 1, .mtime_ns = i, .inode = 1});
    const Actions first = bench.after(2s);
    REQUIRE(first.size() == 2);
    CHECK(first[0].path == "f4");
    CHECK(first[1].path == "f3");
    CHECK(bench.after(1h).empty());
    CHECK(bench.finish("f3") == Verdict::store);
    const Actions next = bench.after(0s);
    REQUIRE(next.size() == 1);
    CHECK(next[0].path == "f2");
}

TEST_CASE("a notice waits for nothing: it is analysed beside all others, and first") {
    Bench bench(1);
    bench.see("old film.mp4", {.bytes = std::uint64_t{1} << 40, .mtime_ns = 9, .inode = 1});
    REQUIRE(bench.after(2s).size() == 1);
    for (int i = 1; i <= 4; ++i)
        bench.see("f" + std::to_string(i), {.bytes = 1, .mtime_ns = 20 + i, .inode = 1});
    REQUIRE(bench.after(2s).empty());
    bench.see("!NOW 20min/a.jpg", {.bytes = 1, .mtime_ns = 1, .inode = 1});
    const Actions next = bench.after(2s);
    REQUIRE(next.size() == 1);
    CHECK(next[0].path == "!NOW 20min/a.jpg");
}

TEST_CASE("the files below a folder are those, and not its neighbours of a longer name") {
    Schedule schedule(Pace{});
    for (const char* path : {"a/1", "a/b/2", "a.jpg", "ab/3", "b"})
        schedule.see_file(path, small, Schedule::Time{});
    CHECK(schedule.paths_below("a") == std::vector<std::string>{"a/1", "a/b/2"});
    CHECK(schedule.paths_below("").size() == 5);
}

TEST_CASE("a file that was closed is due sooner than one of which nothing is known") {
    Bench bench;
    bench.files["a"] = bench.files["b"] = small;
    bench.schedule.see_file("a", small, bench.now);
    bench.schedule.see_file("b", small, bench.now, LookKind::closed);
    CHECK(bench.after(149ms).empty());
    CHECK(bench.after(1ms) == Actions{Bench::start("b", small)});
    CHECK(bench.finish("b") == Verdict::store);
    CHECK(bench.after(1849ms).empty());
    CHECK(bench.after(1ms) == Actions{Bench::start("a", small)});
}

TEST_CASE("closing is the end of waiting for quiet, and counts from the last time") {
    Bench bench;
    bench.see("a", small);
    CHECK(bench.after(500ms).empty());
    bench.schedule.see_file("a", small, bench.now, LookKind::closed);
    CHECK(bench.after(100ms).empty());
    bench.files["a"] = grown;
    bench.schedule.see_file("a", grown, bench.now, LookKind::closed);  // written once more
    const Actions held = bench.after(100ms);
    REQUIRE(held.size() == 1);
    CHECK(held[0].kind == Kind::hold);
    CHECK(bench.after(50ms) == Actions{Bench::start("a", grown)});
}

TEST_CASE("a shorter quiet time than that after closing stays what it is") {
    Bench bench;
    bench.schedule = Schedule({.quiet = 10ms});
    bench.files["a"] = small;
    bench.schedule.see_file("a", small, bench.now, LookKind::closed);
    CHECK(bench.after(10ms) == Actions{Bench::start("a", small)});
}

TEST_CASE(
    "a small file does not wait for a large one, a second small one does, and no large one takes its place") {
    Bench bench;
    bench.schedule = Schedule({.children = 1, .small_bytes = 10});
    bench.see("film", grown);
    CHECK(bench.after(2s) == Actions{Bench::start("film", grown)});
    bench.see("photo", small);
    bench.see("other", small);
    bench.see("long", grown_more);
    CHECK(bench.after(2s) == Actions{Bench::start("photo", small)});
    CHECK(bench.finish("photo") == Verdict::store);
    CHECK(bench.after(0s) == Actions{Bench::start("other", small)});
    CHECK(bench.finish("film") == Verdict::store);
    CHECK(bench.finish("other") == Verdict::store);
    CHECK(bench.after(0s) == Actions{Bench::start("long", grown_more)});
}

TEST_CASE("a file of which more is to be known is analysed again, without a look at it before") {
    Bench bench;
    bench.settle("a", small);
    bench.schedule.analyse_again("a");
    CHECK(bench.after(0s) == Actions{Bench::start("a", small)});
    bench.schedule.analyse_again("a");  // it is being analysed anyway
    CHECK(bench.finish("a") == Verdict::store);
    CHECK(bench.after(0s).empty());
    bench.schedule.analyse_again("nobody");
    CHECK(bench.after(1h).empty());
}
