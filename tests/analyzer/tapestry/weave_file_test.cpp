#include "analyzer/tapestry/weave_file.hpp"

#include "analyzer/tapestry/weave/kept_frames.hpp"
#include "base/state/tapestry.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <opencv2/core.hpp>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace vitrine::analyzer {
namespace {

namespace fs = std::filesystem;

const fs::path nasa = fs::path(VITRINE_MEDIA) / "edited/nasa_13013_320x180.mp4";

Settings without_faces() {
    Settings settings;
    settings.analyzer.face_model.clear();
    settings.analyzer.face_cascade.clear();
    return settings;
}

FilmContent content_of(const fs::path& file) {
    struct stat status {};

    REQUIRE(::stat(file.c_str(), &status) == 0);
    return {.bytes = static_cast<std::uint64_t>(status.st_size),
            .mtime_ns = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

void keep_three_frames(const fs::path& folder, const FilmContent& of) {
    KeptFrames frames(folder, 1 << 20);
    for (int i = 0; i < 3; ++i) {
        cv::Mat picture(48, 64, CV_8UC3, cv::Scalar::all(80 * i));
        picture.colRange(20 * i, 20 * i + 20).setTo(cv::Scalar(200, 10, 90));
        frames.saw({.picture = picture, .time = std::chrono::seconds(i)});
    }
    frames.finish({.kind = MediaKind::film, .duration = std::chrono::seconds(3)}, of);
}

}  // namespace

TEST_CASE("errors name the file" * doctest::test_suite("real")) {
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

TEST_CASE("a film is woven of the times chosen by hand" * doctest::test_suite("real")) {
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

TEST_CASE("a film of one level has no zoom, and says so" * doctest::test_suite("real")) {
    if (!fs::exists(nasa)) {
        MESSAGE("not here: ", nasa.string());
        return;
    }
    const TemporaryDirectory folder;
    const fs::path times = folder.write("times", "0\n4\n");
    CHECK_THROWS_WITH(
        weave_file({.file = nasa, .zoom = folder.path / "zoom.png", .levels = 1, .times = times},
                   without_faces()),
        doctest::Contains("one level only"));
    CHECK_FALSE(fs::exists(folder.path / "zoom.png"));
}

TEST_CASE("a film is woven as tall as the settings want it, where it is not smaller" *
          doctest::test_suite("real")) {
    if (!fs::exists(nasa)) {
        MESSAGE("not here: ", nasa.string());
        return;
    }
    const TemporaryDirectory folder;
    const fs::path times = folder.write("times", "1\n7\n");
    const fs::path out = folder.path / "out";
    for (const int height : {240, 600}) {
        CAPTURE(height);
        Settings settings = without_faces();
        settings.tapestry.height = height;
        fs::remove_all(out);
        (void)weave_file({.file = nasa, .directory = out, .levels = 1, .times = times, .resumes = true},
                         settings);
        const Tapestry tapestry = read_tapestry(out);
        CHECK(tapestry.height == std::min(height, 270));  // the film is 180 px tall
        CHECK(tapestry.is_complete);
        CHECK(tapestry.levels[0].keyframes.size() == 2);
        std::vector<std::string> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(out))
            names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        // The coarse tiles stay for a player that still shows them. The daemon removes them later.
        CHECK(names == std::vector<std::string>{"index.json", "tiles-1", "tiles-1-first", tapestry.folder});
    }
}

TEST_CASE(
    "a weaving that is resumed needs no film where its frames were kept, and cleans up when it is done") {
    const TemporaryDirectory folder;
    const fs::path text = folder.write("films/notes.txt", "no film at all");
    const fs::path out = folder.path / "out";

    const FilmContent content = content_of(text);
    Settings settings = without_faces();
    settings.media.root = folder.path / "films";
    const WeaveRequest request{.file = text, .directory = out, .resumes = true, .threads = 1};

    keep_three_frames(out, {.bytes = 13, .mtime_ns = content.mtime_ns});
    CHECK_THROWS_WITH(weave_file(request, settings), doctest::Contains("notes.txt"));
    keep_three_frames(out, content);
    (void)weave_file(request, settings);
    const Tapestry tapestry = read_tapestry(out);
    CHECK(tapestry.path == "notes.txt");
    CHECK(tapestry.bytes == 14);
    CHECK(tapestry.is_complete);
    REQUIRE(tapestry.levels.size() == 1);
    CHECK(tapestry.levels[0].keyframes.size() == 3);
    CHECK(fs::exists(out / tapestry.tile_name(0, 0)));
    CHECK_FALSE(fs::exists(out / "frames"));
    CHECK_FALSE(fs::exists(out / "plan"));
}

TEST_CASE("a first view is there before anything is woven") {
    const TemporaryDirectory folder;
    const fs::path text = folder.write("films/notes.txt", "no film at all");
    const fs::path out = folder.path / "out";
    keep_three_frames(out, content_of(text));
    folder.write("out/plan.new/in-the-way", "");  // so that the plan cannot be written: nothing is woven

    Settings settings = without_faces();
    settings.media.root = folder.path / "films";
    const WeaveRequest request{.file = text, .directory = out, .resumes = true, .threads = 1};
    CHECK_THROWS(weave_file(request, settings));
    const Tapestry first = read_tapestry(out);
    CHECK_FALSE(first.is_complete);
    CHECK(first.folder == "tiles-1-first");
    REQUIRE(first.levels.size() == 1);
    CHECK(fs::exists(out / first.tile_name(0, 0)));

    fs::remove_all(out / "plan.new");
    (void)weave_file(request, settings);
    CHECK(read_tapestry(out).is_complete);
    CHECK_FALSE(fs::exists(out / "tiles-1-first"));
}

}  // namespace vitrine::analyzer
