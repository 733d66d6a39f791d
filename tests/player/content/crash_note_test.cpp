#include "player/content/crash_note.hpp"

#include "base/state/acquittal.hpp"
#include "tests/temporary_directory.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <iterator>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr CrashNote::Time noon{12h};

const MediaRecord evil{.path = "evil.mp4", .bytes = 10, .mtime_ns = 1};
const MediaRecord good{.path = "good.mp4", .bytes = 20, .mtime_ns = 2};

/// A fault of the process itself. ASan would catch it, take a second and write a page.
[[noreturn]] void crash() {
    ::raise(SIGILL);
    ::_exit(1);
}

/// Needs more stack the deeper it gets.
int use_stack(int depth) {
    std::array<volatile char, 8192> room{};
    room[0] = static_cast<char>(depth);
    return depth < 0 ? 0 : use_stack(depth + 1) + room[0];
}

/// A player whose main thread uses up its stack.
void overflow(const std::filesystem::path& state) {
    const pid_t player = ::fork();
    if (player == 0) {
        const stack_t none{.ss_sp = nullptr, .ss_flags = SS_DISABLE, .ss_size = 0};
        ::sigaltstack(&none, nullptr);  // ASan has made one
        CrashNote note(state);
        note.note_opening(evil, noon);
        ::_exit(use_stack(0));
    }
    ::waitpid(player, nullptr, 0);
}

/// A player that plays the good film for a minute, opens the evil one and crashes, or ends well.
void run(const std::filesystem::path& state, bool crashes, std::chrono::seconds after_opening = 0s) {
    const pid_t player = ::fork();
    if (player == 0) {
        CrashNote note(state);
        note.note_opening(good, noon);
        note.note_open(std::set<ContentName>{content_name(good)}, noon + 1min);
        if (!note.is_quarantined(evil)) {
            note.note_opening(evil, noon + 1min);
            note.note_open(std::set<ContentName>{content_name(good), content_name(evil)},
                           noon + 1min + after_opening);
        }
        if (crashes) crash();
        note.end_run();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(player, &status, 0);
}

/// The files that the note lets the player show.
std::vector<MediaRecord> left(CrashNote& note, const std::vector<MediaRecord>& all) {
    std::vector<MediaRecord> free;
    std::ranges::copy_if(all, std::back_inserter(free),
                         [&](const MediaRecord& record) { return !note.is_quarantined(record); });
    note.set_files(free);
    std::erase_if(free, [&](const MediaRecord& record) { return note.is_on_hold(record); });
    return free;
}

/// A player that opens all that is not held back, until everything has been open for a while; it crashes when
/// it opens `poison`, and is killed, where `is_killed`, after its first openings. @return  whether it came to
/// its end
bool show(const std::filesystem::path& state, const std::vector<MediaRecord>& all, const std::string& poison,
          bool is_killed = false) {
    const pid_t player = ::fork();
    if (player == 0) {
        CrashNote note(state);
        std::set<ContentName> open;
        for (auto now = noon; now < noon + 5min; now += 5s) {
            const std::vector<MediaRecord> shown = left(note, all);
            for (const MediaRecord& record : shown) {
                if (!open.insert(content_name(record)).second) continue;
                note.note_opening(record, now);
                if (record.path == poison) crash();
            }
            if (is_killed) ::kill(::getpid(), SIGKILL);
            note.note_open(open, now);
        }
        note.end_run();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(player, &status, 0);
    return WIFSIGNALED(status);
}

std::vector<std::string> quarantined(const std::filesystem::path& state,
                                     const std::vector<MediaRecord>& all) {
    std::vector<std::string> found;
    CrashNote note(state);
    for (const MediaRecord& record : all)
        if (note.is_quarantined(record)) found.push_back(record.path);
    return found;
}

const std::vector<MediaRecord> four{
    {.path = "a.png"}, {.path = "b.avi"}, {.path = "c.png"}, {.path = "d.mp4"}};

}  // namespace

TEST_CASE("of four files that are opened together the second crash shows which one brings the player down") {
    for (const MediaRecord& poison : four) {
        CAPTURE(poison.path);
        const TemporaryDirectory state;
        CHECK(show(state.path, four, poison.path));
        CHECK(quarantined(state.path, four).empty());
        CHECK(show(state.path, four, poison.path));
        CHECK(quarantined(state.path, four) == std::vector{poison.path});
        CHECK_FALSE(show(state.path, four, poison.path));
    }
}

TEST_CASE("a stack that is used up counts as a crash") {
    const TemporaryDirectory state;
    for (int i = 0; i < 2; ++i)
        overflow(state.path);
    CHECK(quarantined(state.path, {evil}) == std::vector{evil.path});
}

TEST_CASE("a player that somebody kills however often loses none of its files") {
    const TemporaryDirectory state;
    for (int kill = 0; kill < 30; ++kill)
        REQUIRE(show(state.path, four, "", true));
    CHECK(read_blame(state.path).empty());
    CHECK(quarantined(state.path, four).empty());
}

TEST_CASE("between kills from outside the file that crashes the player is found, and no other") {
    const TemporaryDirectory state;
    for (int round = 0; round < 10; ++round) {
        show(state.path, four, "b.avi");
        show(state.path, four, "", true);
    }
    CHECK(quarantined(state.path, four) == std::vector<std::string>{"b.avi"});
}

TEST_CASE("after a crash all files are shown again, one after the other") {
    const TemporaryDirectory state;
    CHECK(show(state.path, four, "d.mp4"));
    CrashNote note(state.path);
    std::set<ContentName> open;
    std::vector<std::size_t> counts;
    for (auto now = noon; now < noon + 1min; now += 10s) {
        const std::vector<MediaRecord> shown = left(note, four);
        for (const MediaRecord& record : shown)
            if (open.insert(content_name(record)).second) note.note_opening(record, now);
        counts.push_back(open.size());
        note.note_open(open, now + 10s);
    }
    CHECK(counts == std::vector<std::size_t>{1, 2, 3, 4, 4, 4});
}

TEST_CASE("a film that brings the player down twice when it is opened is quarantined, and no other") {
    const TemporaryDirectory state;
    run(state.path, true);
    CHECK_FALSE(CrashNote(state.path).is_quarantined(evil));
    run(state.path, true);
    CrashNote note(state.path);
    CHECK(note.is_quarantined(evil));
    CHECK_FALSE(note.is_quarantined(good));
}

TEST_CASE("who is acquitted is shown again, and the analyzer hears of it") {
    const TemporaryDirectory state;
    run(state.path, true);
    run(state.path, true);
    CrashNote note(state.path);
    REQUIRE(note.is_quarantined(evil));
    note.acquit("other.mp4");
    CHECK(note.is_quarantined(evil));
    note.acquit("evil.mp4");
    CHECK_FALSE(note.is_quarantined(evil));
    CHECK(read_blame(state.path).empty());
    CHECK(is_acquitted(read_acquittals(state.path), "evil.mp4", {.since = 1s}));
    CHECK_FALSE(is_acquitted(read_acquittals(state.path), "good.mp4", {.since = 1s}));
}

TEST_CASE("a player that ends as it should leaves nothing to blame anybody for") {
    const TemporaryDirectory state;
    for (int i = 0; i < 4; ++i)
        run(state.path, false);
    CHECK(read_blame(state.path).empty());
    CHECK_FALSE(std::filesystem::exists(state.path / playing_file));
}

TEST_CASE("what ended with the machine is nobody's fault") {
    const TemporaryDirectory state;
    state.write(playing_file,
                to_text({.boot = "another", .process = 1, .opening = {content_name(evil)}, .playing = {}}));
    CrashNote note(state.path);
    CHECK(read_blame(state.path).empty());
}

TEST_CASE("a crash long after the last opening is everybody's, for once") {
    const TemporaryDirectory state;
    run(state.path, true, 60s);
    CrashNote note(state.path);
    CHECK(read_blame(state.path) == Blame{{content_name(evil), {1}}, {content_name(good), {1}}});
}

TEST_CASE("ten minutes without a crash forgive what is not quarantined") {
    const TemporaryDirectory state;
    run(state.path, true);
    CrashNote note(state.path);
    REQUIRE(read_blame(state.path).size() == 1);
    note.note_open(std::set<ContentName>{}, noon);
    note.note_open(std::set<ContentName>{}, noon + 11min);
    CHECK(read_blame(state.path).empty());
}

TEST_CASE("a run that ends in order leaves no file") {
    const TemporaryDirectory state;
    CrashNote note(state.path);
    note.note_opening(evil, noon);
    CHECK_FALSE(std::filesystem::is_empty(state.path));
    note.end_run();
    CHECK(std::filesystem::is_empty(state.path));
}

TEST_CASE("a state directory that is not there costs the protection and nothing else") {
    CrashNote note("/proc/nothing/here");
    note.note_opening(evil, noon);
    note.note_open(std::set<ContentName>{content_name(evil)}, noon + 1min);
    note.end_run();
    CHECK_FALSE(note.is_quarantined(evil));
}

TEST_CASE(
    "a file whose reader crashes twice is quarantined while the player runs, and the analyzer is told") {
    const TemporaryDirectory state;
    CrashNote note(state.path);
    note.note_reader_crash(evil, noon);
    CHECK_FALSE(note.note_open({}, noon + 1s));
    CHECK_FALSE(note.is_quarantined(evil));
    note.note_reader_crash(evil, noon + 9min);
    CHECK(note.note_open({}, noon + 9min));
    CHECK(note.is_quarantined(evil));
    CHECK_FALSE(note.note_open({}, noon + 9min));
    CHECK(find_quarantine(
        read_blame(state.path), evil,
        std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())));
}

TEST_CASE(
    "readers of several files that crash within an hour condemn none of them, a later one is judged alone") {
    const TemporaryDirectory state;
    CrashNote note(state.path);
    for (const auto time : {noon, noon + 5min, noon + 10min}) {
        note.note_reader_crash(evil, time);
        note.note_reader_crash(good, time + 1s);
    }
    CHECK_FALSE(note.is_quarantined(evil));
    CHECK_FALSE(note.is_quarantined(good));
    note.note_reader_crash(evil, noon + 3h);
    CHECK(note.is_quarantined(evil));
}
