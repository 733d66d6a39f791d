#include "base/state/blame.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

namespace {

const ContentName film{.id = "0123456789abcdef", .bytes = 10, .mtime_ns = 1};
const ContentName photo{.id = "fedcba9876543210", .bytes = 20, .mtime_ns = 2};
const ContentName third{.id = "00000000000000ff", .bytes = 30, .mtime_ns = 3};

MediaRecord record_named(const std::string& path) {
    return {.path = path, .bytes = 10, .mtime_ns = 1};
}

constexpr std::chrono::seconds noon{1'800'000'000};

Blame crashes(int count, const PlayingNote& note) {
    Blame blame;
    for (int i = 0; i < count; ++i)
        blame = blame_after(blame, note, noon);
    return blame;
}

bool is_quarantined(const Blame& blame, const MediaRecord& record, std::chrono::seconds now = noon) {
    return find_quarantine(blame, record, now).has_value();
}

}  // namespace

TEST_CASE("a content that was being opened in two crashes in a row is quarantined, until it changes") {
    MediaRecord record = record_named("evil.mp4");
    const PlayingNote note{.opening = {content_name(record)}, .playing = {photo}};
    CHECK_FALSE(is_quarantined(crashes(1, note), record));
    CHECK(is_quarantined(crashes(2, note), record));
    CHECK(crashes(9, note).size() == 1);  // a file that merely played has no part in it

    record.mtime_ns = 2;
    CHECK_FALSE(is_quarantined(crashes(2, note), record));
}

TEST_CASE("a content that played in four crashes in a row is quarantined, not one that played in some") {
    const MediaRecord record = record_named("evil.mp4");
    const ContentName evil = content_name(record);
    CHECK_FALSE(is_quarantined(crashes(3, {.playing = {evil}}), record));
    CHECK(is_quarantined(crashes(4, {.playing = {evil}}), record));

    Blame blame = crashes(3, {.playing = {evil, photo}});
    blame = blame_after(blame, {.playing = {photo, film}}, noon);
    CHECK_FALSE(blame.contains(evil));
    CHECK(blame.at(photo).points == quarantine_points);
    CHECK(blame.at(film).points == 1);
}

TEST_CASE(
    "where several contents would be quarantined at once they stay suspects, and the next crash decides") {
    Blame blame = crashes(2, {.opening = {film, photo, third}});
    CHECK(blame == Blame{{film, {3}}, {photo, {3}}, {third, {3}}});
    blame = blame_after(blame, {.opening = {photo}, .playing = {film}}, noon);
    CHECK(blame == Blame{{photo, {quarantine_points, noon, 1}}});
    CHECK(blame_after(blame, {.opening = {photo, film}}, noon).at(film).points == 2);
}

TEST_CASE("one that is quarantined stays so whoever crashes next") {
    Blame blame = crashes(2, {.opening = {film}});
    blame = blame_after(blame, {.opening = {photo}}, noon);
    CHECK(blame.at(film).points == quarantine_points);
}

TEST_CASE("a content that crashed its own reader twice is quarantined, unless other contents did so, too") {
    const MediaRecord record = record_named("evil.mp4");
    const ContentName evil = content_name(record);
    const Blame once = blame_after_reader({}, evil, true, noon);
    CHECK_FALSE(is_quarantined(once, record));
    CHECK(is_quarantined(blame_after_reader(once, evil, true, noon), record));
    Blame doubtful = once;
    for (int i = 0; i < 5; ++i)
        doubtful = blame_after_reader(doubtful, evil, false, noon);
    CHECK_FALSE(is_quarantined(doubtful, record));
    CHECK(is_quarantined(blame_after_reader(doubtful, evil, true, noon), record));
}

TEST_CASE("a quarantine ends after a day, and one more crash begins another that lasts a week") {
    using namespace std::chrono_literals;
    const MediaRecord record = record_named("evil.mp4");
    const PlayingNote note{.opening = {content_name(record)}, .playing = {}};
    Blame blame = crashes(2, note);
    CHECK(is_quarantined(blame, record, noon + 23h));
    CHECK_FALSE(is_quarantined(blame, record, noon + 24h));
    blame = blame_after(blame, {.opening = {photo}}, noon + 25h);  // of another file
    CHECK_FALSE(is_quarantined(blame, record, noon + 25h));
    blame = blame_after(blame, note, noon + 26h);
    CHECK(is_quarantined(blame, record, noon + 7 * 24h));
    CHECK_FALSE(is_quarantined(blame, record, noon + 26h + 7 * 24h));
}

TEST_CASE("note and blame are read as they were written, and nonsense is nothing") {
    const PlayingNote note{.boot = "b-1", .process = 7, .opening = {film}, .playing = {photo, third}};
    CHECK(playing_note_from(to_text(note)) == note);
    const Blame blame{{film, {1}}, {photo, {4, noon, 2}}};
    CHECK(blame_from(to_text(blame)) == blame);

    CHECK(blame_from("3 0123456789abcdef 10 1\n") == Blame{{film, {3}}});  // of an earlier version

    CHECK(playing_note_from("opening\nplaying x y z\nrun\n\n\xff\n") == PlayingNote{});
    CHECK(blame_from("4\n-1 a 1 1\n99 a 1 1\nx y\n").empty());
}
