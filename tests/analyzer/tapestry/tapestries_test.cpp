#include "analyzer/tapestry/tapestries.hpp"

#include "analyzer/store/disk_use.hpp"
#include "analyzer/tapestry/tapestry_state.hpp"
#include "base/state/tapestry.hpp"
#include "tests/temporary_directory.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <array>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

namespace {

MediaRecord film(const std::string& path, std::uint64_t bytes = 5) {
    return {.path = path, .kind = MediaKind::film, .bytes = bytes, .mtime_ns = 7, .state = MediaState::ready};
}

constexpr std::int64_t newest = 1'700'000'000;  // s since 1970

struct State {
    /// A tapestry of a tile of 1000 bytes.
    /// @param age  seconds since it was looked at
    void weave(const std::string& path, bool is_complete = true, int age = 0, std::uint64_t bytes = 5) const {
        const fs::path folder = tapestry_folder(home.path, path);
        fs::create_directories(folder / "tiles-1" / "0");
        std::ofstream(folder / "tiles-1" / "0" / "000000.jpg") << std::string(1000, 'x');
        write_tapestry(folder, {.path = path,
                                .bytes = bytes,
                                .mtime_ns = 7,
                                .is_complete = is_complete,
                                .folder = "tiles-1",
                                .height = 150,
                                .tile_width = 512,
                                .brick_width = 178,
                                .levels = {}});
        std::array<timespec, 2> times{};
        times.fill({.tv_sec = newest - age, .tv_nsec = 0});
        REQUIRE(::utimensat(AT_FDCWD, (folder / "index.json").c_str(), times.data(), 0) == 0);
    }

    std::int64_t age(const std::string& path) const {
        struct stat status {};

        REQUIRE(::stat((tapestry_folder(home.path, path) / "index.json").c_str(), &status) == 0);
        return newest - used_ns(status) / 1'000'000'000;
    }

    bool has(const std::string& path) const {
        return fs::exists(tapestry_folder(home.path, path) / "index.json");
    }

    bool has_tiles(const std::string& path) const {
        return fs::exists(tapestry_folder(home.path, path) / "tiles-1");
    }

    TemporaryDirectory home;
};

}  // namespace

TEST_CASE("a tapestry is wanted of films that are ready and have none that is whole") {
    const State state;
    Tapestries tapestries(state.home.path, {.max_bytes = 1 << 20});
    CHECK(tapestries.hold(film("new")));
    MediaRecord other = film("photo");
    other.kind = MediaKind::photo;
    CHECK_FALSE(tapestries.hold(other));
    other = film("growing");
    other.is_complete = false;
    CHECK_FALSE(tapestries.hold(other));
    other = film("broken");
    other.state = MediaState::failed;
    CHECK_FALSE(tapestries.hold(other));
    state.weave("woven");
    CHECK_FALSE(tapestries.hold(film("woven")));
    state.weave("begun", false);
    CHECK(tapestries.hold(film("begun")));
    CHECK(state.has("begun"));
    Tapestries off(state.home.path, {.max_bytes = 0});
    CHECK_FALSE(off.hold(film("new")));
}

TEST_CASE("a tapestry goes when its film is another or gone, and comes along when it is renamed") {
    const State state;
    Tapestries tapestries(state.home.path, {.max_bytes = 1 << 20});
    for (const char* path : {"changed", "gone", "from"}) {
        state.weave(path);
        tapestries.hold(film(path));
    }
    state.home.write("tapestry/" + record_id("changed") + "/frames", "of the new film");
    CHECK(tapestries.hold(film("changed", 6)));
    CHECK_FALSE(state.has("changed"));
    CHECK_FALSE(state.has_tiles("changed"));
    CHECK(fs::exists(tapestry_folder(state.home.path, "changed") / "frames"));
    tapestries.release("gone");
    CHECK_FALSE(state.has_tiles("gone"));
    tapestries.move("from", "to");
    CHECK_FALSE(tapestries.hold(film("to")));
    tapestries.release("from");
    CHECK_FALSE(state.has("from"));
    REQUIRE(state.has("to"));
    CHECK(read_tapestry(tapestry_folder(state.home.path, "to")).path == "to");
}

TEST_CASE("tiles that sharper ones replaced go after ten minutes, for a player may show them until then") {
    const State state;
    const fs::path folder = tapestry_folder(state.home.path, "a");
    state.weave("a");
    fs::create_directories(folder / "tiles-0" / "0");
    Tapestries tapestries(state.home.path, {.max_bytes = 1 << 20, .min_free_bytes = 0});
    tapestries.hold(film("a"));

    SUBCASE("replaced just now") {
        write_tapestry(folder, read_tapestry(folder));
        tapestries.remove_replaced();
        CHECK(fs::exists(folder / "tiles-0"));
    }
    SUBCASE("replaced long ago") {
        tapestries.remove_replaced();
        CHECK_FALSE(fs::exists(folder / "tiles-0"));
    }
    SUBCASE("not complete") {
        state.weave("a", false);
        tapestries.remove_replaced();
        CHECK(fs::exists(folder / "tiles-0"));
    }
    CHECK(state.has_tiles("a"));
}

TEST_CASE("what is of no film is swept away, all of it where tapestries are turned off") {
    const State state;
    for (const char* path : {"held", "analysed", "nobody's"})
        state.weave(path);
    Tapestries tapestries(state.home.path, {.max_bytes = 1 << 20});
    tapestries.hold(film("held"));
    tapestries.sweep({"analysed"});
    CHECK(state.has("held"));
    CHECK(state.has("analysed"));
    CHECK_FALSE(state.has("nobody's"));
    Tapestries off(state.home.path, {.max_bytes = 0});
    off.hold(film("held"));
    off.sweep({"held"});
    CHECK(fs::is_empty(state.home.path / "tapestry"));
}

TEST_CASE("beyond the bound the tapestry looked at longest ago goes and is not woven again") {
    const State state;
    Tapestries tapestries(state.home.path, {.max_bytes = 3500});
    state.weave("busy", true, 90);
    state.weave("oldest", true, 80);
    state.weave("newest", true, 1);
    for (const char* path : {"busy", "oldest", "newest"})
        tapestries.hold(film(path));
    CHECK(state.age("oldest") == 80);  // holding a tapestry does not make it younger
    CHECK(tapestries.make_room("busy").empty());
    state.home.write("tapestry/" + record_id("busy") + "/more", std::string(1000, 'x'));
    tapestries.look_at("busy");
    CHECK(tapestries.make_room("busy") == std::vector<std::string>{"oldest"});
    CHECK(tapestries.make_room("busy").empty());
    CHECK_FALSE(state.has_tiles("oldest"));
    CHECK(state.has("busy"));
    CHECK(state.has("newest"));
    CHECK_FALSE(tapestries.hold(film("oldest")));
    CHECK_FALSE(Tapestries(state.home.path, {.max_bytes = 3500}).hold(film("oldest")));
    CHECK(tapestries.hold(film("oldest", 6)));
}

TEST_CASE("frames that wait to be woven give way first, and their film is still woven") {
    const State state;
    Tapestries tapestries(state.home.path, {.max_bytes = 1500});
    state.weave("woven", true, 80);
    state.home.write("tapestry/" + record_id("waiting") + "/frames", std::string(1000, 'x'));
    tapestries.hold(film("woven"));
    CHECK(tapestries.hold(film("waiting")));
    CHECK(tapestries.make_room("").empty());
    CHECK(state.has("woven"));
    CHECK_FALSE(fs::exists(tapestry_folder(state.home.path, "waiting") / "frames"));
    CHECK(tapestries.hold(film("waiting")));
}
