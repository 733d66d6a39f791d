#include "player/scene/files/moments.hpp"

#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::sys_days day = std::chrono::year(2026) / 7 / 4;

MediaRecord taken(const std::string& path, std::chrono::minutes time,
                  TimeSource source = TimeSource::camera) {
    MediaRecord record = photo(path);
    record.origin.taken = TimeTaken{.at = day + time, .zone = 120min, .source = source};
    return record;
}

}  // namespace

TEST_CASE("files that cameras took without a long pause are one moment") {
    const std::vector<MediaRecord> records{taken("a", 12h + 5min),
                                           taken("b", 14h),
                                           taken("c", 15h + 20min),
                                           taken("alone", 19h),
                                           taken("late", 21h + 50min),
                                           taken("night", 23h + 30min),
                                           taken("copied", 14h, TimeSource::file),
                                           photo("undated")};
    const Moments moments{RecordList(records)};
    for (const char* path : {"a", "b", "c"})
        CHECK(moments.words_for(path) == "taken on 2026-07-04 between 14:05 and 17:20, with 2 others");
    CHECK(moments.words_for("night") ==
          "taken on 2026-07-04 between 23:50 and 2026-07-05 01:30, with 1 other");
    for (const char* path : {"alone", "copied", "undated", "missing"})
        CHECK(moments.words_for(path).empty());
}
