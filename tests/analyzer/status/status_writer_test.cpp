#include "analyzer/status/status_writer.hpp"

#include "base/state/played_times.hpp"
#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr auto* id = "0123456789abcdef";

struct Share {
    TemporaryDirectory root{}, state{};
    EventLoop loop{};
    StatusReport report{};
    int asked = 0;
    StatusWriter writer{loop, root.path, "_STATUS", state.path, [this] {
                            ++asked;
                            return report;
                        }};

    Share() { report.files = {{.file = {.path = "a.jpg", .state = FileState::State::ready}, .id = id}}; }

    fs::path file(const std::string& name) const { return root.path / "_STATUS" / name; }
};

}  // namespace

TEST_CASE("what is said goes to the share and the state directory, with thumbnails and the wall") {
    Share share;
    share.state.write("thumbnails/" + std::string(id) + "/thumbnail.jpg", "thumbnail");
    share.state.write("wall.jpg", "wall");
    share.writer.write();
    CHECK(read_file(share.file("status.txt")) ==
          "1 file: 1 ready\nThe player is not running.\n\na.jpg: ready\n");
    CHECK(read_file(share.file("index.html")).find(id) != std::string::npos);
    CHECK(read_file(share.file("thumbnails/" + std::string(id) + ".jpg")) == "thumbnail");
    CHECK(read_file(share.file("wall.jpg")) == "wall");
    CHECK(read_file(share.state.path / "status.json").find("a.jpg") != std::string::npos);
}

TEST_CASE("how long each file was seen goes to the share as tables") {
    Share share;
    share.state.write("played/2026-12-24", played_text("2026-12-24", {{"a.jpg", 10s}, {"=b \"\n.jpg", 5s}}));
    share.state.write("played/now", played_text("2026-12-24", {{"a.jpg", 12500ms}}));
    share.state.write("played/other", "x");
    share.writer.write();
    CHECK(read_file(share.file("played/2026-12-24.csv")) ==
          "file,seconds\r\n\"/=b \"\"\\x0a.jpg\",5.0\r\n\"/a.jpg\",12.5\r\n");
    CHECK(!fs::exists(share.file("played/other.csv")));
    share.writer.write();
    CHECK(read_file(share.file("index.html")).find("href=\"played/\"") != std::string::npos);
}

TEST_CASE("the page tells why the player keeps a file off the wall, and when the player does not run") {
    Share share;
    const std::vector<FileVisibility> files{
        {.path = "a.jpg", .visibility = Visibility::out_of_hours, .detail = "from 20:00 to 21:00"}};
    const fs::path note = share.state.write(visible_file, visible_json(files));
    share.writer.write();
    const std::string sentence = "a.jpg: ready. It is out of its hours: it is shown from 20:00 to 21:00.\n";
    CHECK(read_file(share.file("status.txt")) == "1 file: 1 ready\n\n" + sentence);
    CHECK(read_file(share.file("index.html")).find("<li class=\"wait\">") != std::string::npos);

    fs::last_write_time(note, fs::file_time_type::clock::now() - 31s);  // left by a player that has ended
    share.writer.write();
    CHECK(read_file(share.file("status.txt")) ==
          "1 file: 1 ready\nThe player is not running.\n\na.jpg: ready\n");
    CHECK(read_file(share.file("index.html")).find("The player is not running.") != std::string::npos);
}

TEST_CASE("a file that is removed leaves with its thumbnail, one that is replaced has another") {
    Share share;
    const fs::path made = share.state.write("thumbnails/" + std::string(id) + "/thumbnail.jpg", "first");
    const std::string copied = "thumbnails/" + std::string(id) + ".jpg";
    share.writer.write();
    replace_file(made, "second");
    fs::last_write_time(made, fs::last_write_time(made) + 1s);
    share.writer.write();
    CHECK(read_file(share.file(copied)) == "second");
    fs::remove(share.file(copied));  // by somebody
    share.writer.write();
    share.writer.write();
    CHECK(read_file(share.file(copied)) == "second");
    share.report.files.clear();
    share.writer.write();
    CHECK_FALSE(fs::exists(share.file(copied)));
    CHECK(read_file(share.file("status.txt")) == "0 files\nThe player is not running.\n\n");
}

TEST_CASE("a thumbnail that no file on the page has goes after a while") {
    Share share;
    const fs::path young = share.state.write("thumbnails/young/thumbnail.jpg", "a");
    const fs::path old = share.state.write("thumbnails/old/thumbnail.jpg", "a");
    fs::last_write_time(old.parent_path(), fs::file_time_type::clock::now() - 1h);
    share.writer.write();
    CHECK(fs::exists(young));
    CHECK_FALSE(fs::exists(old.parent_path()));
}

TEST_CASE("nothing is written where a share is not mounted or not writable, but into the state directory") {
    Share share;
    share.report.is_online = false;
    share.writer.write();
    CHECK(fs::is_empty(share.root.path));
    CHECK(fs::exists(share.state.path / "status.json"));
    share.report.is_online = true;
    share.root.write("_STATUS", "a file in its place");
    share.writer.write();
    fs::remove(share.root.path / "_STATUS");
    share.writer.write();
    CHECK(fs::exists(share.file("status.txt")));
}

TEST_CASE("names that somebody blocks keep no other file from being written") {
    Share share;
    share.state.write("thumbnails/" + std::string(id) + "/thumbnail.jpg", "thumbnail");
    share.state.write("wall.jpg", "wall");
    for (const char* name : {"index.html", "wall.jpg", "thumbnails/0123456789abcdef.jpg"})
        share.root.write("_STATUS/" + std::string(name) + "/theirs", "theirs");
    share.root.write("_STATUS/.vitrine-0123456789abcdef", "half");
    share.writer.write();
    CHECK(fs::exists(share.file("status.txt")));
    CHECK_FALSE(fs::exists(share.file(".vitrine-0123456789abcdef")));

    for (const char* name : {"index.html", "wall.jpg", "thumbnails/0123456789abcdef.jpg"})
        fs::remove_all(share.file(name));
    share.writer.write();
    CHECK(fs::is_regular_file(share.file("index.html")));
    CHECK(read_file(share.file("wall.jpg")) == "wall");
    CHECK(read_file(share.file("thumbnails/0123456789abcdef.jpg")) == "thumbnail");
}

TEST_CASE("many changes together are written once") {
    Share share;
    for (int i = 0; i < 1000; ++i)
        share.writer.touch();
    while (share.asked == 0)
        share.loop.run_once(10s);
    for (int i = 0; i < 1000; ++i)
        share.writer.touch();
    share.loop.run_once(0s);
    CHECK(share.asked == 1);
}
