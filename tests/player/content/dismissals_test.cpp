#include "player/content/dismissals.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

MediaRecord record(const std::string& path, std::int64_t mtime = 1) {
    return {.path = path, .bytes = 100, .mtime_ns = mtime};
}

}  // namespace

TEST_CASE("what is dismissed is left out, and comes back when it changes") {
    Dismissals dismissals;
    dismissals.add(record("a"));
    CHECK(dismissals.filtered({record("a"), record("b")}) == std::vector{record("b")});
    CHECK(dismissals.contains("a"));
    CHECK(dismissals.filtered({record("a", 2), record("b")}).size() == 2);
    CHECK_FALSE(dismissals.contains("a"));
}

TEST_CASE("a film that grows stays dismissed") {
    Dismissals dismissals;
    dismissals.add(record("a"));
    MediaRecord grown = record("a");
    grown.shots.resize(3);
    CHECK(dismissals.filtered({grown}).empty());
}
