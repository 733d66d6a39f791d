#include "analyzer/watch/leaving_files.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

const FileFacts facts{.bytes = 10, .mtime_ns = 1, .blocks = 8, .inode = 7};
const FileFacts changed{.bytes = 20, .mtime_ns = 2, .blocks = 8, .inode = 7};
constexpr LeavingFiles::Time noon{12h};

}  // namespace

TEST_CASE("a file that comes back unchanged has its record, a changed one has an outdated one") {
    LeavingFiles leaving;
    leaving.add("a", facts, true, noon);
    leaving.add("b", facts, true, noon);
    const LeavingFiles::Return same = leaving.take_back("a", facts);
    const LeavingFiles::Return other = leaving.take_back("b", changed);
    CHECK((same.is_recorded && same.record_holds));
    CHECK((other.is_recorded && !other.record_holds));
    CHECK_FALSE(leaving.take_back("a", facts).is_recorded);
    CHECK(leaving.is_empty());
}

TEST_CASE("a record goes to the new name of the same inode and content, once") {
    LeavingFiles leaving;
    leaving.add("unfinished", facts, false, noon);
    leaving.add("a", facts, true, noon);
    CHECK_FALSE(leaving.take_renamed(changed));
    CHECK(leaving.take_renamed(facts) == "a");
    CHECK_FALSE(leaving.take_renamed(facts));
}

TEST_CASE("each of two thousand renamed files is compared with one of those that vanished") {
    LeavingFiles leaving;
    const auto numbered = [](int i) {
        return FileFacts{.bytes = 10, .mtime_ns = 1, .blocks = 8, .inode = static_cast<std::uint64_t>(i + 1)};
    };
    for (int i = 0; i < 2000; ++i)
        leaving.add("old/" + std::to_string(i), numbered(i), true, noon);
    for (int i = 2000; i-- > 0;)
        CHECK(leaving.take_renamed(numbered(i)) == "old/" + std::to_string(i));
    CHECK(leaving.compared() == 2000);
    CHECK(leaving.is_empty());
}

TEST_CASE("where inodes are not kept nothing is taken for a rename") {
    const FileFacts unknown{.bytes = 10, .mtime_ns = 1};
    LeavingFiles leaving;
    leaving.add("a", unknown, true, noon);
    CHECK_FALSE(leaving.take_renamed(unknown));
}

TEST_CASE("a record goes when its time is over") {
    LeavingFiles leaving;
    leaving.add("a", facts, true, noon + 1s);
    leaving.add("b", facts, true, noon);
    CHECK(leaving.next_expiry() == noon);
    CHECK(leaving.take_expired(noon) == std::vector<std::string>{"b"});
    CHECK(leaving.take_expired(noon).empty());
    CHECK(leaving.next_expiry() == noon + 1s);
}
