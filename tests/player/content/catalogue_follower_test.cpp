#include "player/content/catalogue_follower.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

MediaRecord record(const std::string& path, std::int64_t mtime = 1, MediaState state = MediaState::ready) {
    return {.path = path, .mtime_ns = mtime, .state = state, .width = 4, .height = 3, .shots = {Shot{}}};
}

}  // namespace

TEST_CASE("what is new, what was replaced and what is gone is told apart") {
    const std::vector<MediaRecord> before{record("a"), record("b"), record("c")};
    const std::vector<MediaRecord> after{record("a"), record("c", 2), record("d")};
    const CatalogueChange change = change_between(before, after);
    CHECK(change.added == std::vector<std::string>{"d"});
    CHECK(change.replaced == std::vector<std::string>{"c"});
    CHECK(change.gone == std::vector<std::string>{"b"});
    CHECK(change_between(after, after).is_empty());
}

TEST_CASE("a film to which shots were added has grown and is not replaced") {
    std::vector<MediaRecord> before{record("a"), record("b")};
    before[0].is_complete = false;
    std::vector<MediaRecord> after = before;
    after[0].shots.push_back({.begin = 1s, .end = 2s});
    after[1].shots[0].end = 1s;
    const CatalogueChange change = change_between(before, after);
    CHECK(change.grown == std::vector<std::string>{"a"});
    CHECK(change.replaced == std::vector<std::string>{"b"});
}

TEST_CASE("a follower sees a catalogue that comes into being, changes and loses a record") {
    const TemporaryDirectory directory;
    const Catalogue catalogue(directory.path / "catalogue");
    EventLoop loop;
    std::vector<CatalogueChange> changes;
    CatalogueFollower follower(loop, catalogue,
                               [&](const CatalogueChange& change, const RecordList&, const GroupList&) {
                                   changes.push_back(change);
                               });
    const auto wait_for_change = [&] {
        changes.clear();
        for (int i = 0; i < 200 && changes.empty(); ++i)
            loop.run_once(50ms);
        REQUIRE(changes.size() == 1);
        return changes[0];
    };
    CHECK(follower.records().is_empty());

    catalogue.store(record("red"));
    catalogue.store(record("broken", 1, MediaState::failed));
    CHECK(wait_for_change().added == std::vector<std::string>{"red"});  // only ready files are told

    catalogue.store(record("red", 2));
    CHECK(wait_for_change().replaced == std::vector<std::string>{"red"});

    catalogue.remove("red");
    CHECK(wait_for_change().gone == std::vector<std::string>{"red"});
    REQUIRE(follower.records().size() == 1);

    catalogue.store(record("broken", 1, MediaState::waiting));
    const CatalogueChange other = wait_for_change();
    CHECK(other.has_others);
    CHECK(other.added.empty());
}

TEST_CASE("a catalogue that changes without a pause is followed all the same") {
    const TemporaryDirectory directory;
    const Catalogue catalogue(directory.path / "catalogue");
    catalogue.store(record("gone"));
    EventLoop loop;
    bool is_gone = false;
    CatalogueFollower follower(loop, catalogue,
                               [&](const CatalogueChange& change, const RecordList&, const GroupList&) {
                                   is_gone = is_gone || change.gone == std::vector<std::string>{"gone"};
                               });
    catalogue.remove("gone");
    const auto begin = EventLoop::Clock::now();
    for (int i = 0; !is_gone && EventLoop::Clock::now() - begin < 60s; ++i) {
        catalogue.store(record("other", i));  // an event every few milliseconds, for ever
        loop.run_once(20ms);
    }
    CHECK(is_gone);
}
