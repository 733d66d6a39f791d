#include "player/content/notices.hpp"

#include "tests/player/scene/scene_media.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::sys_seconds noon = std::chrono::sys_days(std::chrono::year(2026) / 11 / 23) + 12h;

const std::vector<MediaRecord> with_notice{photo("!NOW 20min fire/a.jpg"), photo("b.jpg")};

bool all(const MediaRecord&) {
    return true;
}

bool none(const MediaRecord&) {
    return false;
}

}  // namespace

TEST_CASE("a notice covers all other files for its time, and is over then") {
    Notices notices("");
    CHECK(notices.set_files(with_notice, all, noon));
    CHECK(notices.active() == "!NOW 20min fire");
    CHECK(notices.is_covered("b.jpg"));
    CHECK_FALSE(notices.is_covered("!NOW 20min fire/a.jpg"));
    CHECK_FALSE(notices.look(noon + 20min - 1s));
    CHECK(notices.look(noon + 20min));
    CHECK_FALSE(notices.is_covered("b.jpg"));
    CHECK(notices.is_over("!NOW 20min fire/a.jpg"));
    CHECK_FALSE(notices.is_over("b.jpg"));
}

TEST_CASE("a restart does not begin a notice again") {
    const TemporaryDirectory house;
    {
        Notices notices(house.path / "notices");
        notices.set_files(with_notice, all, noon);
    }
    Notices notices(house.path / "notices");
    notices.set_files(with_notice, all, noon + 15min);
    CHECK_FALSE(notices.active().empty());
    CHECK(notices.look(noon + 20min));
    CHECK(notices.active().empty());
}

TEST_CASE("a notice without a time stays until it is taken away, and begins anew when it comes back") {
    Notices notices("");
    notices.set_files(std::vector<MediaRecord>{photo("!NOW 1min.jpg"), photo("!NOW.jpg")}, all, noon);
    (void)notices.look(noon + 1min);
    CHECK(notices.active() == "!NOW.jpg");
    CHECK(notices.set_files(std::vector<MediaRecord>{photo("b.jpg")}, all, noon + 2min));
    CHECK(notices.active().empty());
    CHECK(notices.set_files(std::vector<MediaRecord>{photo("!NOW 1min.jpg")}, all, noon + 3min));
    CHECK(notices.active() == "!NOW 1min.jpg");
}

TEST_CASE("of two notices the one that came last covers the walls, then the other") {
    Notices notices("");
    const std::vector<MediaRecord> first{photo("!NOW 10min a.jpg")};
    std::vector<MediaRecord> both = first;
    both.push_back(photo("!NOW 1min b.jpg"));
    notices.set_files(first, all, noon);
    notices.set_files(both, all, noon + 1min);
    CHECK(notices.active() == "!NOW 1min b.jpg");
    notices.look(noon + 2min);
    CHECK(notices.active() == "!NOW 10min a.jpg");
}

TEST_CASE("a clock that is set back does not make a notice longer than its time") {
    Notices notices("");
    notices.set_files(with_notice, all, noon);
    notices.look(noon - 24h);
    CHECK(notices.look(noon - 24h + 20min));
    CHECK(notices.active().empty());
}

TEST_CASE("a note that is damaged begins the notices of today") {
    const TemporaryDirectory house;
    for (const char* text : {"x y", "12 zz", "99999999999999999999999 00", ""}) {
        house.write("notices", text);
        Notices notices(house.path / "notices");
        notices.set_files(with_notice, all, noon);
        CHECK(notices.active() == "!NOW 20min fire");
    }
}

TEST_CASE(
    "a notice of which no file can be shown covers nothing, and its time begins with the first that can") {
    Notices notices("");
    CHECK_FALSE(notices.set_files(with_notice, none, noon));
    CHECK_FALSE(notices.is_covered("b.jpg"));
    CHECK(notices.set_files(with_notice, all, noon + 1h));
    CHECK(notices.is_covered("b.jpg"));
    CHECK(notices.set_files(with_notice, none, noon + 1h + 5min));  // taken off the wall
    CHECK_FALSE(notices.is_covered("b.jpg"));
    CHECK(notices.set_files(with_notice, all, noon + 1h + 10min));  // its time has gone on
    CHECK(notices.look(noon + 1h + 20min));
}
