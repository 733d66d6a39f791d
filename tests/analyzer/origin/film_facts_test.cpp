#include "analyzer/origin/film_facts.hpp"

#include "tests/analyzer/origin/drawn_boxes.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::sys_days day = std::chrono::year(2023) / 5 / 1;
constexpr std::uint64_t epoch_1904 = 2'082'844'800;  // seconds from 1904 to 1970

MediaOrigin facts(const TemporaryDirectory& house, const std::string& bytes) {
    return film_facts(house.write("a.mov", bytes).string());
}

}  // namespace

TEST_CASE("a film was taken at the time of its header, which is UTC") {
    const TemporaryDirectory house;
    const auto seconds = std::chrono::seconds(day.time_since_epoch() + 10h).count();
    const MediaOrigin origin =
        facts(house, movie(movie_header(epoch_1904 + static_cast<std::uint64_t>(seconds))));
    REQUIRE(origin.taken);
    CHECK(origin.taken->at == day + 10h);
    CHECK_FALSE(facts(house, movie(movie_header(0))).taken);
    CHECK_FALSE(facts(house, "nothing").taken);
}

TEST_CASE("QuickTime's own date has a zone and counts first; its identifier is that of a Live Photo") {
    const TemporaryDirectory house;
    const std::string id = "6A9B0C8E-1234-4F5E-9ABC-0123456789AB";
    const MediaOrigin origin =
        facts(house, movie(movie_header(epoch_1904) +
                           entries({{"com.apple.quicktime.make", "Apple"},
                                    {"com.apple.quicktime.content.identifier", id},
                                    {"com.apple.quicktime.creationdate", "2023-05-01T12:30:05+0200"}})));
    REQUIRE(origin.taken);
    CHECK(origin.taken->at == day + 10h + 30min + 5s);
    CHECK(origin.taken->zone == 2h);
    CHECK(origin.content_id == id);
}

TEST_CASE("damaged boxes are read without harm") {
    const TemporaryDirectory house;
    const std::string whole =
        movie(movie_header(1) + entries({{"com.apple.quicktime.creationdate", "2023"}}));
    std::mt19937 engine(1);
    for (int i = 0; i < 300; ++i) {
        std::string bytes = whole;
        for (int k = 0; k < 4; ++k)
            bytes[engine() % bytes.size()] = static_cast<char>(engine());
        (void)facts(house, bytes);
    }
}
