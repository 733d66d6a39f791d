#include "analyzer/watch/media_folder.hpp"

#include "base/state/path_text.hpp"
#include "tests/temporary_directory.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::analyzer;
using Presence = MediaFolder::Presence;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> paths(const MediaFolder::Listing& listing) {
    std::vector<std::string> all;
    for (const MediaFolder::File& file : listing.files)
        all.push_back(file.path);
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE("what programs leave behind is junk, what people name their files is not") {
    for (const char* name : {".DS_Store", "._a.jpg", ".a.jpg.AbC123", "Thumbs.db", "THUMBS.DB", "desktop.ini",
                             "@eaDir", "~$a.doc", "a.jpg~", "a.mp4.part", "a.mp4.crdownload", "a.TMP",
                             ".~tmp~", "a.filepart", "_STATUS", "a.mp4.tapestry.toml", "a.jpg.txt"})
        CHECK_MESSAGE(is_junk_name(name), name);
    for (const char* name :
         {"a.jpg", "~a.jpg", "tmp", "part", "a b\n'\".jpg", "\xff\xfe", "thumbs.db.jpg", "_a", "$1.jpg"})
        CHECK_MESSAGE(!is_junk_name(name), name);
}

TEST_CASE("files in the inbox at the root are listed apart, and are no media") {
    const TemporaryDirectory directory;
    for (const char* name :
         {"_INBOX/a.jpg", "_INBOX/b/c.jpg", "_INBOX/c.mp4.tapestry.toml", "d.jpg", "e/_INBOX/f.jpg"})
        directory.write(name, "1");
    const MediaFolder folder(directory.path);
    std::vector<std::string> entered;

    auto listing = folder.list("", [&](const std::string& name) { entered.push_back(name); });

    CHECK(paths(listing) == std::vector<std::string>{"d.jpg", "e/_INBOX/f.jpg"});
    std::sort(listing.inbox.begin(), listing.inbox.end());
    CHECK(listing.inbox == std::vector<std::string>{"_INBOX/a.jpg", "_INBOX/b/c.jpg"});
    CHECK(listing.sidecars.empty());
    CHECK(std::find(entered.begin(), entered.end(), "_INBOX") == entered.end());
    CHECK(folder.list("_INBOX/b").files.empty());
    CHECK(folder.look_at("_INBOX/a.jpg").presence == Presence::gone);
    CHECK(folder.look_at("_inbox/a.jpg").presence == Presence::gone);
    CHECK(is_in_inbox("_Inbox/a.jpg"));
    CHECK_FALSE(is_in_inbox("_INBOX2/a.jpg"));
    CHECK_FALSE(is_in_inbox("a/_INBOX/a.jpg"));
}

TEST_CASE(
    "all files below the folder are listed whatever their names, each folder announced before it is read") {
    const TemporaryDirectory directory;
    const std::string odd = "odd \n'\"\xff" + std::string(200, 'x');
    directory.write("a.jpg", "12345");
    directory.write("b/" + odd, "1");
    directory.write("b/c/d.mp4", "1");
    directory.write("b/c/d.mp4.tapestry.toml", "1");
    directory.write("b/@eaDir/thumb.jpg", "1");
    directory.write("b/._d.mp4", "1");
    const MediaFolder folder(directory.path);
    std::vector<std::string> entered;

    const auto listing = folder.list("", [&](const std::string& name) { entered.push_back(name); });

    CHECK(paths(listing) == std::vector<std::string>{"a.jpg", "b/c/d.mp4", "b/" + odd});
    CHECK(listing.unread.empty());
    CHECK(entered == std::vector<std::string>{"", "b", "b/c"});
    CHECK(listing.sidecars == std::vector<std::string>{"b/c/d.mp4.tapestry.toml"});
    CHECK(paths(folder.list("b/c")) == std::vector<std::string>{"b/c/d.mp4"});
    CHECK(folder.list("b/@eaDir").files.empty());

    const auto look = folder.look_at("a.jpg");
    REQUIRE(look.presence == Presence::there);
    CHECK(look.file.facts.bytes == 5);
    CHECK(look.file.facts.inode != 0);
    CHECK(look.file.facts.is_readable);
    const auto same = std::find_if(listing.files.begin(), listing.files.end(),
                                   [](const auto& file) { return file.path == "a.jpg"; });
    CHECK(same->facts == look.file.facts);
}

TEST_CASE("no link leads out of the folder, and one in a circle ends nothing") {
    const TemporaryDirectory outside;
    const TemporaryDirectory directory;
    outside.write("secret.jpg", "1");
    fs::create_symlink(outside.path / "secret.jpg", directory.path / "file.jpg");
    fs::create_directory_symlink(outside.path, directory.path / "folder");
    fs::create_directory_symlink(directory.path, directory.path / "circle");
    const MediaFolder folder(directory.path);
    CHECK(folder.list("").files.empty());
    CHECK(folder.list("folder").files.empty());
    for (const char* path : {"file.jpg", "folder/secret.jpg", "circle/file.jpg", "../x", "nothing.jpg"})
        CHECK(folder.look_at(path).presence == Presence::gone);
    const auto escape = fs::relative(outside.path / "secret.jpg", directory.path).string();
    CHECK(folder.look_at(escape).presence == Presence::gone);
}

TEST_CASE("a folder that is not there is incomplete, not empty") {
    const TemporaryDirectory directory;
    const MediaFolder folder(directory.path / "unmounted");
    CHECK_FALSE(folder.list("").unread.empty());
    CHECK_FALSE(folder.device().has_value());
    CHECK(folder.look_at("a.jpg").presence == Presence::unreachable);
    fs::create_directories(directory.path / "unmounted");
    CHECK(folder.list("").unread.empty());
    CHECK(folder.device().has_value());
    CHECK(folder.look_at("a.jpg").presence == Presence::gone);
}

TEST_CASE("folders within folders end at the limit and say so") {
    const TemporaryDirectory directory;
    std::string deep;
    for (int i = 0; i < MediaFolder::max_depth + 3; ++i)
        deep += "d/";
    directory.write(deep + "a.jpg", "1");
    directory.write("b.jpg", "1");
    const auto listing = MediaFolder(directory.path).list("");
    CHECK(paths(listing) == std::vector<std::string>{"b.jpg"});
    CHECK(listing.unread.size() == 1);
    REQUIRE(listing.remarks.size() == 1);
    CHECK(listing.remarks[0].ends_with("too many folders within folders"));
}

TEST_CASE("a copy that reserved its space first has a hole until all of it is written") {
    const TemporaryDirectory directory;
    const fs::path file = directory.write("film.mp4", std::string(200'000, 'x'));
    const MediaFolder folder(directory.path);
    CHECK_FALSE(folder.ends_in_hole("film.mp4"));
    REQUIRE(::truncate(file.c_str(), 1'000'000) == 0);
    CHECK(folder.ends_in_hole("film.mp4"));
    std::ofstream(file) << std::string(1'000'000, 'y');
    CHECK_FALSE(folder.ends_in_hole("film.mp4"));
    CHECK_FALSE(folder.ends_in_hole("nothing.mp4"));
}

TEST_CASE(
    "our own folder is passed over, a hidden period is not, and the first bytes of a file can be read") {
    const TemporaryDirectory directory;
    directory.write("_INFO/index.html", "ours");
    directory.write("_INFO 2/a.jpg", "a");
    directory.write("..2026-12-24 Advent/b.jpg", "b");
    directory.write("..hidden/c.jpg", "c");
    directory.write("d/.vitrine.toml", "seconds = 20");
    directory.write("own/state/catalogue/1.json", "ours");
    const MediaFolder folder(directory.path, {"_INFO", "own/state"});
    std::vector<std::string> paths;
    for (const MediaFolder::File& file : folder.list("").files)
        paths.push_back(file.path);
    std::sort(paths.begin(), paths.end());
    CHECK(paths == std::vector<std::string>{"..2026-12-24 Advent/b.jpg", "_INFO 2/a.jpg"});
    CHECK(folder.look_at("_INFO/index.html").presence == MediaFolder::Presence::gone);
    CHECK(folder.look_at("own/state/catalogue/1.json").presence == MediaFolder::Presence::gone);
    CHECK(folder.list("_INFO").files.empty());
    CHECK(folder.content("d/.vitrine.toml", 100) == "seconds = 20");
    CHECK(folder.content("d/.vitrine.toml", 7) == "seconds");
    CHECK_FALSE(folder.content("d", 100));
    CHECK_FALSE(folder.content("d/none", 100));
    std::filesystem::create_symlink("/etc/passwd", directory.path / "link");
    CHECK_FALSE(folder.content("link", 100));
}
