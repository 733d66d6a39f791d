#include "base/hints/folder_hints.hpp"

#include "base/hints/hint_words.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

Hints folder(std::string_view name) {
    return hints_in_name(name, NamePart::folder);
}

}  // namespace

TEST_CASE("folders, what is in them and the name itself are merged in this order") {
    const FolderHints folders{
        {"", folder("10s 2x")}, {"08-18 a", folder("09-17 30s")}, {"08-18 a/b", folder("sound")}};
    CHECK(hints_of("x.jpg", folders) == folder("10s 2x"));
    CHECK(hints_of("40s x.jpg", folders) == folder("40s 2x"));
    CHECK(hints_of("08-18 a/x.jpg", folders) == folder("09-17 30s 2x"));
    CHECK(hints_of("08-18 a/b/mute x.jpg", folders) == folder("09-17 30s 2x mute"));
    CHECK(hints_of("08-18 c/20-22 d/x.jpg", {}) == folder("20-22"));
    CHECK(hints_of("08-18 c/12-14 team.jpg", {}) == folder("08-18"));  // hours only where a folder says them
}

TEST_CASE("what the analyzer tells of folders is what the player reads, whatever their names") {
    const FolderHints folders{{"", folder("22-06")},
                              {"a \"b\"\nc", folder("2026-12-01.. 20s 3x sound")},
                              {"\xff\xfe", folder("..2026-12-24 mute")}};
    CHECK(folder_hints_from_json(to_json(folders)) == folders);
    CHECK(folder_hints_from_json(to_json(FolderHints{})).empty());
}

TEST_CASE("what is no list of hints is refused") {
    for (const char* text :
         {"", "{}", "[]", "null", R"({"version":2,"folders":[]})", R"({"version":1})",
          R"({"version":1,"folders":[{"folder":"a","hours":"8"}]})",
          R"({"version":1,"folders":[{"folder":"a","seconds":0}]})",
          R"({"version":1,"folders":[{"folder":"a","sound":"x"}]})",
          R"({"version":1,"folders":[{"folder":"a","folder_hex":"zz"}]})", R"({"version":1,"folders":[3]})"})
        CHECK_THROWS_AS(folder_hints_from_json(text), std::runtime_error);
}
