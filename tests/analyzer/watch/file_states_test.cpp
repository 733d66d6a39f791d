#include "analyzer/watch/file_states.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
using State = FileState::State;

namespace {

const FileFacts facts{.bytes = 10, .mtime_ns = 1};
const FileFacts grown{.bytes = 20, .mtime_ns = 2};

/// One file on its way, an hour after midnight of the year 1970 by the people's clock.
struct Way {
    FileState now() const {
        const auto all = states.list(schedule, clock, std::chrono::system_clock::time_point(clock - epoch));
        return all.size() == 1 ? all.front() : FileState{};
    }

    void start() {
        clock += 2s;
        schedule.see_file("a", facts, clock);
        REQUIRE(schedule.next_actions(clock).size() == 1);
    }

    void end(Answer answer, MediaState state, const std::string& reason) {
        schedule.finish_analysis("a", answer, clock);
        states.note_record({.path = "a", .state = state, .reason = reason});
    }

    static constexpr Schedule::Time epoch{1h};
    Schedule schedule{Pace{}};
    FileStates states;
    Schedule::Time clock{2h};
};

}  // namespace

TEST_CASE("a file is copying until it is quiet, then analysing, then what its record says") {
    Way way;
    way.schedule.see_file("a", facts, way.clock);
    CHECK(way.now().state == State::copying);
    CHECK(way.now().since.time_since_epoch() == 1h);

    way.start();
    CHECK(way.now().state == State::analysing);

    way.end(Answer::final, MediaState::unsupported, "a text");
    CHECK(way.now() == FileState{.path = "a",
                                 .state = State::unsupported,
                                 .since = std::chrono::system_clock::time_point(1h + 2s),
                                 .reason = "a text"});
}

TEST_CASE("a file that waits says so, with its reason and the same since, while it is tried again") {
    Way way;
    way.schedule.see_file("a", facts, way.clock);
    way.start();
    way.end(Answer::waiting, MediaState::waiting, "half of it is here");
    const FileState waiting = way.now();
    CHECK(waiting.state == State::waiting);
    CHECK(waiting.since.time_since_epoch() == 1h);

    way.clock += 5s;
    way.start();

    CHECK(way.now() == waiting);
}

TEST_CASE("a film is ready with its first shot, and copying again when it is overwritten") {
    Way way;
    way.schedule.see_file("a", facts, way.clock);
    way.start();
    REQUIRE(way.schedule.mark_grown("a"));
    way.states.note_record({.path = "a", .state = MediaState::ready});
    CHECK(way.now().state == State::ready);

    way.schedule.see_file("a", grown, way.clock);

    CHECK(way.now().state == State::copying);
}

TEST_CASE("a deleted file, and one that only an earlier run has seen, are not listed") {
    Way way;
    way.schedule.add_recorded("a", facts, true, false);
    way.states.note_record({.path = "a", .state = MediaState::ready});
    CHECK(way.now().path.empty());

    way.schedule.see_file("a", facts, way.clock);
    CHECK(way.now().state == State::ready);

    way.schedule.lose_file("a", way.clock);
    CHECK(way.now().path.empty());
}

TEST_CASE("the caption of a photo is known until the file is forgotten") {
    FileStates states;
    MediaRecord record{.path = "a.jpg", .state = MediaState::ready};
    record.origin.caption = "Lake";
    states.note_record(record);
    CHECK(states.caption("a.jpg").text == "Lake");
    CHECK(!states.caption("a.jpg").day);
    states.forget_file("a.jpg");
    CHECK(states.caption("a.jpg").text.empty());
}
