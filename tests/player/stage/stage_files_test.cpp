#include "player/stage/stage_files.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

using Paths = std::vector<std::string>;

RecordList records(const Paths& paths) {
    std::vector<MediaRecord> records;
    for (const std::string& path : paths)
        records.push_back({.path = path});
    return records;
}

Paths paths(const RecordList& records) {
    Paths paths;
    for (const RecordList::Record& record : records)
        paths.push_back(record->path);
    return paths;
}

}  // namespace

TEST_CASE("a stage shows its screens' folder, and of it the folder that a visitor looks into") {
    StageFiles files("hall");
    files.set(records({"a", "hall/b", "hall/c/d", "halls/e"}), {});
    CHECK(paths(files.shown()) == Paths{"hall/b", "hall/c/d"});

    files.open("hall/c");

    CHECK(files.has_open_folder());
    CHECK(paths(files.shown()) == Paths{"hall/c/d"});
    CHECK(paths(files.all()) == Paths{"hall/b", "hall/c/d"});
    CHECK(files.opened_folder() == "hall/c");
}

TEST_CASE("a folder is closed when its last file goes, and not opened where it has none") {
    StageFiles files("");
    files.set(records({"a/b", "c"}), {});
    files.open("a");
    files.set(records({"c"}), {});
    CHECK_FALSE(files.has_open_folder());
    CHECK(paths(files.shown()) == Paths{"c"});
    files.open("d");
    CHECK_FALSE(files.has_open_folder());
}

TEST_CASE("the records of the catalogue are shared by all lists") {
    const RecordList all = records({"a/b", "c"});
    StageFiles files("a");
    files.set(all, {});
    CHECK(files.shown().find("a/b") == all.find("a/b"));
}
