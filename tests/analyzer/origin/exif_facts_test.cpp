#include "analyzer/origin/exif_facts.hpp"

#include "tests/analyzer/origin/drawn_exif.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>
#include <span>
#include <string>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

constexpr int original = 0x9003;
constexpr int original_zone = 0x9011;
constexpr int original_fraction = 0x9291;
constexpr std::chrono::sys_days day = std::chrono::year(2023) / 5 / 1;

MediaOrigin facts(const DrawnExif& exif) {
    const std::string bytes = exif.bytes();
    return exif_facts(std::as_bytes(std::span(bytes)));
}

std::string fraction(std::uint32_t number) {
    return number_bytes(number, 4) + number_bytes(1, 4);
}

/// The zone of the machine for one test.
struct MachineZone {
    explicit MachineZone(const char* name) { ::setenv("TZ", name, 1); }

    MachineZone(const MachineZone&) = delete;
    MachineZone& operator=(const MachineZone&) = delete;

    ~MachineZone() { ::unsetenv("TZ"); }
};

}  // namespace

TEST_CASE("a photo's time counts in the zone that the camera wrote") {
    const MediaOrigin origin = facts({.photo = {{original, 2, "2023:05:01 12:30:05"},
                                                {original_zone, 2, "+02:00"},
                                                {original_fraction, 2, "25"}}});
    REQUIRE(origin.taken);
    CHECK(origin.taken->at == day + 10h + 30min + 5s + 250ms);
    CHECK(origin.taken->zone == 2h);
    CHECK(origin.taken->source == TimeSource::camera);
}

TEST_CASE("without a zone the satellites' time tells it") {
    const std::string time = fraction(18) + fraction(59) + fraction(50);
    const MediaOrigin origin = facts(
        {.photo = {{original, 2, "2023:05:01 12:30:05"}}, .gps = {{0x1d, 2, "2023:05:01"}, {0x07, 5, time}}});
    REQUIRE(origin.taken);
    CHECK(origin.taken->at == day + 19h + 5s);
    CHECK(origin.taken->zone == -(6h + 30min));
    CHECK(origin.taken->source == TimeSource::camera);
}

TEST_CASE("without both it is the zone of this machine, as it was then") {
    const MachineZone zone("Europe/Berlin");
    const MediaOrigin summer = facts({.photo = {{original, 2, "2023:05:01 12:30:05"}}});
    REQUIRE(summer.taken);
    CHECK(summer.taken->at == day + 10h + 30min + 5s);
    CHECK(summer.taken->source == TimeSource::camera_clock);
    const MediaOrigin winter = facts({.photo = {{original, 2, "2023:01:01 12:00:00"}}});
    REQUIRE(winter.taken);
    CHECK(winter.taken->zone == 1h);
}

TEST_CASE("the time of digitising, then that of the file's change counts where no other is") {
    const MediaOrigin digitised = facts({.main = {{0x0132, 2, "2024:01:01 00:00:00"}},
                                         .photo = {{original, 2, "    :  :     :  :  "},
                                                   {0x9004, 2, "2023:05:01 00:00:00"},
                                                   {0x9012, 2, "Z"}}});
    REQUIRE(digitised.taken);
    CHECK(digitised.taken->at == day);
    const MediaOrigin changed = facts({.main = {{0x0132, 2, "2023:05:01 00:00:00"}}});
    REQUIRE(changed.taken);
    CHECK(changed.taken->local() == std::chrono::local_days(std::chrono::year(2023) / 5 / 1));
}

TEST_CASE("a time that does not exist is none") {
    for (const char* text :
         {"0000:00:00 00:00:00", "2023:02:30 10:00:00", "2023:05:01 25:00:00", "", "yesterday"}) {
        CAPTURE(text);
        CHECK_FALSE(facts({.photo = {{original, 2, text}}}).taken);
    }
}

TEST_CASE("the notes of Apple's cameras have the identifier of a Live Photo") {
    const std::string id = "6A9B0C8E-1234-4F5E-9ABC-0123456789AB";
    const auto big = [](std::uint64_t value, int count) {
        const std::string bytes = number_bytes(value, count);
        return std::string(bytes.rbegin(), bytes.rend());
    };
    const std::string note = std::string("Apple iOS\0", 10) + std::string("\0\1MM", 4) + big(2, 2) +
                             big(1, 2) + big(9, 2) + big(1, 4) + big(7, 4) + big(17, 2) + big(2, 2) +
                             big(id.size() + 1, 4) + big(44, 4) + big(0, 4) + id + '\0';
    CHECK(facts({.photo = {{0x927c, 7, note}}}).content_id == id);
    CHECK(facts({.photo = {{0x927c, 7, note.substr(0, 30)}}}).content_id.empty());
}

TEST_CASE("any bytes are read without harm") {
    const DrawnExif exif{.main = {{0x0132, 2, "2023:05:01 00:00:00"}},
                         .photo = {{original, 2, "2023:05:01 12:30:05"}, {0x927c, 7, "Apple iOS"}},
                         .gps = {{0x07, 5, fraction(1) + fraction(2) + fraction(3)}}};
    std::mt19937 engine(1);
    for (int i = 0; i < 2000; ++i) {
        std::string bytes = exif.bytes();
        for (int k = 0; k < 8; ++k)
            bytes[engine() % bytes.size()] = static_cast<char>(engine());
        bytes.resize(engine() % (bytes.size() + 1));
        (void)exif_facts(std::as_bytes(std::span(bytes)));
    }
}
