#include "base/hints/notice.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace std::chrono_literals;

TEST_CASE("a notice is told by the begin of a name directly in the media folder") {
    CHECK(notice_named("!NOW 20min Fire drill/a.jpg") == Notice{"!NOW 20min Fire drill", 20min});
    CHECK(notice_named("!NOW 20min Fire drill/deep/a.jpg") == Notice{"!NOW 20min Fire drill", 20min});
    CHECK(notice_named("!now_90s.jpg") == Notice{"!now_90s.jpg", 90s});
    CHECK(notice_named("!NOW 2h x.jpg") == Notice{"!NOW 2h x.jpg", 2h});
    CHECK(notice_named("!NOW.jpg") == Notice{"!NOW.jpg", std::nullopt});
    CHECK(notice_named("!NOW party/a.jpg") == Notice{"!NOW party", std::nullopt});
    CHECK(notice_named("!NOW 25h/a.jpg") == Notice{"!NOW 25h", std::nullopt});
    CHECK(notice_named("!NOW 0s/a.jpg") == Notice{"!NOW 0s", std::nullopt});
    for (const char* path :
         {"", "!", "a/!NOW 20min/b.jpg", "_INBOX/!NOW 20min/b.jpg", "NOW 20min/a.jpg", "!NOWHERE/a.jpg"})
        CHECK_FALSE(notice_named(path));
}
