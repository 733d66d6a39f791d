#include "base/hints/hint_file.hpp"

#include "base/hints/hint_words.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

TEST_CASE("a file of hints says what names say") {
    const HintFile file = read_hints("period = \"2026-12-01..2026-12-24\"\nhours = \"08:30-18:00\"\n"
                                     "seconds = 20\nrepeat = 3\nsound = true\n",
                                     "a");
    CHECK(file.faults.empty());
    CHECK(file.hints == hints_in_name("2026-12-01..2026-12-24 08:30-18:00 20s 3x sound", NamePart::folder));
}

TEST_CASE("a fault names file, line and what is allowed, and what is right counts all the same") {
    const HintFile file = read_hints(
        "seconds = 20\nhuors = \"08-18\"\nhours = \"8 to 6\"\nsound = \"loud\"\n", "summer/.vitrine.toml");
    REQUIRE(file.faults.size() == 3);
    std::string all;
    for (const std::string& fault : file.faults)
        all += fault + "\n";
    CHECK(all.find("summer/.vitrine.toml:2: there is no key 'huors'; there are period, weekdays, hours, "
                   "seconds, repeat, "
                   "sound, caption, qr\n") != std::string::npos);
    CHECK(
        all.find(
            "summer/.vitrine.toml:3: the value of 'hours' is not allowed; it must be times like \"08-18\"") !=
        std::string::npos);
    CHECK(
        all.find("summer/.vitrine.toml:4: the value of 'sound' is not allowed; it must be true or false\n") !=
        std::string::npos);
    CHECK(file.hints == hints_in_name("20s", NamePart::folder));
}

TEST_CASE("numbers out of range and text that is no TOML are faults") {
    for (const char* text :
         {"seconds = 0", "seconds = 86401", "seconds = 2.5", "repeat = -1", "repeat = 21",
          "period = \"2026-02-30..\"", "hours = 8", "sound = 1", "seconds = [1]", "[hours]\na = 1"})
        CHECK_MESSAGE(read_hints(text, "a").faults.size() == 1, text);
    const HintFile broken = read_hints("seconds = 20\nhours = \n", "a");
    REQUIRE(broken.faults.size() == 1);
    CHECK(broken.faults[0].starts_with("a:"));
    CHECK(broken.hints == Hints{});
    const HintFile nameless = read_hints("[=show]", "a");
    REQUIRE(nameless.faults.size() == 1);
    CHECK(nameless.faults[0].starts_with("a:1: "));
}
