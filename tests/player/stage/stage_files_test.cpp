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

TEST_CASE("a stage shows the files of its screens' folder") {
    StageFiles files("hall");
    files.set(records({"a", "hall/b", "hall/c/d", "halls/e"}), {});
    CHECK(paths(files.all()) == Paths{"hall/b", "hall/c/d"});
}

TEST_CASE("the records of the catalogue are shared by all lists") {
    const RecordList all = records({"a/b", "c"});
    StageFiles files("a");
    files.set(all, {});
    CHECK(files.all().find("a/b") == all.find("a/b"));
}
