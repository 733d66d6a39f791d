#include "player/scene/files/folder_level.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

using Paths = std::vector<std::string>;

RecordList files(const Paths& paths) {
    std::vector<MediaRecord> records;
    for (const std::string& path : paths)
        records.push_back({.path = path});
    return records;
}

/// The entries' paths; a folder ends with '/'.
Paths level_of(const Paths& paths) {
    Paths entries;
    for (const FolderEntry& entry : level_entries(files(paths)))
        entries.push_back(entry.path + (entry.is_folder ? "/" : ""));
    return entries;
}

}  // namespace

TEST_CASE("folders and loose files of a level stand side by side") {
    CHECK(level_of({"a.jpg", "b/1", "b/2", "c-d", "c/1", "c/2"}) == Paths{"a.jpg", "b/", "c-d", "c/"});
}

TEST_CASE("a folder of one file is the file, at any depth") {
    CHECK(level_of({"a", "b/c/d/e"}) == Paths{"a", "b/c/d/e"});
}

TEST_CASE("a folder that holds only a folder is that folder") {
    CHECK(level_of({"a", "b/c/d/1", "b/c/e/2"}) == Paths{"a", "b/c/"});
    CHECK(level_of({"a", "b/c/1", "b/c/2"}) == Paths{"a", "b/c/"});
}

TEST_CASE("a level begins where the files part") {
    CHECK(level_of({"root/archive/a/1", "root/archive/a/2", "root/archive/b/1", "root/archive/b/2"}) ==
          Paths{"root/archive/a/", "root/archive/b/"});
    CHECK(common_folder(files({"root/archive/a/1", "root/archive/b"})) == "root/archive");
    CHECK(common_folder(files({"root/a"})) == "root");
    CHECK(common_folder(files({"a1", "a2"})).empty());
}

TEST_CASE("a level without files has no entry") {
    CHECK(level_of({}).empty());
}
