#include "analyzer/lettering/folder_words.hpp"

#include "base/state/word_picture.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

TEST_CASE("the names of all folders on the way are set, each once, and no others stay") {
    const TemporaryDirectory home;
    const std::array<std::string, 5> paths{"a.jpg", "08-18 Trips/b.jpg", "Trips/Rome/c.jpg",
                                           "Trips/Rome/d.jpg", "Trips/Oslo_2026/x/e.jpg"};

    CHECK(lacking_words(shown_folder_names(paths), home.path) ==
          std::vector<std::string>{"Oslo 2026", "Rome", "Trips", "x"});

    for (const char* name : {"Rome", "Trips", "gone"})
        home.write(fs::path(word_picture(home.path, name)).lexically_relative(home.path).string(), "picture");

    CHECK(lacking_words(shown_folder_names(paths), home.path) == std::vector<std::string>{"Oslo 2026", "x"});

    remove_other_words(shown_folder_names(paths), home.path);

    CHECK(fs::exists(word_picture(home.path, "Rome")));
    CHECK_FALSE(fs::exists(word_picture(home.path, "gone")));
    CHECK(shown_folder_names(std::array<std::string, 1>{"a.jpg"}).empty());
}
