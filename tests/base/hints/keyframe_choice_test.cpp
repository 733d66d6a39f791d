#include "base/hints/keyframe_choice.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace vitrine;
using namespace std::chrono_literals;

TEST_CASE("a choice of keyframes is read, in order and once each") {
    const KeyframeFile file =
        read_keyframe_choice("keyframes = [\"1:02\", 34.5, 12, \"0:12\"]\nstrike = [\"1:00:03.25\"]\n", "a");
    CHECK(file.faults.empty());
    CHECK(file.choice.keyframes == std::vector<std::chrono::nanoseconds>{12s, 34500ms, 62s});
    CHECK(file.choice.struck == std::vector<std::chrono::nanoseconds>{3603250ms});
    CHECK_FALSE(file.choice.is_only);
    CHECK(in_words(file.choice) == "3 keyframes chosen, 1 struck");
    CHECK(in_words({.keyframes = {1s}, .struck = {}, .is_only = true}) == "only 1 keyframe chosen");
    CHECK(in_words({.keyframes = {}, .struck = {1s, 2s}}) == "2 keyframes struck");
    CHECK(in_words(KeyframeChoice{}).empty());
}

TEST_CASE("a wrong line is named with its file, and the others count") {
    const KeyframeFile file =
        read_keyframe_choice("keyframes = [\"0:12\"]\nstrike = [\"soon\"]\nkeyframe = 3\nonly = \"yes\"\n",
                             "film.mp4.tapestry.toml");
    REQUIRE(file.faults.size() == 3);
    CHECK(file.choice.keyframes.size() == 1);
    CHECK(file.choice.struck.empty());
    for (const char* line : {":2: ", ":3: ", ":4: "})
        CHECK(std::ranges::any_of(file.faults, [&](const std::string& fault) {
            return fault.starts_with(std::string("film.mp4.tapestry.toml") + line);
        }));
    for (const char* text : {"only = true", "keyframes = 7", "keyframes = [-1]", "keyframes = [1e9]",
                             "keyframes = [nan]", "keyframes = [[1]]", "keyframes = ", "[=show]"}) {
        const KeyframeFile wrong = read_keyframe_choice(text, "a");
        CHECK_MESSAGE(wrong.faults.size() == 1, text);
        CHECK_MESSAGE(wrong.choice == KeyframeChoice{}, text);
    }
    std::string many = "keyframes = [0";
    for (int i = 1; i <= 1000; ++i)
        many += "," + std::to_string(i);
    CHECK(read_keyframe_choice(many + "]", "a").faults.size() == 1);
}

TEST_CASE("moments are seconds, or minutes and hours with colons") {
    CHECK(moment_named("0") == 0s);
    CHECK(moment_named("90.5") == 90500ms);
    CHECK(moment_named("90:00") == 90min);
    CHECK(moment_named("2:00:01") == 2h + 1s);
    for (const char* text : {"", ":", "1:", ":1", "1:60", "1:2:3:4", "1.5:00", "-1", "1:-1", " 1", "1s",
                             "inf", "nan", "1e3", "0x10", "999999999"})
        CHECK_MESSAGE(!moment_named(text), text);
}

TEST_CASE("equal choices have one text and one key, which the text gives back; none has none") {
    const KeyframeChoice choice{.keyframes = {0s, 1001ms, 3603250ms}, .struck = {1h}, .is_only = true};
    const KeyframeFile again = read_keyframe_choice(to_toml(choice), "a");
    CHECK(again.faults.empty());
    CHECK(again.choice == choice);
    CHECK(key_of(again.choice) == key_of(choice));
    KeyframeChoice other = choice;
    other.is_only = false;
    CHECK(key_of(other) != key_of(choice));
    CHECK(key_of({}).empty());
    CHECK(to_toml({}).empty());
}

TEST_CASE("the file of a film's keyframes has the film's whole name and an ending") {
    CHECK(is_keyframe_file("film.mp4.tapestry.toml"));
    CHECK_FALSE(is_keyframe_file(".tapestry.toml"));
    CHECK_FALSE(is_keyframe_file("film.mp4"));
    CHECK_FALSE(is_keyframe_file(".vitrine.toml"));
}

TEST_CASE("a technician's touches come to the choice of a file, and count where the two contradict") {
    const KeyframeChoice file{.keyframes = {2s, 10s}, .struck = {20s, 30s}, .is_only = true};
    const KeyframeChoice touched{.keyframes = {19600ms, 40s}, .struck = {2400ms, 50s}};
    CHECK(joined_choice(file, touched) ==
          KeyframeChoice{.keyframes = {10s, 19600ms, 40s}, .struck = {2400ms, 30s, 50s}, .is_only = true});
    CHECK(joined_choice({}, touched) == touched);
    CHECK(joined_choice(file, {}) == file);
    CHECK_FALSE(joined_choice({.keyframes = {2s}, .is_only = true}, {.struck = {2s}}).is_only);
}

TEST_CASE("a joined choice has no more moments than a file may have") {
    KeyframeChoice file;
    KeyframeChoice touched{.keyframes = {10000s}};
    for (std::size_t k = 0; k < max_moments_of_a_choice; ++k)
        file.keyframes.emplace_back(std::chrono::seconds(k));
    const KeyframeChoice joined = joined_choice(file, touched);
    CHECK(joined.keyframes.size() == max_moments_of_a_choice);
    CHECK(joined.keyframes.back() == 10000s);
    CHECK(read_keyframe_choice(to_toml(joined), "a").faults.empty());
}
