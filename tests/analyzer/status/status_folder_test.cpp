#include "analyzer/status/status_folder.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <system_error>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

TEST_CASE("files are replaced as a whole, and left alone where nothing has changed") {
    const TemporaryDirectory share;
    const StatusFolder folder(share.path, "_STATUS");
    folder.write("", "status.txt", "one");
    CHECK(read_file(share.path / "_STATUS/status.txt") == "one");
    const auto inode = [&] { return fs::last_write_time(share.path / "_STATUS/status.txt"); };
    fs::last_write_time(share.path / "_STATUS/status.txt", inode() - std::chrono::hours(1));
    const auto before = inode();
    folder.write("", "status.txt", "one");
    CHECK(inode() == before);
    folder.write("", "status.txt", "two");
    CHECK(inode() != before);
    CHECK(read_file(share.path / "_STATUS/status.txt") == "two");
    CHECK(folder.names("", ".txt") == std::set<std::string>{"status.txt"});
    CHECK(folder.names("", ".new").empty());
}

TEST_CASE("a folder in it is made, listed and emptied") {
    const TemporaryDirectory share;
    const StatusFolder folder(share.path, "_STATUS");
    folder.write("thumbnails", "a.jpg", "a");
    folder.write("thumbnails", "b.jpg", "b");
    folder.remove("thumbnails", "a.jpg");
    folder.remove("thumbnails", "a.jpg");
    CHECK(folder.names("thumbnails", ".jpg") == std::set<std::string>{"b.jpg"});
}

TEST_CASE("no link that somebody puts in its place is followed") {
    const TemporaryDirectory share;
    const TemporaryDirectory elsewhere;
    const StatusFolder folder(share.path, "_STATUS");
    fs::create_symlink(elsewhere.path, share.path / "_STATUS");
    CHECK_THROWS_AS(folder.write("", "status.txt", "one"), std::system_error);
    CHECK(fs::is_empty(elsewhere.path));

    fs::remove(share.path / "_STATUS");
    fs::create_directory(share.path / "_STATUS");
    elsewhere.write("precious", "precious");
    fs::create_symlink(elsewhere.path / "precious", share.path / "_STATUS/status.txt");
    fs::create_symlink(elsewhere.path / "precious", share.path / "_STATUS/status.txt.new");
    folder.write("", "status.txt", "one");
    CHECK(read_file(elsewhere.path / "precious") == "precious");
    CHECK(read_file(share.path / "_STATUS/status.txt") == "one");
}

TEST_CASE("a name that somebody takes beforehand blocks nothing") {
    const TemporaryDirectory share;
    const StatusFolder folder(share.path, "_STATUS");
    share.write("_STATUS/status.txt.new/theirs", "theirs");
    fs::create_directory(share.path / "_STATUS/status.txt");
    share.write("_STATUS/thumbnails", "a file in its place");
    folder.write("", "status.txt", "one");
    folder.write("thumbnails", "a.jpg", "a");
    CHECK(read_file(share.path / "_STATUS/status.txt") == "one");
    CHECK(read_file(share.path / "_STATUS/thumbnails/a.jpg") == "a");
    CHECK(fs::exists(share.path / "_STATUS/status.txt.new/theirs"));
}

TEST_CASE("a folder with files in the place of a file stays, and the error names it") {
    const TemporaryDirectory share;
    const StatusFolder folder(share.path, "_STATUS");
    share.write("_STATUS/index.html/theirs", "theirs");
    for (int i = 0; i < 2; ++i) {
        try {
            folder.write("", "index.html", "one");
            FAIL("a folder with files was replaced");
        } catch (const std::system_error& error) {
            CHECK(std::string(error.what())
                      .starts_with("write 'index.html', as a folder of that name is in the way"));
        }
    }
    CHECK(fs::exists(share.path / "_STATUS/index.html/theirs"));
    CHECK(folder.names("", "").size() == 3);  // with "." and "..": nothing is left half-written
}

TEST_CASE("what a killed analyzer has left half-written goes, and nothing else") {
    const TemporaryDirectory share;
    const StatusFolder folder(share.path, "_STATUS");
    share.write("_STATUS/.vitrine-0123456789abcdef", "half");
    share.write("_STATUS/.vitrine-notes", "theirs");
    folder.remove_unfinished("");
    CHECK_FALSE(fs::exists(share.path / "_STATUS/.vitrine-0123456789abcdef"));
    CHECK(fs::exists(share.path / "_STATUS/.vitrine-notes"));
}

TEST_CASE("where the share cannot be written an error says so") {
    const TemporaryDirectory share;
    CHECK_THROWS_AS(StatusFolder(share.path / "none", "_STATUS").write("", "a", "a"), std::system_error);
    share.write("_STATUS", "a file in its place");
    CHECK_THROWS_AS(StatusFolder(share.path, "_STATUS").write("", "a", "a"), std::system_error);
    if (::geteuid() == 0) return;  // root may write everywhere
    const TemporaryDirectory closed;
    fs::permissions(closed.path, fs::perms::owner_read | fs::perms::owner_exec);
    CHECK_THROWS_AS(StatusFolder(closed.path, "_STATUS").write("", "a", "a"), std::system_error);
    fs::permissions(closed.path, fs::perms::owner_all);
}
