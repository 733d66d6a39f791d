#include "analyzer/weave_file.hpp"

#include "base/catalogue/tapestry.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <fstream>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

const fs::path nasa = fs::path(VITRINE_SHARED_MEDIA) / "edited/nasa_13013_320x180.mp4";

Settings without_faces() {
    Settings settings;
    settings.analyzer.face_cascade.clear();
    return settings;
}

}  // namespace

TEST_CASE("errors name the file") {
    const TemporaryDirectory folder;
    const fs::path text = folder.write("notes.txt", "no film at all");
    const fs::path times = folder.write("times", "1.5\nsoon\n");
    CHECK_THROWS_WITH(
        weave_file({.file = folder.path / "gone.mp4", .sheet = folder.path / "s.png"}, without_faces()),
        doctest::Contains("gone.mp4"));
    CHECK_THROWS_WITH(weave_file({.file = text, .sheet = folder.path / "s.png"}, without_faces()),
                      doctest::Contains("notes.txt"));
    CHECK_THROWS_WITH(
        weave_file({.file = text, .sheet = folder.path / "s.png", .times = times}, without_faces()),
        doctest::Contains("line 2: 'soon'"));
}

TEST_CASE("a film is woven of the times chosen by hand") {
    if (!fs::exists(nasa)) {
        MESSAGE("not here: ", nasa.string());
        return;
    }
    const TemporaryDirectory folder;
    const fs::path times = folder.write("times", "# the first\n0\n4.1  # a later one\n\n8\n");
    (void)weave_file({.file = nasa, .directory = folder.path / "out", .levels = 1, .times = times},
                     without_faces());
    const Tapestry tapestry = read_tapestry(folder.path / "out");

    using std::chrono::milliseconds;
    REQUIRE(tapestry.levels.size() == 1);
    REQUIRE(tapestry.levels[0].keyframes.size() == 3);
    CHECK(tapestry.levels[0].keyframes[0] == milliseconds(0));
    CHECK(std::chrono::abs(tapestry.levels[0].keyframes[1] - milliseconds(4100)) <= milliseconds(300));
    CHECK(tapestry.path == "nasa_13013_320x180.mp4");
    CHECK(fs::file_size(folder.path / "out" / tapestry.tile_name(0, 0)) > 1000);
}

}  // namespace vitrine
