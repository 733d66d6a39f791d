#include "analyzer/watch/daemon.hpp"

#include "analyzer/tapestry/tapestry_state.hpp"
#include "base/hints/keyframe_choice.hpp"
#include "base/state/keyframe_notes.hpp"
#include "base/state/tapestry.hpp"
#include "base/state/wanted_tapestry.hpp"
#include "tests/temporary_directory.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <functional>
#include <iterator>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr auto patience = 60s;  // until something that must come is given up

/// Finds every file a film of one shot; "slow" waits to be let go.
constexpr const char* reader = R"(
    read -r word < "$1" || true
    [ "$word" != slow ] || read -r _ < "$0.gate"
    echo '{"version":3,"path":"x","kind":"video","bytes":0,"mtime_ns":0,"state":"ready","complete":true,'\
         '"reason":"","width":4,"height":3,"duration_ns":9,"shots":[{"begin_ns":0,"end_ns":9,"ends_with":"end","analysis":12,'\
         '"region":{"polygon":[[0,0],[1,0],[0,1]],"drift":[0,0]}}]}')";

/// Weaves nothing, but an index; "gate" waits to be let go before that, "bad" fails.
constexpr const char* weaver = R"(
    folder=${1#--output=}
    for film; do :; done
    choice=
    [ $# -lt 3 ] || choice=$(sha256sum < "${2#--keyframes=}" | head -c 32)
    name=${film##*/}
    echo "$name" >> "$0.log"
    read -r word < "$film"
    [ "$word" != bad ] || exit 1
    mkdir -p "$folder/tiles-1/0"
    [ "$word" != gate ] || read -r _ < "$0.gate"
    echo '{"version":1,"path":"'"$name"'","bytes":'$(stat -c %s "$film")',"mtime_ns":'$(date -r "$film" +%s%N)','\
         '"choice":"'"$choice"'","duration_ns":9,"complete":true,"folder":"tiles-1","height":150,"tile_width":512,"brick_width":178,"levels":[]}' \
         > "$folder/index.new" && mv "$folder/index.new" "$folder/index.json")";

struct House {
    House() : read(home.write("reader.sh", reader)), weave(home.write("weaver.sh", weaver)) {
        fs::create_directories(root);
        for (const fs::path& script : {read, weave})
            ::mkfifo((script.string() + ".gate").c_str(), 0600);
    }

    void start() {
        daemon = std::make_unique<Daemon>(
            loop, WatchOptions{.root = root,
                               .catalogue = home.path / "catalogue",
                               .store = home.path / "store",
                               .state = home.path,
                               .analysis = {.words = {"/bin/sh", read.string()},
                                            .limits = {.patience = {.computing = 50s, .idling = 50s}}},
                               .weave = {"/bin/sh", weave.string()},
                               .tapestries = {.max_bytes = max_bytes},
                               .pace = {.children = 2,
                                        .quiet = 1ms,
                                        .rename_grace = 100ms,
                                        .first_retry = 1ms,
                                        .retries = 2},
                               .rescan = 1h,
                               .is_once = is_once,
                               .weaves = weaves});
    }

    fs::path drop(const std::string& name, const std::string& content = "film\n") const {
        return home.write("media/" + name, content);
    }

    bool comes_true(const std::function<bool()>& condition) {
        const auto end = EventLoop::Clock::now() + patience;
        while (!condition() && EventLoop::Clock::now() < end)
            loop.run_once(100ms);
        return condition();
    }

    bool has_woven(const std::string& path) const {
        return fs::exists(tapestry_folder(home.path, path) / "index.json");
    }

    std::ptrdiff_t weavings() const {
        std::ifstream log(weave.string() + ".log");
        return std::count(std::istreambuf_iterator<char>(log), {}, '\n');
    }

    std::size_t records() const { return Catalogue(home.path / "catalogue").load().size(); }

    std::uint64_t max_bytes = 1 << 20;
    bool is_once = false;
    bool weaves = true;
    TemporaryDirectory home;
    fs::path root = home.path / "media";
    fs::path read;
    fs::path weave;
    EventLoop loop;
    std::unique_ptr<Daemon> daemon;
};

}  // namespace

TEST_CASE("a film whose bars an earlier version did not see is woven anew") {
    House house;
    house.drop("a.mp4");
    house.start();
    REQUIRE(house.comes_true([&] { return house.has_woven("a.mp4"); }));
    house.daemon.reset();
    const Catalogue catalogue(house.home.path / "catalogue");
    MediaRecord record = *catalogue.find("a.mp4");
    record.shots[0].analysis = 1;
    record.shots[0].picture = Box{{1, 0}, {3, 3}};
    catalogue.store(record);

    house.start();
    CHECK(house.comes_true([&] { return house.weavings() == 2 && house.has_woven("a.mp4"); }));
}

TEST_CASE("a film has its tapestry after its analysis, once, also over a restart") {
    House house;
    house.drop("film.mp4");
    house.start();
    REQUIRE(house.comes_true([&] { return house.has_woven("film.mp4"); }));
    house.daemon.reset();
    house.start();
    house.drop("next.mp4");
    REQUIRE(house.comes_true([&] { return house.has_woven("next.mp4"); }));
    CHECK(house.weavings() == 2);
}

TEST_CASE("nothing is woven while something is analysed") {
    House house;
    house.drop("film.mp4");
    house.drop("slow.mp4", "slow\n");
    house.start();
    REQUIRE(house.comes_true([&] { return house.records() == 1; }));
    for (int i = 0; i < 20; ++i)
        house.loop.run_once(10ms);
    CHECK(house.weavings() == 0);
    std::ofstream(house.read.string() + ".gate") << "go\n";
    CHECK(house.comes_true([&] { return house.has_woven("film.mp4") && house.has_woven("slow.mp4"); }));
}

TEST_CASE("a film is woven anew when its keyframes are chosen, otherwise, or not any more, and then only") {
    House house;
    house.drop("film.mp4");
    house.drop("other.mp4");
    house.start();
    const auto choice = [&] { return read_tapestry(tapestry_folder(house.home.path, "film.mp4")).choice; };
    REQUIRE(house.comes_true([&] { return house.has_woven("film.mp4") && house.has_woven("other.mp4"); }));
    CHECK(choice().empty());
    const fs::path file = house.drop("film.mp4.tapestry.toml", "keyframes = [\"0:12\"]\nstrik = [1]\n");
    const std::string chosen = key_of({.keyframes = {12s}});
    CHECK(house.comes_true([&] { return choice() == chosen; }));
    CHECK(house.records() == 2);
    house.daemon.reset();
    house.start();
    house.drop("next.mp4");
    REQUIRE(house.comes_true([&] { return house.has_woven("next.mp4"); }));
    CHECK(house.weavings() == 4);
    house.drop("film.mp4.tapestry.toml", "strike = [3]\n");
    CHECK(house.comes_true([&] { return choice() == key_of({.struck = {3s}}); }));
    fs::remove(file);
    CHECK(house.comes_true([&] { return choice().empty(); }));
    CHECK(house.weavings() == 6);
}

TEST_CASE(
    "keyframes that a technician chooses by touch come to those of the file, and the film is woven anew") {
    House house;
    house.drop("film.mp4");
    house.start();
    REQUIRE(house.comes_true([&] { return house.has_woven("film.mp4"); }));
    const auto chosen = [&] {
        try {
            return read_tapestry(tapestry_folder(house.home.path, "film.mp4")).choice;
        } catch (const std::exception&) {  // it is just replaced
            return std::string("none");
        }
    };
    write_keyframe_note(house.home.path, "film.mp4", "strike = [3]\n");
    REQUIRE(house.comes_true([&] { return chosen() == key_of({.struck = {3s}}); }));

    house.drop("film.mp4.tapestry.toml", "keyframes = [1, 3]\n");
    house.daemon.reset();
    house.start();
    const KeyframeChoice both{.keyframes = {1s}, .struck = {3s}};
    REQUIRE(house.comes_true([&] { return chosen() == key_of(both); }));
    write_keyframe_note(house.home.path, "film.mp4", "");
    CHECK(house.comes_true([&] { return chosen() == key_of({.keyframes = {1s, 3s}}); }));
    CHECK(house.weavings() == 4);
}

TEST_CASE("the film that a visitor waits for is woven while another is analysed") {
    House house;
    house.drop("film.mp4");
    house.drop("other.mp4");
    house.drop("slow.mp4", "slow\n");
    house.start();
    REQUIRE(house.comes_true([&] { return house.records() == 2; }));
    want_tapestry(house.home.path, "film.mp4");
    CHECK(house.comes_true([&] { return house.has_woven("film.mp4"); }));
    CHECK_FALSE(house.has_woven("other.mp4"));
    CHECK(house.weavings() == 1);
    std::ofstream(house.read.string() + ".gate") << "go\n";
    CHECK(house.comes_true([&] { return house.has_woven("other.mp4") && house.has_woven("slow.mp4"); }));
}

TEST_CASE("the film that a visitor waits for takes the place of the one that is woven, which follows") {
    House house;
    house.drop("gate.mp4", "gate\n");
    house.start();
    REQUIRE(house.comes_true([&] { return house.weavings() == 1; }));
    house.drop("wanted.mp4");
    want_tapestry(house.home.path, "wanted.mp4");
    CHECK(house.comes_true([&] { return house.has_woven("wanted.mp4"); }));
    CHECK_FALSE(house.has_woven("gate.mp4"));
    REQUIRE(house.comes_true([&] { return house.weavings() == 3; }));
    std::ofstream(house.weave.string() + ".gate") << "go\n";
    CHECK(house.comes_true([&] { return house.has_woven("gate.mp4"); }));
}

TEST_CASE("a tapestry that has lost its place is woven again when a visitor waits for it") {
    House house;
    const fs::path film = house.drop("film.mp4");
    house.start();
    REQUIRE(house.comes_true([&] { return house.has_woven("film.mp4"); }));
    house.daemon.reset();
    const MediaRecord record = Catalogue(house.home.path / "catalogue").load().front();
    const fs::path folder = tapestry_folder(house.home.path, "film.mp4");
    fs::remove_all(folder);
    note_dropped(folder, record.bytes, record.mtime_ns);
    house.start();
    for (int i = 0; i < 20; ++i)
        house.loop.run_once(10ms);
    REQUIRE_FALSE(house.has_woven("film.mp4"));
    want_tapestry(house.home.path, "film.mp4");
    CHECK(house.comes_true([&] { return house.has_woven("film.mp4"); }));
}

TEST_CASE("a tapestry goes with its film, comes along with its name and is woven anew when it changes") {
    House house;
    house.drop("gone.mp4");
    house.drop("from.mp4");
    const fs::path changed = house.drop("changed.mp4");
    house.start();
    REQUIRE(house.comes_true([&] {
        return house.has_woven("gone.mp4") && house.has_woven("from.mp4") && house.has_woven("changed.mp4");
    }));
    fs::remove(house.root / "gone.mp4");
    fs::rename(house.root / "from.mp4", house.root / "to.mp4");
    house.drop("changed.mp4", "another film\n");
    CHECK(house.comes_true([&] { return !house.has_woven("gone.mp4") && !house.has_woven("from.mp4"); }));
    CHECK(house.has_woven("to.mp4"));
    CHECK(house.comes_true([&] {
        return house.has_woven("changed.mp4") &&
               read_tapestry(tapestry_folder(house.home.path, "changed.mp4")).bytes == 13;
    }));
    CHECK(house.weavings() == 4);
}

TEST_CASE("the weaving of a film that is deleted ends and leaves nothing") {
    House house;
    const fs::path film = house.drop("film.mp4", "gate\n");
    house.start();
    const fs::path folder = tapestry_folder(house.home.path, "film.mp4");
    REQUIRE(house.comes_true([&] { return fs::exists(folder / "tiles-1/0"); }));
    fs::remove(film);
    CHECK(house.comes_true([&] { return house.records() == 0 && !fs::exists(folder); }));
    house.drop("next.mp4");
    CHECK(house.comes_true([&] { return house.has_woven("next.mp4"); }));
}

TEST_CASE("what cannot be woven keeps no other film waiting") {
    House house;
    house.drop("bad.mp4", "bad\n");
    house.start();
    REQUIRE(house.comes_true([&] { return house.weavings() == 2; }));
    house.drop("good.mp4");
    CHECK(house.comes_true([&] { return house.has_woven("good.mp4"); }));
    CHECK(house.weavings() == 3);
}

TEST_CASE("where tapestries are turned off, or only the catalogue is wanted, none are woven") {
    for (const std::uint64_t max_bytes : {0, 1 << 20}) {
        CAPTURE(max_bytes);
        House house;
        house.max_bytes = max_bytes;
        house.is_once = max_bytes > 0;
        house.weaves = max_bytes == 0;
        house.drop("film.mp4");
        house.start();
        CHECK(house.comes_true([&] { return house.records() == 1; }));
        for (int i = 0; i < 20 && !house.is_once; ++i)
            house.loop.run_once(10ms);
        CHECK(house.weavings() == 0);
    }
}

TEST_CASE("once means until every film that can be woven is woven") {
    House house;
    house.is_once = true;
    house.drop("film.mp4");
    house.drop("other.mp4");
    house.drop("bad.mp4", "bad\n");
    house.start();
    house.loop.run();
    CHECK(house.has_woven("film.mp4"));
    CHECK(house.has_woven("other.mp4"));
    CHECK(house.daemon->is_up_to_date());
}
