#include "analyzer/store/disk_use.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

std::vector<std::string> names(const std::vector<StoredFile>& files) {
    std::vector<std::string> all;
    for (const StoredFile& file : files)
        all.push_back(file.name);
    return all;
}

const std::vector<StoredFile> four{{.name = "new", .bytes = 10, .used_ns = 9, .is_named = true},
                                   {.name = "old", .bytes = 10, .used_ns = 1, .is_named = true},
                                   {.name = "gone", .bytes = 10, .used_ns = 5},
                                   {.name = "long gone", .bytes = 10, .used_ns = 2}};

}  // namespace

TEST_CASE("what no record names goes first, then what was not used for longest, and no more than it takes") {
    CHECK(names(files_to_remove(four, 0)).empty());
    CHECK(names(files_to_remove(four, 1)) == std::vector<std::string>{"long gone"});
    CHECK(names(files_to_remove(four, 20)) == std::vector<std::string>{"long gone", "gone"});
    CHECK(names(files_to_remove(four, 21)) == std::vector<std::string>{"long gone", "gone", "old"});
}

TEST_CASE("where nothing is enough all of it goes") {
    CHECK(files_to_remove(four, 1000).size() == 4);
    CHECK(files_to_remove({}, 1000).empty());
}
