#include "player/content/arrangement_files.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

using namespace vitrine;
using namespace vitrine::player;

namespace {

WallArrangement some_arrangement() {
    SlotShot shot{.slot = 3, .key = {"a \xff/b.jpg", 2}, .folder = "a \xff", .at = {0.1, {1.0 / 3, -2}}};
    shot.seat = {{7.7, 8.8}, 99.5};
    return {.walls = {{"", {.canvas = {1920, 1080}, .shots = {shot, {.slot = 4, .key = {"c.mp4", 0}}}}},
                      {"lobby", {.canvas = {720, 1280}, .shots = {}}}},
            .pinned = {"c.mp4", "\xfe"},
            .slots = {0, 7},
            .removed = {{.path = "d.png", .bytes = 12, .mtime_ns = -3}}};
}

}  // namespace

TEST_CASE("an arrangement is read as it was written, whatever the bytes of names") {
    CHECK(arrangement_from_json(arrangement_json(some_arrangement())) == some_arrangement());
    CHECK(arrangement_from_json(arrangement_json({})) == WallArrangement{});
}

TEST_CASE("the arrangement of the last run is kept in the state directory") {
    const TemporaryDirectory state;
    const ArrangementFiles files(state.path);
    CHECK_FALSE(files.last());
    files.write_last(some_arrangement());
    CHECK(ArrangementFiles(state.path).last() == some_arrangement());
}

TEST_CASE("a damaged arrangement is ignored") {
    const TemporaryDirectory state;
    const ArrangementFiles files(state.path);
    const std::string good = arrangement_json(some_arrangement());
    for (const std::string& bad :
         {std::string(), std::string("{"), std::string("[]"), good.substr(0, good.size() / 2),
          std::string(R"({"version":2,"walls":[],"pinned":[],"pinned_slots":[],"removed":[]})"),
          std::string(R"({"version":1,"walls":[{"outputs_folder":"","width":0,"height":9,"shots":[]}],)"
                      R"("pinned":[],"pinned_slots":[],"removed":[]})"),
          std::string(R"({"version":1,"walls":[],"pinned":[{"path_hex":"zz","path":""}],)"
                      R"("pinned_slots":[],"removed":[]})")}) {
        CAPTURE(bad);
        std::ofstream(state.path / "arrangement.json", std::ios::trunc) << bad;
        CHECK_FALSE(files.last());
    }
}

TEST_CASE("arrangements with a name are saved, listed, loaded and forgotten") {
    const TemporaryDirectory state;
    const ArrangementFiles files(state.path);
    CHECK(files.names().empty());
    files.save("summer-2026", some_arrangement());
    files.save("b", {});
    files.save("b", {.pinned = {"x"}});
    CHECK(files.names() == std::vector<std::string>{"b", "summer-2026"});
    CHECK(files.load("summer-2026") == some_arrangement());
    CHECK(files.load("b").pinned == std::set<std::string>{"x"});
    files.forget("b");
    CHECK(files.names() == std::vector<std::string>{"summer-2026"});
}

TEST_CASE("a layout that is not there is told by its name, with those that are") {
    const TemporaryDirectory state;
    const ArrangementFiles files(state.path);
    CHECK_THROWS_WITH(files.load("x"), "there is no layout 'x'; none has been saved");
    files.save("a", {});
    files.save("b", {});
    CHECK_THROWS_WITH(files.load("x"), "there is no layout 'x'; saved: a, b");
    CHECK_THROWS_WITH(files.forget("x"), "there is no layout 'x'");
    std::ofstream(state.path / "arrangements" / "a.json", std::ios::trunc) << "no";
    CHECK_THROWS_WITH_AS(files.load("a"), doctest::Contains("a.json' cannot be read"), std::runtime_error);
}

TEST_CASE("a name of a layout is never a path, and there are at most a hundred") {
    const TemporaryDirectory state;
    const ArrangementFiles files(state.path);
    for (const std::string& bad :
         {std::string(), std::string(".."), std::string(".a"), std::string("a/b"), std::string("a b"),
          std::string("-a"), std::string("\xc3\xa4"), std::string("a\0b", 3), std::string(65, 'a')}) {
        CAPTURE(bad);
        CHECK_FALSE(is_arrangement_name(bad));
        CHECK_THROWS_AS(files.save(bad, {}), std::runtime_error);
        CHECK_THROWS_AS(static_cast<void>(files.load(bad)), std::runtime_error);
        CHECK_THROWS_AS(files.forget(bad), std::runtime_error);
    }
    for (std::size_t k = 0; k < ArrangementFiles::max_named; ++k)
        files.save(std::string(1 + k / 26, 'x') + static_cast<char>('a' + k % 26), {});
    CHECK_THROWS_WITH(files.save("one-more", {}), "there are 100 layouts; forget one first");
}
