#include "analyzer/watch/daemon.hpp"

#include "base/state/acquittal.hpp"
#include "base/state/name_hash.hpp"
#include "tests/temporary_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr auto patience = 60s;  // until something that must come is given up

/// Says that a file is ready, unless its first line is a command that misbehaves.
constexpr const char* reader = R"(
    sound=
    fault=
    reason=
    as_it_is=
    kept=
    while :; do
        case "$1" in
        --sound) sound=',"sound":{"file":"","dropped":false}' ;;
        --as-it-is) as_it_is=true ;;
        --keep) kept=kept ;;
        --*) ;;
        *) break ;;
        esac
        shift
    done
    read -r word name < "$1" || true
    echo "$1" >> "$0.log"
    case "$word" in
    crash) kill -SEGV $$ ;;
    fail) state=failed; reason="no picture in it" ;;
    unread) state=waiting; reason="the file cannot be read"; fault=',"fault":{"owner":"transport","since_s":0}' ;;
    odd) echo "an answer that nobody expects"; exit 0 ;;
    killed) [ -e "$0.gate" ] || kill -KILL $$; state=ready ;;
    half) state=waiting ;;
    says) state=ready; fault=',"caption":"'$name'"' ;;
    tells) state=ready; echo "$(nice) $kept" >> "$0.told.${1##*/}" ;;
    cut) state=waiting; [ -z "$as_it_is" ] || state=ready ;;
    *) state=ready ;;
    esac
    stored=
    if [ "$word" = keep ]; then
        file="$name/photo"
        mkdir -p "${0%/*}/store/${file%/*}"
        printf 1234567890 > "${0%/*}/store/$file"
        stored=',"stored":{"file":"'$file'","begin_ns":0,"width":4,"height":3,"dropped":false}'
    fi
    say() {
        echo '{"version":3,"path":"x","kind":"video","bytes":0,"mtime_ns":0,"state":"'$state'","complete":'$1','\
             '"reason":"'"$reason"'","width":4,"height":3,"duration_ns":0,"shots":['"$2"']'"$sound$fault"'}'
    }
    first='{"begin_ns":0,"end_ns":5,"ends_with":"cut","analysis":12,"region":{"polygon":[[0,0],[1,0],[0,1]],"drift":[0,0]}'"$stored"'}'
    second='{"begin_ns":5,"end_ns":9,"ends_with":"end","analysis":12,"region":{"polygon":[[0,0],[1,0],[0,1]],"drift":[0,0]}}'
    case "$word" in
    film) say false "$first"; until [ -e "$0.gate" ]; do sleep 0.02; done; say true "$first,$second" ;;
    hang) say false "$first"; until [ -e "$0.gate" ]; do sleep 0.02; done ;;
    spin) say false "$first"; until [ -e "$0.gate" ]; do :; done ;;
    shoot) say false "$first"; kill -SEGV $$ ;;
    *) say true "$first" ;;
    esac)";

/// A media folder, a catalogue and a daemon between them that analyses with a shell script.
struct House {
    House() : script(home.write("reader.sh", reader)) { fs::create_directories(root); }

    void start() { daemon = std::make_unique<Daemon>(loop, options()); }

    WatchOptions options() const {
        return {.root = root,
                .catalogue = home.path / "catalogue",
                .store = home.path / "store",
                .state = home.path,
                .bounds = {.max_bytes = max_stored},
                .analysis = {.words = {"/bin/sh", script.string()},
                             .limits = {.patience = {.computing = deadline, .idling = deadline}}},
                .outputs = {.stored = max_stored > 0},
                .pace = {.small_bytes = small_bytes,
                         .quiet = 1ms,
                         .rename_grace = 100ms,
                         .first_retry = first_retry,
                         .max_retry = max_retry,
                         .retries = 2,
                         .death_memory = death_memory},
                .rescan = rescan};
    }

    fs::path drop(const std::string& name, const std::string& content = "picture\n") const {
        return home.write("media/" + name, content);
    }

    bool comes_true(const std::function<bool()>& condition) {
        const auto end = EventLoop::Clock::now() + patience;
        while (!condition() && EventLoop::Clock::now() < end)
            loop.run_once(1s);
        return condition();
    }

    std::optional<MediaState> state_of(const std::string& path) const {
        const auto record = Catalogue(home.path / "catalogue").find(path);
        if (!record || !fs::exists(root / path) || record->bytes != fs::file_size(root / path))
            return std::nullopt;
        return record->state;
    }

    bool becomes(const std::string& path, MediaState state) {
        return comes_true([&] { return state_of(path) == state; });
    }

    std::optional<MediaRecord> record(const std::string& path) const {
        return Catalogue(home.path / "catalogue").find(path);
    }

    /// The number of shots that a film has so far, 0 without a record.
    std::size_t shots(const std::string& path) const {
        const auto found = record(path);
        return found ? found->shots.size() : 0;
    }

    /// Films of the reader wait behind their first shot until there is this file.
    std::string gate() const { return script.string() + ".gate"; }

    std::size_t records() const { return Catalogue(home.path / "catalogue").load().size(); }

    /// The number of children that were started.
    std::size_t analyses() const {
        std::ifstream log(script.string() + ".log");
        return static_cast<std::size_t>(std::count(std::istreambuf_iterator<char>(log), {}, '\n'));
    }

    /// The priorities of a file's readers, and whether they kept a copy; a line each.
    std::string told(const std::string& name) const {
        std::ifstream told(script.string() + ".told." + name);
        return {std::istreambuf_iterator<char>(told), {}};
    }

    /// Drops a photo of which the reader puts something into the store. @return the folder there
    std::string keep(const std::string& name) const {
        constexpr std::int64_t mtime = 1'700'000'000;
        const std::string word = "keep ";
        const std::string id = store_id(name, word.size() + name_hash_length, mtime * 1'000'000'000);
        const fs::path made = home.write("made", word + id);
        const std::array<timespec, 2> times{timespec{.tv_sec = mtime, .tv_nsec = 0},
                                            timespec{.tv_sec = mtime, .tv_nsec = 0}};
        REQUIRE(::utimensat(AT_FDCWD, made.c_str(), times.data(), 0) == 0);
        fs::rename(made, root / name);
        return id;
    }

    bool has_stored(const std::string& id) const { return fs::exists(home.path / "store" / id / "photo"); }

    std::uint64_t max_stored = 0;  // bytes
    std::uint64_t small_bytes = 0;
    std::chrono::milliseconds deadline = 20s;
    std::chrono::milliseconds rescan = 1h;
    std::chrono::milliseconds first_retry = 1ms;
    std::chrono::milliseconds max_retry = 20ms;
    std::chrono::milliseconds death_memory = 0ms;
    TemporaryDirectory home;
    fs::path root = home.path / "media";
    fs::path script;
    EventLoop loop;
    std::unique_ptr<Daemon> daemon;
};

}  // namespace

TEST_CASE("what is in the folder at the start and what comes later gets its record, wherever it is dropped") {
    House house;
    house.drop("old.jpg");
    house.start();
    CHECK(house.becomes("old.jpg", MediaState::ready));
    house.drop("new.jpg");
    CHECK(house.becomes("new.jpg", MediaState::ready));
    house.drop("a/b/c/deep \n\xff.jpg");
    CHECK(house.becomes("a/b/c/deep \n\xff.jpg", MediaState::ready));
    house.drop("a/b/more.jpg");
    CHECK(house.becomes("a/b/more.jpg", MediaState::ready));
    house.drop(".DS_Store");
    house.drop("x.part");
    fs::rename(house.root / "x.part", house.root / "x.jpg");
    CHECK(house.becomes("x.jpg", MediaState::ready));
    CHECK(house.records() == 5);
}

TEST_CASE("the first shot of a film is in the catalogue while the rest of it is still analysed") {
    House house;
    const std::string gate = house.gate();
    house.drop("film.mp4", "film\n");
    house.start();
    REQUIRE(house.comes_true([&] { return house.shots("film.mp4") == 1; }));
    CHECK(house.record("film.mp4")->state == MediaState::ready);
    CHECK_FALSE(house.record("film.mp4")->is_complete);
    CHECK(house.record("film.mp4")->bytes == 5);
    std::ofstream(gate) << "go\n";
    REQUIRE(house.comes_true([&] { return house.shots("film.mp4") == 2; }));
    CHECK(house.record("film.mp4")->is_complete);
}

TEST_CASE("a film whose analysis was cut off by a restart is analysed anew and stays on the wall meanwhile") {
    House house;
    const std::string gate = house.gate();
    house.drop("film.mp4", "film\n");
    house.start();
    REQUIRE(house.comes_true([&] { return house.shots("film.mp4") == 1; }));
    house.daemon.reset();
    house.start();
    CHECK(house.comes_true([&] { return house.analyses() == 2; }));
    CHECK(house.shots("film.mp4") == 1);
    std::ofstream(gate) << "go\n";
    CHECK(house.comes_true([&] { return house.shots("film.mp4") == 2; }));
}

TEST_CASE("a film that is deleted while it is analysed leaves no record") {
    House house;
    const fs::path film = house.drop("film.mp4", "film\n");
    house.start();
    REQUIRE(house.comes_true([&] { return house.shots("film.mp4") == 1; }));
    fs::remove(film);
    CHECK(house.comes_true([&] { return house.records() == 0; }));
}

TEST_CASE("a film that takes too long keeps the shots that are known, one that crashes the reader does not") {
    House house;
    house.drop("slow.mp4", "spin\n");
    house.drop("crash.mp4", "shoot\n");
    house.deadline = 1s;
    house.start();
    CHECK(house.becomes("crash.mp4", MediaState::quarantined));
    REQUIRE(house.comes_true([&] {
        const auto record = house.record("slow.mp4");
        return record && record->is_complete;
    }));
    CHECK(house.record("slow.mp4")->state == MediaState::ready);
    CHECK(house.shots("slow.mp4") == 1);
    CHECK(house.record("slow.mp4")->reason ==
          "not shown to its end: twice its reader computed for 1 s and came to nothing");
    CHECK(house.analyses() == 4);
}

TEST_CASE("an empty folder at the start loses no record, until a file in it shows that it is the right one") {
    House house;
    house.drop("a.jpg");
    house.start();
    REQUIRE(house.becomes("a.jpg", MediaState::ready));
    house.daemon.reset();
    fs::remove(house.root / "a.jpg");
    house.rescan = 50ms;
    house.start();
    CHECK_FALSE(house.daemon->is_online());
    CHECK(house.records() == 1);
    house.drop("b.jpg");
    CHECK(house.becomes("b.jpg", MediaState::ready));
    CHECK(house.comes_true([&] { return house.records() == 1; }));
    CHECK(house.daemon->is_online());
}

TEST_CASE("a record that cannot be stored is missed") {
    House house;
    house.drop("a.jpg");
    const fs::path blocker = house.home.path / "catalogue" / (record_id("a.jpg") + ".json");
    fs::create_directories(blocker / "full");
    house.start();
    CHECK(house.comes_true([&] { return house.analyses() == 1 && !house.daemon->is_up_to_date(); }));
}

TEST_CASE("a record that cannot be removed is tried again") {
    House house;
    house.rescan = 50ms;
    house.drop("a.jpg");
    house.drop("b.jpg");
    house.start();
    REQUIRE(house.becomes("a.jpg", MediaState::ready));
    REQUIRE(house.becomes("b.jpg", MediaState::ready));
    const fs::path record = house.home.path / "catalogue" / (record_id("a.jpg") + ".json");
    fs::remove(record);
    fs::create_directories(record / "full");
    fs::remove(house.root / "a.jpg");
    CHECK(house.comes_true([&] { return !house.daemon->is_up_to_date(); }));
    fs::remove(record / "full");
    CHECK(house.comes_true([&] { return house.daemon->is_up_to_date(); }));
    CHECK_FALSE(fs::exists(record));
}

TEST_CASE("replaced is analysed again, deleted is gone, renamed and moved keep their analysis") {
    House house;
    house.drop("a.jpg");
    house.drop("folder/b.jpg");
    house.start();
    REQUIRE(house.becomes("a.jpg", MediaState::ready));
    REQUIRE(house.becomes("folder/b.jpg", MediaState::ready));

    house.drop("a.jpg", "fail\nlonger than before");
    CHECK(house.becomes("a.jpg", MediaState::failed));
    fs::remove(house.root / "a.jpg");
    CHECK(house.comes_true([&] { return house.records() == 1; }));

    const std::size_t analyses = house.analyses();
    fs::rename(house.root / "folder", house.root / "other");
    CHECK(house.comes_true([&] {
        return fs::exists(house.root / "other/b.jpg") && house.state_of("other/b.jpg") == MediaState::ready;
    }));
    fs::rename(house.root / "other" / "b.jpg", house.root / "c.jpg");
    CHECK(house.becomes("c.jpg", MediaState::ready));
    CHECK(house.comes_true([&] { return house.records() == 1; }));
    CHECK(house.analyses() == analyses);
}

TEST_CASE("a file that crashes, fails or is incomplete gets its state and reason, and hurts no other") {
    House house;
    house.drop("crash.jpg", "crash\n");
    house.drop("fail.jpg", "fail\n");
    house.drop("half.jpg", "half\n");
    house.drop("good.jpg");
    house.drop("empty.jpg", "");
    house.start();
    CHECK(house.becomes("crash.jpg", MediaState::quarantined));
    CHECK(house.becomes("fail.jpg", MediaState::failed));
    CHECK(house.becomes("good.jpg", MediaState::ready));
    CHECK(house.becomes("half.jpg", MediaState::failed));  // after all its retries
    const Catalogue catalogue(house.home.path / "catalogue");
    CHECK(catalogue.find("fail.jpg")->reason == "no picture in it");
    CHECK(catalogue.find("crash.jpg")->reason.starts_with("twice it crashed the reader"));
}

TEST_CASE(
    "a file that cannot be read, an answer that makes no sense and a kill from outside condemn no file") {
    House house;
    house.max_retry = 1s;  // on a busy machine the newest would be tried all the time
    house.drop("unread.jpg", "unread\n");
    house.drop("odd.jpg", "odd\n");
    house.drop("killed.jpg", "killed\n");
    house.start();
    CHECK(house.comes_true([&] { return house.analyses() >= 15; }));
    for (const char* path : {"unread.jpg", "odd.jpg", "killed.jpg"}) {
        CAPTURE(path);
        REQUIRE(house.becomes(path, MediaState::waiting));
        CHECK(house.record(path)->reason.starts_with("since "));
        CHECK(house.record(path)->reason.ends_with("; it is tried again"));
        CHECK(house.record(path)->fault.since.count() > 0);
    }
    CHECK(house.record("unread.jpg")->fault.owner == FaultOwner::transport);
    CHECK(house.record("odd.jpg")->fault.owner == FaultOwner::program);
    CHECK(house.record("killed.jpg")->fault.owner == FaultOwner::machine);

    std::ofstream(house.gate()) << "go\n";
    CHECK(house.becomes("killed.jpg", MediaState::ready));
    CHECK(house.record("killed.jpg")->fault == Fault{});
    house.drop("unread.jpg", "it can be read now\n");
    CHECK(house.becomes("unread.jpg", MediaState::ready));
}

TEST_CASE("a fault of the share is tried again after a restart") {
    House house;
    house.first_retry = house.max_retry = 1h;
    house.drop("killed.jpg", "killed\n");
    house.start();
    REQUIRE(house.becomes("killed.jpg", MediaState::waiting));
    house.daemon.reset();
    std::ofstream(house.gate()) << "go\n";
    house.start();
    CHECK(house.becomes("killed.jpg", MediaState::ready));
}

TEST_CASE("a file is not condemned within an hour after the reader of another crashed") {
    House house;
    house.death_memory = 1h;
    house.drop("a.jpg", "crash\n");
    house.start();
    REQUIRE(house.becomes("a.jpg", MediaState::quarantined));
    house.drop("b.jpg", "crash\n");
    REQUIRE(house.becomes("b.jpg", MediaState::waiting));
    CHECK(house.comes_true([&] { return house.analyses() >= 6; }));
    CHECK(house.record("b.jpg")->fault.owner == FaultOwner::machine);
    CHECK(house.state_of("b.jpg") == MediaState::waiting);
}

TEST_CASE("a quarantine that is over is followed by another look, and a second one lasts a week") {
    House house;
    const fs::path file = house.drop("crash.jpg", "crash\n");
    house.start();
    REQUIRE(house.becomes("crash.jpg", MediaState::quarantined));
    MediaRecord record = *house.record("crash.jpg");
    CHECK(record.fault.until - record.fault.since == 24h);
    house.daemon.reset();
    const std::size_t analyses = house.analyses();
    record.fault.until = std::chrono::seconds(1);
    Catalogue(house.home.path / "catalogue").store(record);

    house.rescan = 50ms;
    house.start();
    CHECK(house.comes_true([&] { return house.record("crash.jpg")->fault.quarantines >= 2; }));
    record = *house.record("crash.jpg");
    CHECK(record.state == MediaState::quarantined);
    CHECK(record.fault.until - record.fault.since == 7 * 24h);
    CHECK(house.analyses() == analyses + 2);
}

TEST_CASE("a file that somebody acquits is tried again at the next rescan, once") {
    House house;
    house.rescan = 50ms;
    house.drop("crash.jpg", "crash\n");
    house.start();
    REQUIRE(house.becomes("crash.jpg", MediaState::quarantined));
    const std::size_t analyses = house.analyses();
    const auto now =
        std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch());
    write_acquittal(house.home.path, "other.jpg", now + 1s);
    for (int i = 0; i < 10; ++i)
        house.loop.run_once(20ms);
    CHECK(house.analyses() == analyses);
    write_acquittal(house.home.path, "", now);
    CHECK(house.comes_true([&] { return house.record("crash.jpg")->fault.quarantines >= 2; }));
}

TEST_CASE("a file is gone though a folder beside it cannot be read") {
    House house;
    house.rescan = 50ms;
    std::string deep;
    for (int i = 0; i <= MediaFolder::max_depth; ++i)
        deep += "d/";
    house.drop(deep + "hidden.jpg");
    house.drop("a.jpg");
    house.start();
    REQUIRE(house.becomes("a.jpg", MediaState::ready));
    house.daemon.reset();
    fs::remove(house.root / "a.jpg");
    house.drop("b.jpg");
    house.start();
    CHECK(house.becomes("b.jpg", MediaState::ready));
    CHECK(house.comes_true([&] { return house.records() == 1; }));
}

TEST_CASE("a media folder that cannot be looked at for any reason ends nothing") {
    House house;
    house.drop("a.jpg");
    house.start();
    REQUIRE(house.becomes("a.jpg", MediaState::ready));
    house.daemon.reset();
    const fs::path aside = house.home.path / "aside";
    fs::rename(house.root, aside);
    SUBCASE("a circle of links") {
        fs::create_symlink(house.root.filename(), house.root);
    }
    SUBCASE("a file") {
        house.home.write("media", "no folder");
    }
    SUBCASE("nothing") {}
    house.rescan = 50ms;
    house.start();
    for (int i = 0; i < 20; ++i)
        house.loop.run_once(20ms);
    CHECK_FALSE(house.daemon->is_online());
    CHECK(house.records() == 1);
    fs::remove(house.root);
    fs::rename(aside, house.root);
    CHECK(house.comes_true([&] { return house.daemon->is_online(); }));
    house.drop("b.jpg");
    CHECK(house.becomes("b.jpg", MediaState::ready));
}

TEST_CASE(
    "a media folder that is a link is watched as any other, and folders of our own in it are passed over") {
    House house;
    const fs::path real = house.home.path / "real";
    fs::rename(house.root, real);
    fs::create_directory_symlink(real, house.root);
    house.start();
    house.drop("a.jpg");  // the next rescan is an hour away
    CHECK(house.becomes("a.jpg", MediaState::ready));
}

TEST_CASE("where no child can be started its file waits, and the daemon goes on") {
    House house;
    rlimit usual{};
    REQUIRE(::getrlimit(RLIMIT_NOFILE, &usual) == 0);
    house.start();
    std::size_t open = 0;
    for (const auto& entry : fs::directory_iterator("/proc/self/fd"))
        open += entry.path().empty() ? 0 : 1;
    const rlimit few{.rlim_cur = open + 1, .rlim_max = usual.rlim_max};  // one pipe, not two
    house.drop("a.jpg");
    REQUIRE(::setrlimit(RLIMIT_NOFILE, &few) == 0);
    for (int i = 0; i < 20; ++i)
        house.loop.run_once(20ms);
    REQUIRE(::setrlimit(RLIMIT_NOFILE, &usual) == 0);
    CHECK(house.analyses() == 0);
    CHECK(house.becomes("a.jpg", MediaState::ready));
}

TEST_CASE("a second start analyses nothing again, and removes what went in between") {
    House house;
    house.drop("a.jpg");
    house.drop("b.jpg");
    house.drop("crash.jpg", "crash\n");
    house.start();
    REQUIRE(house.becomes("a.jpg", MediaState::ready));
    REQUIRE(house.becomes("b.jpg", MediaState::ready));
    REQUIRE(house.becomes("crash.jpg", MediaState::quarantined));
    const std::size_t analyses = house.analyses();
    house.daemon.reset();
    fs::remove(house.root / "b.jpg");

    house.start();
    CHECK(house.comes_true([&] { return house.records() == 2; }));
    CHECK(house.analyses() == analyses);
}

TEST_CASE(
    "what an earlier version analysed is read again, one file at a time, and keeps its shots meanwhile") {
    House house;
    house.drop("a.jpg");
    house.drop("b.mp4", "film\n");
    house.home.write("reader.sh.gate", "");
    house.start();
    REQUIRE(house.becomes("a.jpg", MediaState::ready));
    REQUIRE(house.comes_true([&] { return house.shots("b.mp4") == 2; }));
    house.daemon.reset();
    fs::remove(house.gate());
    for (const char* path : {"a.jpg", "b.mp4"}) {
        MediaRecord record = *house.record(path);
        for (Shot& shot : record.shots)
            shot.analysis = 1;
        Catalogue(house.home.path / "catalogue").store(record);
    }
    const std::size_t analyses = house.analyses();

    house.start();
    CHECK(house.daemon->status().ends_with("; 2 files of an earlier version to be read again"));
    CHECK(house.comes_true([&] { return house.analyses() == analyses + 2; }));
    CHECK(house.comes_true([&] { return !is_outdated(*house.record("a.jpg")); }));
    CHECK(is_outdated(*house.record("b.mp4")));
    CHECK(house.shots("b.mp4") == 2);
    house.home.write("reader.sh.gate", "");
    CHECK(house.comes_true([&] { return !is_outdated(*house.record("b.mp4")); }));
    CHECK(house.shots("b.mp4") == 2);
    CHECK(house.analyses() == analyses + 2);
}

TEST_CASE("the records outlive the media folder, and it is followed again once it is back") {
    House house;
    house.drop("a.jpg");
    WatchOptions options = house.options();
    options.rescan = 50ms;
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    REQUIRE(house.becomes("a.jpg", MediaState::ready));

    fs::rename(house.root, house.home.path / "away");
    CHECK(house.comes_true([&] { return !house.daemon->is_online(); }));
    CHECK(house.records() == 1);
    CHECK(house.daemon->status().find("is not there") != std::string::npos);

    fs::rename(house.home.path / "away", house.root);
    CHECK(house.comes_true([&] { return house.daemon->is_online(); }));
    house.drop("b.jpg");
    CHECK(house.becomes("b.jpg", MediaState::ready));
    CHECK(house.records() == 2);
}

TEST_CASE("once means until the catalogue is up to date, and no longer for what waits or fails") {
    House house;
    house.drop("a.jpg");
    house.drop("half.jpg", "half\n");
    house.drop("fail.jpg", "fail\n");
    WatchOptions options = house.options();
    options.is_once = true;
    options.pace.first_retry = 1h;
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    house.loop.run();
    CHECK(house.state_of("a.jpg") == MediaState::ready);
    CHECK(house.state_of("half.jpg") == MediaState::waiting);
    CHECK(house.state_of("fail.jpg") == MediaState::failed);
}

TEST_CASE("a file whose space is only reserved waits, and is analysed once it is filled") {
    House house;
    const fs::path film = house.drop("film.mp4", "picture\n");
    fs::resize_file(film, 1'000'000);
    WatchOptions options = house.options();
    options.pace.first_retry = 1h;
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    CHECK(house.becomes("film.mp4", MediaState::waiting));
    CHECK(house.analyses() == 0);
    house.drop("film.mp4", "picture\n" + std::string(1'000'000, 'x'));
    CHECK(house.becomes("film.mp4", MediaState::ready));
}

TEST_CASE("a state directory in the media folder is passed over") {
    House house;
    WatchOptions options = house.options();
    options.state = house.root / "state";
    options.catalogue = options.state / "catalogue";
    options.store = options.state / "store";
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    const Catalogue catalogue(options.catalogue);
    for (const char* name : {"a.jpg", "b.jpg", "c.jpg"}) {
        house.drop(name);
        CHECK(house.comes_true([&] { return catalogue.find(name).has_value(); }));
    }
    CHECK(catalogue.load().size() == 3);  // none of a record
    CHECK(house.analyses() == 3);
}

TEST_CASE("a catalogue has one writer") {
    House house;
    house.start();
    EventLoop other;
    CHECK_THROWS_AS(Daemon(other, house.options()), std::system_error);
}

TEST_CASE("a damaged record is dropped and its file analysed again") {
    House house;
    house.drop("a.jpg");
    house.home.write("catalogue/" + record_id("a.jpg") + ".json", "{ not json");
    house.start();
    CHECK(house.becomes("a.jpg", MediaState::ready));
}

TEST_CASE("what is stored of a file goes with it") {
    House house;
    house.max_stored = 1000;
    house.rescan = 20ms;
    const std::string a = house.keep("a.jpg");
    house.start();
    CHECK(house.becomes("a.jpg", MediaState::ready));
    CHECK(house.record("a.jpg")->shots[0].stored->file == a + "/photo");
    fs::rename(house.root / "a.jpg", house.root / "b.jpg");
    CHECK(house.becomes("b.jpg", MediaState::ready));
    const std::string c = house.keep("c.jpg");
    CHECK(house.becomes("c.jpg", MediaState::ready));
    CHECK(house.has_stored(a));
    fs::remove(house.root / "b.jpg");
    CHECK(house.comes_true([&] { return !house.has_stored(a); }));
    CHECK(house.has_stored(c));
}

TEST_CASE("a full store gives up its oldest, whose record says so") {
    House house;
    house.max_stored = 15;
    const std::string a = house.keep("a.jpg");
    house.start();
    CHECK(house.becomes("a.jpg", MediaState::ready));
    const std::string b = house.keep("b.jpg");
    CHECK(house.comes_true([&] {
        const auto record = house.record("a.jpg");
        return record && record->shots[0].stored->is_dropped;
    }));
    CHECK(house.becomes("b.jpg", MediaState::ready));
    CHECK_FALSE(house.record("b.jpg")->shots[0].stored->is_dropped);
    CHECK_FALSE(house.has_stored(a));
    CHECK(house.has_stored(b));
}

TEST_CASE("what the store has lost is made again at the next start, what it gave up is not") {
    House house;
    house.max_stored = 1000;
    const std::string a = house.keep("a.jpg");
    const std::string b = house.keep("b.jpg");
    house.start();
    CHECK(house.becomes("a.jpg", MediaState::ready));
    CHECK(house.becomes("b.jpg", MediaState::ready));
    house.daemon.reset();
    fs::remove_all(house.home.path / "store" / a);
    MediaRecord dropped = *house.record("b.jpg");
    dropped.shots[0].stored->is_dropped = true;
    fs::remove_all(house.home.path / "store" / b);
    Catalogue(house.home.path / "catalogue").store(dropped);
    house.start();
    CHECK(house.comes_true([&] { return house.analyses() == 3 && house.has_stored(a); }));
    CHECK_FALSE(house.has_stored(b));
}

TEST_CASE("a stream that breaks off is taken as it is once it has been waited for long enough") {
    House house;
    house.drop("cut.ts", "cut\n");
    house.start();
    CHECK(house.becomes("cut.ts", MediaState::ready));
    CHECK(house.analyses() == 3);  // two retries
}

TEST_CASE("the status says where the files stand, what is looked at, and what cannot be stored") {
    House house;
    house.drop("a.jpg");
    house.drop("crash.jpg", "crash\n");
    house.drop("half.jpg", "half\n");
    house.drop("film \n.mp4", "hang\n");
    WatchOptions options = house.options();
    options.pace.first_retry = 1h;
    options.pace.children = 2;
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    CHECK(house.comes_true([&] {
        return house.daemon->status().starts_with(
            "4 files: 2 ready, 1 waiting, 1 quarantined; looking at 'film \\x0a.mp4' for ");
    }));
    fs::create_directories(house.home.path / "catalogue" / (record_id("b.jpg") + ".json") / "full");
    house.drop("b.jpg");
    CHECK(house.comes_true(
        [&] { return house.daemon->status().ends_with("; 1 record cannot be stored: is the disk full?"); }));
}

TEST_CASE("systemd hears where the files stand, and again and again that all is well") {
    House house;
    const std::string name = (house.home.path / "notify").string();
    const UniqueFd systemd(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
    REQUIRE(name.size() < sizeof address.sun_path);
    std::memcpy(address.sun_path, name.c_str(), name.size() + 1);
    REQUIRE(::bind(systemd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
    ::setenv("WATCHDOG_USEC", "40000", 1);
    int well = 0;
    std::string told;
    const auto listen = [&] {
        std::array<char, 4096> buffer;
        for (ssize_t n; (n = ::recv(systemd.get(), buffer.data(), buffer.size(), 0)) > 0;) {
            const std::string word(buffer.data(), static_cast<std::size_t>(n));
            well += word == "WATCHDOG=1" ? 1 : 0;
            if (word.starts_with("STATUS=")) told = word;
        }
    };
    house.drop("a.jpg");
    house.start();
    CHECK(house.comes_true([&] {
        listen();
        return well >= 3 && told == "STATUS=1 file: 1 ready";
    }));
    ::unsetenv("NOTIFY_SOCKET");
    ::unsetenv("WATCHDOG_USEC");
}

TEST_CASE("a folder that goes while a file in it is awaited is asked for now and then, not without a pause") {
    House house;
    house.drop("a.jpg");
    WatchOptions options = house.options();
    options.pace.quiet = 100ms;
    options.pace.closed_quiet = 100ms;
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    fs::rename(house.root, house.home.path / "away");
    REQUIRE(house.comes_true([&] { return !house.daemon->is_online(); }));
    int turns = 0;
    const auto end = EventLoop::Clock::now() + 500ms;
    while (EventLoop::Clock::now() < end)
        turns += house.loop.run_once(100ms) ? 1 : 0;
    CHECK(turns < 20);
    fs::rename(house.home.path / "away", house.root);
    CHECK(house.becomes("a.jpg", MediaState::ready));
}

TEST_CASE("thumbnails that the status page lacks are made when nothing else is to be done, each tried once") {
    House house;
    const fs::path maker = house.home.write("thumbnail.sh", "echo \"${1##*/}\" >> \"$0.log\"\n");
    const auto tried = [&] {
        std::ifstream log(maker.string() + ".log");
        return std::string(std::istreambuf_iterator<char>(log), {});
    };
    house.drop("a.jpg");
    house.drop("b.jpg");
    house.home.write("thumbnails/" + record_id("b.jpg") + "/thumbnail.jpg", "there already");
    WatchOptions options = house.options();
    options.status_folder = "_STATUS";
    options.thumbnail_child = {"/bin/sh", maker.string()};
    options.rescan = 20ms;
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    CHECK(house.comes_true([&] { return !tried().empty(); }));
    const auto end = EventLoop::Clock::now() + 200ms;
    CHECK(house.comes_true([&] { return EventLoop::Clock::now() > end; }));
    CHECK(tried() == "a.jpg\n");
}

TEST_CASE("names of folders are set as pictures, also for folders that come later") {
    House house;
    const fs::path setter =
        house.home.write("set.sh", "for text; do printf '%s;' \"$text\" >> \"$0.log\"; done\n");
    const auto set = [&] {
        std::ifstream log(setter.string() + ".log");
        return std::string(std::istreambuf_iterator<char>(log), {});
    };
    house.drop("Trips/Rome/a.jpg");
    WatchOptions options = house.options();
    options.words_child = {"/bin/sh", setter.string()};
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    CHECK(house.comes_true([&] { return set() == "Rome;Trips;"; }));
    house.drop("Oslo/a.jpg");
    CHECK(house.comes_true([&] { return set() == "Rome;Trips;Oslo;"; }));
}

TEST_CASE("captions that photos have themselves are set as pictures, where no text lies beside them") {
    House house;
    const fs::path setter =
        house.home.write("set.sh", "for text; do printf '%s;' \"$text\" >> \"$0.log\"; done\n");
    const auto set = [&] {
        std::ifstream log(setter.string() + ".log");
        return std::string(std::istreambuf_iterator<char>(log), {});
    };
    house.drop("a.jpg", "says Lake\n");
    WatchOptions options = house.options();
    options.words.captions = CaptionChoice::written;
    options.words_child = {"/bin/sh", setter.string()};
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    CHECK(house.comes_true([&] {
        return set() == "\x02"
                        "1Lake;\x02"
                        "2Lake;\x02"
                        "3Lake;";
    }));
    house.daemon->change_words({.share_address = "host"});
    CHECK(house.comes_true([&] { return set().ends_with("3Lake;host;"); }));
}

TEST_CASE("a run that ends by itself sets the names of folders before") {
    House house;
    house.drop("Trips/a.jpg");
    WatchOptions options = house.options();
    options.is_once = true;
    options.words_child = {"/bin/sh", house.home.write("set.sh", "sleep 0.3; touch \"$0.log\"\n").string()};
    house.daemon = std::make_unique<Daemon>(house.loop, options);
    house.loop.run();
    CHECK(fs::exists(house.home.path / "set.sh.log"));
}

TEST_CASE(
    "a notice's photo is read at the daemon's own priority, shown before it is copied, and copied then") {
    House house;
    house.max_stored = 1000;
    house.small_bytes = 100;
    house.start();
    house.drop("!NOW fire.jpg", "tells\n");
    house.drop("!NOW film.mp4", "tells\n" + std::string(100, '.'));
    house.drop("photo.jpg", "tells\n");
    REQUIRE(house.comes_true(
        [&] { return house.records() == 3 && house.told("!NOW fire.jpg").ends_with("kept\n"); }));
    const auto end = EventLoop::Clock::now() + 200ms;
    CHECK(house.comes_true([&] { return EventLoop::Clock::now() > end; }));
    CHECK(house.analyses() == 4);
    const int ours = ::getpriority(PRIO_PROCESS, 0);
    const int behind = std::min(ours + ChildLimits{}.niceness, 19);
    CHECK(house.told("!NOW fire.jpg") == fmt::format("{0} \n{0} kept\n", ours));
    CHECK(house.told("!NOW film.mp4") == fmt::format("{} kept\n", ours));
    CHECK(house.told("photo.jpg") == fmt::format("{} kept\n", behind));
}

TEST_CASE("a film is asked for its sound where names or folders say so, be it afterwards") {
    House house;
    house.max_stored = 1000;
    house.drop("sound at once.mp4");
    house.drop("later/a.mp4");
    house.drop("later/mute b.mp4");
    house.start();
    const auto has_sound = [&](const std::string& path) {
        const auto record = house.record(path);
        return record && record->sound.has_value();
    };
    CHECK(house.comes_true([&] { return house.records() == 3 && has_sound("sound at once.mp4"); }));
    CHECK_FALSE(has_sound("later/a.mp4"));

    house.drop("later/.vitrine.toml", "sound = true\n");

    CHECK(house.comes_true([&] { return has_sound("later/a.mp4"); }));
    CHECK(house.shots("later/a.mp4") == 1);
    CHECK_FALSE(has_sound("later/mute b.mp4"));
    CHECK(house.analyses() == 4);

    fs::rename(house.root / "later/mute b.mp4", house.root / "later/b.mp4");

    CHECK(house.comes_true([&] { return has_sound("later/b.mp4"); }));
    CHECK(house.analyses() == 5);
}
