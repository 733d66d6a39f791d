#include "player/content/visible_files.hpp"

#include "base/state/record_json.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/machine.hpp"
#include "player/content/crash_signal.hpp"
#include "player/input/rehearsal.hpp"
#include "tests/player/scene/scene_media.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <optional>
#include <thread>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr VisibleFiles::Time noon{12h};
const Rehearsal at_seven("0 clock 2026-12-24 07:00:00");
const Rehearsal at_eight_pm("0 clock 2026-12-24 20:00:00");

/// A state directory that the analyzer has filled, and the player's list of it.
struct House {
    explicit House(const std::vector<MediaRecord>& records) {
        for (const MediaRecord& record : records)
            catalogue.store(record);
    }

    void open(const Rehearsal* rehearsal = nullptr) {
        files.emplace(loop, state.path, ShowDays{}, rehearsal, [this] { ++changes; });
    }

    /// Lets the player look a second later than the last time.
    void look(const WallContent& content = {}) {
        time += 1s;
        files->look(time, noon + time, [&] { return content; });
    }

    FileVisibility why(const std::string& path) { return files->judge(*files->catalogue().find(path)); }

    bool may_show(const std::string& path) { return find_file(path) != nullptr; }

    RecordList::Record find_file(const std::string& path) const { return files->records().find(path); }

    std::string written() const {
        for (int tries = 0; tries < 200 && !fs::exists(state.path / visible_file); ++tries)
            std::this_thread::sleep_for(10ms);
        return read_file(state.path / visible_file);
    }

    TemporaryDirectory state;
    Catalogue catalogue{state.path / "catalogue"};
    EventLoop loop;
    std::optional<VisibleFiles> files;
    std::chrono::nanoseconds time{0};
    int changes = 0;
};

/// A list made anew each time.
JudgedFiles::List one_file() {
    return JudgedFiles::List({std::make_shared<const FileVisibility>(FileVisibility{.path = "a.jpg"})});
}

/// The process of a player that is not there any more.
int dead_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

/// Leaves the note of a player that crashed while it opened these files.
void crash(const fs::path& state, const std::vector<MediaRecord>& opening) {
    PlayingNote note{.boot = {}, .process = dead_process(), .opening = {}, .playing = {}};
    std::ifstream("/proc/sys/kernel/random/boot_id") >> note.boot;
    for (const MediaRecord& record : opening)
        note.opening.insert(content_name(record));
    replace_file(state / playing_file, to_text(note));
    replace_file(state / crashed_file, "11\n");
}

}  // namespace

TEST_CASE("a notice is shown in place of everything, and whole") {
    House house({photo("!NOW 20min fire/a.jpg"), photo("b.jpg")});
    house.open();
    REQUIRE(house.files->records().size() == 1);
    const MediaRecord shown = **house.files->records().begin();
    CHECK(shown.path == "!NOW 20min fire/a.jpg");
    const Polygon whole{{0, 0}, {640, 0}, {640, 360}, {0, 360}};
    CHECK(shown.shots.front().region.polygon == whole);
    CHECK(house.files->judge(*house.files->catalogue().find("b.jpg")).visibility == Visibility::covered);
}

TEST_CASE("a notice whose only picture is taken off the wall, or has not come, covers nothing") {
    House house({photo("!NOW fire.jpg"), photo("b.jpg")});
    SUBCASE("taken off") {
        house.open();
        CHECK_FALSE(house.may_show("b.jpg"));
        house.files->set_dismissed({"!NOW fire.jpg"});
        CHECK(house.may_show("b.jpg"));
        house.files->set_dismissed({});
        CHECK_FALSE(house.may_show("b.jpg"));
        CHECK(house.may_show("!NOW fire.jpg"));
    }
    SUBCASE("held back, as it brought the player down") {
        for (int k = 0; k < 2; ++k) {
            crash(house.state.path, {photo("!NOW fire.jpg")});
            house.open();
        }
        CHECK(house.why("!NOW fire.jpg").visibility == Visibility::held_back);
        CHECK(house.may_show("b.jpg"));
    }
    SUBCASE("comes later in a rehearsal") {
        Rehearsal comes("5 add !NOW fire.jpg");
        house.open(&comes);
        CHECK(house.may_show("b.jpg"));
        CHECK(comes.advance(5s));
        house.files->apply_filters();
        CHECK_FALSE(house.may_show("b.jpg"));
        CHECK(house.may_show("!NOW fire.jpg"));
    }
}

TEST_CASE("while the displays are off every file tells so, and none is lost") {
    House house({photo("a.jpg")});
    house.open();
    house.look({.folders = {}, .files = {}, .open = {}, .is_off = true});
    CHECK(house.files->judge(*house.files->catalogue().find("a.jpg")).visibility == Visibility::screens_off);
    CHECK(house.files->records().size() == 1);
    house.look({.folders = {{}}, .files = {"a.jpg"}, .open = {}});
    CHECK(house.files->judge(*house.files->catalogue().find("a.jpg")).visibility == Visibility::on_wall);
}

TEST_CASE("a file tells that another picture of its group hangs") {
    MediaRecord still = photo("IMG_1.jpg");
    MediaRecord copy = photo("IMG_1 (1).jpg");
    for (MediaRecord* record : {&still, &copy}) {
        record->shots.front().look = ShotLook{};
        record->shots.front().print = PicturePrint{};
        for (int i = 0; i < 256; ++i)
            record->shots.front().print->shades.push_back(static_cast<std::uint8_t>((i * i) % 251));
    }
    House house({still, copy});
    house.open();
    house.look({.folders = {{}}, .files = {"IMG_1.jpg"}, .open = {}});
    const FileVisibility judged = house.files->judge(copy);
    CHECK(judged.visibility == Visibility::in_group);
    CHECK(judged.detail == "IMG_1.jpg");
}

TEST_CASE("a ready file may be shown: it waits for its turn, then it is on the wall") {
    House house({photo("a.jpg"), photo("b.jpg")});
    house.open();
    house.look({.folders = {{}}, .files = {"a.jpg"}, .open = {}});

    CHECK(house.files->records().size() == 2);
    CHECK(house.why("a.jpg").visibility == Visibility::on_wall);
    CHECK(house.why("b.jpg").visibility == Visibility::waits_for_turn);
    CHECK(house.files->count_ready() == 2);
}

TEST_CASE("a file that has not been analysed, or cannot be shown, is kept off with the analyzer's reason") {
    MediaRecord copied = photo("copied.jpg");
    copied.state = MediaState::waiting;
    copied.reason = "the copy is not complete";
    MediaRecord text = photo("text.jpg");
    text.state = MediaState::unsupported;
    text.reason = "it is a text";
    House house({copied, text});
    house.open();

    CHECK(house.files->records().is_empty());
    CHECK(house.why("copied.jpg") == FileVisibility{.path = "copied.jpg",
                                                    .visibility = Visibility::not_analysed,
                                                    .detail = "the copy is not complete"});
    CHECK(house.why("text.jpg").visibility == Visibility::unsupported);
    CHECK(house.why("text.jpg").detail == "it is a text");
}

TEST_CASE("a file that the rehearsal has not added yet is kept off") {
    House house({photo("a.jpg"), photo("later.jpg")});
    Rehearsal rehearsal("5 add later.jpg");
    house.open(&rehearsal);
    CHECK(house.why("later.jpg").visibility == Visibility::not_rehearsed);
    CHECK_FALSE(house.may_show("later.jpg"));

    CHECK(rehearsal.advance(5s));
    house.files->apply_filters();
    CHECK(house.may_show("later.jpg"));
}

TEST_CASE("a file of the evening is out of its hours at seven in the morning, and is told its hours") {
    House house({photo("20-21 Evening/late.png"), photo("a.jpg")});
    house.open(&at_seven);
    CHECK_FALSE(house.may_show("20-21 Evening/late.png"));
    CHECK(sentence(house.why("20-21 Evening/late.png")) ==
          "It is out of its hours: it is shown from 20:00 to 21:00.");

    house.open(&at_eight_pm);
    CHECK(house.may_show("20-21 Evening/late.png"));
}

TEST_CASE("a file with hours is kept off while the clock is not plausible") {
    House house({photo("20-21 Evening/late.png"), photo("a.jpg")});
    const auto next_year = fs::file_time_type::clock::now() + std::chrono::years(1);
    for (const fs::directory_entry& record : fs::directory_iterator(house.state.path / "catalogue"))
        fs::last_write_time(record.path(), next_year);  // written before: the clock is behind
    if (is_clock_kept_right()) return;                  // this machine's clock is always believed
    house.open();

    CHECK(house.why("20-21 Evening/late.png").visibility == Visibility::no_clock);
    CHECK_FALSE(house.may_show("20-21 Evening/late.png"));
    CHECK(house.may_show("a.jpg"));
}

TEST_CASE("a file that brought the player down is held back, and of two suspects one is shown at a time") {
    const std::vector<MediaRecord> records{photo("a.jpg"), photo("b.jpg"), photo("evil.jpg")};
    House house(records);
    replace_file(house.state.path / blamed_file,
                 to_text(Blame{{content_name(records[2]),
                                {quarantine_points,
                                 std::chrono::floor<std::chrono::seconds>(
                                     std::chrono::system_clock::now().time_since_epoch()),
                                 1}}}));
    crash(house.state.path, {records[0], records[1]});
    house.open();

    CHECK(house.why("evil.jpg") == FileVisibility{.path = "evil.jpg",
                                                  .visibility = Visibility::held_back,
                                                  .detail = brought_the_player_down});
    CHECK(house.why("b.jpg").visibility == Visibility::held_back);
    CHECK(house.why("b.jpg").detail != brought_the_player_down);
    REQUIRE(house.files->records().size() == 1);
    CHECK(house.may_show("a.jpg"));

    house.files->note_file("a.jpg", FileNews::opens, noon);
    for (int i = 0; i < 12; ++i)
        house.look({.folders = {{}}, .files = {}, .open = {"a.jpg"}});
    CHECK(house.may_show("b.jpg"));  // a.jpg has been open for long enough
}

TEST_CASE("a file that was dismissed is kept off until it changes; one that grows stays dismissed") {
    House house({film("a.mp4", 2), photo("b.jpg")});
    house.open();
    house.files->set_dismissed({"a.mp4"});
    CHECK(house.why("a.mp4").visibility == Visibility::dismissed);
    CHECK_FALSE(house.may_show("a.mp4"));
    CHECK(house.files->dismissed() == std::vector<std::string>{"a.mp4"});
    CHECK(house.changes == 2);

    const auto change_film = [&](const MediaRecord& record) {
        house.catalogue.store(record);
        for (int i = 0; i < 200 && *house.files->catalogue().find("a.mp4") != record; ++i)
            house.loop.run_once(50ms);
    };
    change_film(film("a.mp4", 3));
    CHECK(house.why("a.mp4").visibility == Visibility::dismissed);
    MediaRecord other = film("a.mp4", 3);
    other.mtime_ns = 77;
    change_film(other);
    CHECK(house.may_show("a.mp4"));
    CHECK(house.files->dismissed().empty());
}

TEST_CASE("a change of one record among many has one file judged, and a look at the wall none") {
    House house({});
    for (const MediaRecord& record : photos(400))
        house.state.write("catalogue/" + record_id(record.path) + ".json", to_json(record));
    house.open(&at_seven);
    house.look();
    const std::size_t before = house.files->judgements();
    CHECK(before >= 400);

    house.look({.folders = {}, .files = {"p100", "p101"}, .open = {"p102"}});
    CHECK(house.files->judgements() == before);

    house.catalogue.store(photo("p200", 9));
    for (int i = 0; i < 200 && house.files->catalogue().find("p200")->mtime_ns != 9; ++i)
        house.loop.run_once(50ms);
    CHECK(house.files->judgements() == before + 1);
    CHECK(house.find_file("p200")->mtime_ns == 9);
    CHECK(house.files->records().size() == 400);
}

TEST_CASE("files open and close at their hours without any change of the catalogue") {
    House house({photo("20-21 Evening/late.png"), photo("a.jpg")});
    Rehearsal evening("0 clock 2026-12-24 19:59:59\n5 clock 2026-12-24 20:00:00");
    house.open(&evening);
    CHECK_FALSE(house.may_show("20-21 Evening/late.png"));
    const int before = house.changes;
    (void)evening.advance(5s);
    house.look();
    CHECK(house.may_show("20-21 Evening/late.png"));
    CHECK(house.changes == before + 1);
}

TEST_CASE("a file waits only for a screen that shows its folder") {
    House house({photo("lobby/a.jpg"), photo("bar/b.jpg"), photo("bar/cellar/c.jpg")});
    house.open();
    house.look({.folders = {{.folder = "bar", .opened = {}}}, .files = {}, .open = {}});
    CHECK(house.why("lobby/a.jpg").visibility == Visibility::other_folder);
    CHECK(house.why("bar/cellar/c.jpg").visibility == Visibility::waits_for_turn);
    CHECK(house.may_show("lobby/a.jpg"));  // its screen may come at any time

    house.look({.folders = {{.folder = {}, .opened = "bar"}}, .files = {}, .open = {}});
    CHECK(house.why("lobby/a.jpg").visibility == Visibility::closed_folder);

    house.look();  // no screen at all is no reason
    CHECK(house.why("lobby/a.jpg").visibility == Visibility::waits_for_turn);
}

TEST_CASE("a file that a screen leaves out is told so, unless another screen chooses it") {
    House house({photo("a.jpg"), photo("b.jpg")});
    house.open();
    const ShownFolder leaves_out{.folder = {}, .opened = {}, .avoided = {"a.jpg"}};
    house.look({.folders = {leaves_out}, .files = {}, .open = {}});
    CHECK(house.why("a.jpg").visibility == Visibility::avoided);
    CHECK(house.why("b.jpg").visibility == Visibility::waits_for_turn);
    CHECK(house.may_show("a.jpg"));  // for the other screens, and after a minute

    house.look({.folders = {leaves_out, {}}, .files = {}, .open = {}});
    CHECK(house.why("a.jpg").visibility == Visibility::waits_for_turn);
    house.look({.folders = {leaves_out}, .files = {"a.jpg"}, .open = {}});
    CHECK(house.why("a.jpg").visibility == Visibility::on_wall);  // until its neighbours are ready
}

TEST_CASE("the reason of each file is in the state directory, for as long as the player runs") {
    MediaRecord text = photo("text.jpg");
    text.state = MediaState::unsupported;
    House house({photo("a.jpg"), text});
    house.open();
    house.look();
    VisibleByPath written = visible_from_json(house.written());
    CHECK(written.at("a.jpg").visibility == Visibility::waits_for_turn);
    CHECK(written.at("text.jpg").visibility == Visibility::unsupported);

    for (int tries = 0; tries < 200 && written.at("a.jpg").visibility != Visibility::on_wall; ++tries) {
        std::this_thread::sleep_for(10ms);
        house.look({.folders = {{}}, .files = {"a.jpg"}, .open = {}});
        written = visible_from_json(house.written());
    }
    CHECK(written.at("a.jpg").visibility == Visibility::on_wall);

    house.files->end_run();
    CHECK_FALSE(fs::exists(house.state.path / visible_file));
}

TEST_CASE("the note is written at most once a second, and its time tells that the player runs") {
    const TemporaryDirectory state;
    const fs::path file = state.path / visible_file;
    const auto old = fs::file_time_type::clock::now() - 1h;
    int asked = 0;
    VisibleNote note(file);
    const auto look = [&](std::chrono::milliseconds time) {
        note.write_if_due(noon + time, [&] {
            ++asked;
            return VisibleState{.files = one_file(), .on_wall = {}};
        });
    };
    look(0s);
    note.set_changed();
    look(999ms);
    CHECK(asked == 1);
    for (int tries = 0; tries < 200 && !fs::exists(file); ++tries)
        std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(50ms);  // its thread ends
    fs::last_write_time(file, old);
    look(1s);  // asked again, and the same
    CHECK(asked == 2);
    CHECK(fs::last_write_time(file) == old);
    look(9s);
    CHECK(fs::last_write_time(file) == old);
    look(11s);  // the heartbeat
    CHECK(fs::last_write_time(file) > old);
    CHECK(asked == 2);

    fs::remove(file);  // somebody deletes it
    look(22s);
    look(23s);
    CHECK(asked == 3);
}
