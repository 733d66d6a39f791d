#include "base/calendar/day_times.hpp"
#include "base/hints/hint_words.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

std::chrono::local_days day(int year, unsigned month, unsigned of_month) {
    return std::chrono::local_days(std::chrono::year(year) / std::chrono::month(month) /
                                   std::chrono::day(of_month));
}

Hints folder(std::string_view name) {
    return hints_in_name(name, NamePart::folder);
}

Hints file(std::string_view name) {
    return hints_in_name(name, NamePart::file);
}

const Hints nothing;

}  // namespace

TEST_CASE("a period is of whole days and may be open at one side") {
    CHECK(folder("2026-12-01..2026-12-24 Advent").period ==
          Period{.first = day(2026, 12, 1), .last = day(2026, 12, 24)});
    CHECK(folder("2026-12-01.. Winter").period == Period{.first = day(2026, 12, 1)});
    CHECK(folder("..2026-12-24 Advent").period == Period{.last = day(2026, 12, 24)});
    CHECK(folder("from 2026-12-01 until 2026-12-24 Advent").period ==
          Period{.first = day(2026, 12, 1), .last = day(2026, 12, 24)});
    CHECK(folder("until 2026-12-24").period == Period{.last = day(2026, 12, 24)});
    CHECK(file("2028-02-29..2028-02-29 leap day.jpg").period ==
          Period{.first = day(2028, 2, 29), .last = day(2028, 2, 29)});
}

TEST_CASE("hours go over midnight and to the minute, with a point where a share takes no colon") {
    CHECK(folder("08-18 Daytime").hours == Hours{8h, 18h});
    CHECK(folder("22-06").hours == Hours{22h, 6h});
    CHECK(folder("18-24 Evening").hours == Hours{18h, 24h});
    CHECK(folder("08:30-18:00 Open").hours == Hours{8h + 30min, 18h});
    CHECK(folder("08.30-18.00 Open").hours == Hours{8h + 30min, 18h});
    CHECK(file("08.30-18.00 menu.jpg").hours == Hours{8h + 30min, 18h});
    CHECK(file("12.00-14.00.jpg").hours == Hours{12h, 14h});
}

TEST_CASE("weekdays have English and German names, or numbers") {
    const auto days = [](std::string_view name) { return folder(name).weekdays.value_or(Weekdays{}).days; };
    CHECK(days("Mo-Fr menu") == 0b0011111);
    CHECK(days("mon-fri_menu") == 0b0011111);
    CHECK(days("Montag-Freitag") == 0b0011111);
    CHECK(days("1-5 menu") == 0b0011111);
    CHECK(days("Fr-Mo long weekend") == 0b1110001);
    CHECK(days("Di,Do,Sonnabend market") == 0b0101010);
    CHECK(days("Tu,Thu,Saturday market") == 0b0101010);
    CHECK(days("Mo-Mi,Sa-So x") == 0b1100111);
    CHECK(days("Mo-Fr 08-18 menu") == 0b0011111);
    CHECK(folder("Mo-Fr 08-18 menu").hours == Hours{8h, 18h});
    CHECK(file("Mo-Fr menu.jpg").weekdays == Weekdays{0b0011111});
}

TEST_CASE("a single day is a hint only where a time follows, or as the whole name of a folder") {
    CHECK(folder("Sunday").weekdays == Weekdays{0b1000000});
    CHECK(folder("Sun 10-18 brunch").weekdays == Weekdays{0b1000000});
    CHECK(folder("So 2026-12-01..2026-12-24 market").weekdays == Weekdays{0b1000000});
    CHECK(folder("Sun") == nothing);
    CHECK(folder("Sunday in the park") == nothing);
    CHECK(folder("Do it yourself") == nothing);
    CHECK(folder("Mo-Mo x") == nothing);
    CHECK(folder("Mo-Fri-Sa x") == nothing);
    CHECK(folder("Mo, x") == nothing);
    CHECK(folder("0-5 x") == nothing);
    CHECK(folder("1,2 x") == nothing);
    CHECK(file("Sunday.jpg") == nothing);
    CHECK(file("1-5 menu.jpg") == nothing);
}

TEST_CASE("seconds, repetition and sound are words of their own") {
    CHECK(file("20s name.jpg").dwell == 20s);
    CHECK(file("3x_name.jpg").repeat == 3);
    CHECK(file("sound choir.mp4").sound == true);
    CHECK(folder("mute").sound == false);
    const Hints all = file("2026-12-01..2026-12-24 08.00-18.00 20s 3x sound carol.mp4");
    CHECK(all == Hints{.period = Period{.first = day(2026, 12, 1), .last = day(2026, 12, 24)},
                       .hours = Hours{8h, 18h},
                       .dwell = 20s,
                       .repeat = 3,
                       .sound = true});
}

TEST_CASE("a word that merely resembles a hint is a name") {
    for (const char* name : {"2026 holiday.jpg",
                             "12-14 team.jpg",
                             "2026-12-24 party.jpg",
                             "20secs.jpg",
                             "20 s.jpg",
                             "s.jpg",
                             "x.jpg",
                             "4x4 desert.jpg",
                             "10x15.jpg",
                             "0s.jpg",
                             "020s a.jpg",
                             "0x41.jpg",
                             "21x far.jpg",
                             "86401s.jpg",
                             "20S a.jpg",
                             "Sound.mp4",
                             "soundcheck.mp4",
                             "muted.mp4",
                             "family 20s.jpg",
                             "from Berlin.jpg",
                             "until 2026.jpg",
                             "2026-12-01...2026-12-24 a.jpg",
                             "2026-02-30..2026-03-01 a.jpg",
                             "2026-13-01.. a.jpg",
                             "...jpg",
                             "..",
                             ".",
                             "",
                             "2026-12-24..2026-12-01 backwards.jpg",
                             "26-12-01..26-12-24 a.jpg",
                             "08.60-09.00 a.jpg",
                             "24.30-25.00 a.jpg",
                             "08.00-18 a.jpg",
                             "1.5-2.5 litres.jpg",
                             "\xff\xfe 20s.jpg"})
        CHECK_MESSAGE(file(name) == nothing, name);
    for (const char* name : {"8-18 a", "08-08 a", "08-25 a", "24-06 a", "08-18-20 a", "0818 a", "08 - 18 a",
                             "08–18 a", "2026-12-01 .. 2026-12-24 a", "12-14team"})
        CHECK_MESSAGE(folder(name) == nothing, name);
}

TEST_CASE("hints end where the name begins") {
    CHECK(file("20s summer 3x.jpg") == Hints{.dwell = 20s});
    CHECK(file("20s 30s.jpg") == Hints{.dwell = 20s});
    CHECK(folder("08-18 12-14 noon") == Hints{.hours = Hours{8h, 18h}});
    CHECK(file("20s") == Hints{.dwell = 20s});
    CHECK(file("20s.3x") == Hints{.dwell = 20s});  // "3x" is its extension
}

TEST_CASE("whatever bytes a name has, what is taken of it can be written and read again") {
    std::mt19937 engine(7);
    const std::string alphabet = "0123456789-.:sx _2026mutesoundfromuntil\xc3\xa4\n\"/";
    int taken = 0;
    for (int i = 0; i < 200'000; ++i) {
        std::string name;
        for (std::size_t length = engine() % 16; length > 0; --length)
            name += alphabet[engine() % alphabet.size()];
        for (const NamePart part : {NamePart::folder, NamePart::file}) {
            const Hints hints = hints_in_name(name, part);
            taken += hints == nothing ? 0 : 1;
            if (hints.hours) CHECK(hours_named(to_text(*hints.hours)) == hints.hours);
            if (hints.period) CHECK(period_named(to_text(*hints.period)) == hints.period);
            if (hints.dwell) CHECK((*hints.dwell >= 1s && *hints.dwell <= 24h));
            if (hints.repeat) CHECK((*hints.repeat >= 1 && *hints.repeat <= max_repeats));
        }
    }
    CHECK(taken > 100);
}

TEST_CASE("a folder's name is shown without its hints") {
    CHECK(shown_folder_name("Italy/2026_summer") == "2026 summer");
    CHECK(shown_folder_name("08-18 20s Day_at the sea") == "Day at the sea");
    CHECK(shown_folder_name("a/from 2026-12-01 until 2026-12-24 Advent") == "Advent");
    CHECK(shown_folder_name("until lunch") == "until lunch");
    CHECK(shown_folder_name("08-18") == "08-18");
    CHECK(shown_folder_name("x/01_Rooms") == "Rooms");
    CHECK(shown_folder_name("\xff") == "\xff");
}

TEST_CASE("the plain name of a folder or file has no hints, no number for ordering and no extension") {
    CHECK(plain_name("20s 3x 01_Summer in_the city", NamePart::folder) == "Summer in the city");
    CHECK(plain_name("007. bond.jpg", NamePart::file) == "bond");
    CHECK(plain_name("1987", NamePart::folder) == "1987");
    CHECK(plain_name("2019", NamePart::folder) == "2019");
    CHECK(plain_name("2019 winter", NamePart::folder) == "2019 winter");
    CHECK(plain_name("12", NamePart::folder) == "12");
    CHECK(plain_name("20s", NamePart::folder).empty());
    CHECK(plain_name("sound_", NamePart::folder).empty());
}
