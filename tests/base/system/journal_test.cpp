#include "base/system/journal.hpp"

#include "base/system/log.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

using namespace vitrine;
using log::Level;

TEST_CASE("the journal gets words, priority and what they are about") {
    const auto entry = log::journal_entry(Level::warning, "unsupported: 'a\n.jpg'",
                                          {{"VITRINE_FILE", "a\n.jpg"}, {"VITRINE_STATE", "unsupported"}});
    const auto has = [&](const std::string& assignment) {
        return std::ranges::find(entry, assignment) != entry.end();
    };
    CHECK(has("MESSAGE=unsupported: 'a\\x0a.jpg'"));
    CHECK(has("PRIORITY=4"));
    CHECK(has("VITRINE_FILE=a\n.jpg"));
    CHECK(has("VITRINE_STATE=unsupported"));
}

TEST_CASE("the journal is told from a file that only inherits its name") {
    struct stat info {};

    REQUIRE(::fstat(STDERR_FILENO, &info) == 0);
    ::setenv("JOURNAL_STREAM", fmt::format("{}:{}", info.st_dev, info.st_ino).c_str(), 1);
    CHECK(log::is_journal(STDERR_FILENO));
    ::setenv("JOURNAL_STREAM", "1:1", 1);
    CHECK_FALSE(log::is_journal(STDERR_FILENO));
    ::unsetenv("JOURNAL_STREAM");
    CHECK_FALSE(log::is_journal(STDERR_FILENO));
}
