#include "base/system/directory_watch.hpp"

#include "tests/temporary_directory.hpp"

#include <algorithm>

using namespace vitrine;
using Kind = DirectoryEvent::Kind;
namespace fs = std::filesystem;

namespace {

bool has(const std::vector<DirectoryEvent>& events, const DirectoryEvent& event) {
    return std::find(events.begin(), events.end(), event) != events.end();
}

}  // namespace

// The kernel queues an event before the call that caused it returns: nothing here waits.

TEST_CASE("a file is news when it is closed, moved in, made readable or deleted, not while it is written") {
    const TemporaryDirectory directory;
    DirectoryWatch watch;
    REQUIRE(watch.add(directory.path));
    CHECK(watch.read().empty());
    {
        std::ofstream file(directory.path / "a.jpg");
        file << "half" << std::flush;
        CHECK(watch.read().empty());
    }
    CHECK(watch.read() == std::vector<DirectoryEvent>{{Kind::written, directory.path, "a.jpg"}});

    fs::permissions(directory.path / "a.jpg", fs::perms::owner_read);
    CHECK(watch.read() == std::vector<DirectoryEvent>{{Kind::changed, directory.path, "a.jpg"}});

    fs::rename(directory.path / "a.jpg", directory.path / "b\n\xff.jpg");
    CHECK(watch.read() == std::vector<DirectoryEvent>{{Kind::removed, directory.path, "a.jpg"},
                                                      {Kind::written, directory.path, "b\n\xff.jpg"}});
    fs::remove(directory.path / "b\n\xff.jpg");
    CHECK(watch.read() == std::vector<DirectoryEvent>{{Kind::removed, directory.path, "b\n\xff.jpg"}});
}

TEST_CASE("a new directory is told, and read after it was added nothing in it is missed") {
    const TemporaryDirectory directory;
    DirectoryWatch watch;
    REQUIRE(watch.add(directory.path));
    fs::create_directories(directory.path / "r" / "b");
    const auto events = watch.read();
    CHECK(events == std::vector<DirectoryEvent>{{Kind::directory_added, directory.path, "r"}});

    REQUIRE(watch.add(directory.path / "r"));
    CHECK(fs::exists(directory.path / "r" / "b"));  // only reading shows it
    REQUIRE(watch.add(directory.path / "r" / "b"));
    directory.write("r/b/x.jpg", "x");
    CHECK(has(watch.read(), {Kind::written, directory.path / "r" / "b", "x.jpg"}));
}

TEST_CASE("a directory that was moved is heard under its new name once it was removed and added again") {
    const TemporaryDirectory directory;
    fs::create_directories(directory.path / "old" / "inner");
    DirectoryWatch watch;
    REQUIRE(watch.add(directory.path));
    REQUIRE(watch.add(directory.path / "old"));
    REQUIRE(watch.add(directory.path / "old" / "inner"));
    CHECK(watch.size() == 3);

    fs::rename(directory.path / "old", directory.path / "new");
    const auto events = watch.read();
    CHECK(has(events, {Kind::directory_removed, directory.path, "old"}));
    CHECK(has(events, {Kind::directory_added, directory.path, "new"}));
    watch.remove(directory.path / "old");
    CHECK(watch.size() == 1);
    REQUIRE(watch.add(directory.path / "new"));
    REQUIRE(watch.add(directory.path / "new" / "inner"));

    directory.write("new/inner/x.jpg", "x");
    const auto after = watch.read();
    CHECK(after == std::vector<DirectoryEvent>{{Kind::written, directory.path / "new" / "inner", "x.jpg"}});
}

TEST_CASE("removing a directory keeps its neighbour of a longer name") {
    const TemporaryDirectory directory;
    fs::create_directories(directory.path / "a");
    fs::create_directories(directory.path / "ab");
    DirectoryWatch watch;
    REQUIRE(watch.add(directory.path / "a"));
    REQUIRE(watch.add(directory.path / "ab"));
    watch.remove(directory.path / "a");
    CHECK(watch.size() == 1);
    directory.write("ab/x", "x");
    CHECK(watch.read().size() == 1);
}

TEST_CASE("a watched directory that vanishes says so, and one that is not there is refused") {
    const TemporaryDirectory directory;
    fs::create_directories(directory.path / "root");
    DirectoryWatch watch;
    REQUIRE(watch.add(directory.path / "root"));
    fs::remove_all(directory.path / "root");
    CHECK(has(watch.read(), {Kind::self_gone, directory.path / "root", ""}));
    CHECK(watch.size() == 0);
    CHECK_FALSE(watch.add(directory.path / "root"));
    CHECK_FALSE(watch.add(directory.write("file", "x")));
}
