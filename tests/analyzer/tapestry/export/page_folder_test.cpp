#include "analyzer/tapestry/export/page_folder.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace vitrine::analyzer {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

void publish_page(const fs::path& folder) {
    PageFolder page(folder);
    (void)page.begin();
    page.publish();
}

}  // namespace

TEST_CASE("a page is index.html and a folder that it names, with all files that it asks for") {
    const TemporaryDirectory home;
    const fs::path folder = home.path / "out";
    publish_page(folder);
    CHECK(names_in(folder) == std::vector<std::string>{"index.html", "tapestry-1"});
    CHECK(names_in(folder / "tapestry-1") ==
          std::vector<std::string>{"drawing.js", "film.js", "page.css", "page.js", "places.js", "tiles.js"});
    const std::string page = read_file(folder / "index.html");
    CHECK(page.find("@FOLDER@") == std::string::npos);
    for (const std::string& name : names_in(folder / "tapestry-1"))
        CHECK(page.find("\"tapestry-1/" + name + "\"") != std::string::npos);
    CHECK(page.find("\"tapestry-1/tapestry.js\"") != std::string::npos);
}

TEST_CASE("a page asks for nothing from elsewhere") {
    for (const PageFile& file : page_files()) {
        CAPTURE(file.name);
        for (const char* word : {"http:", "https:", "fetch(", "XMLHttpRequest", "import(", "type=\"module\""})
            CHECK(file.content.find(word) == std::string_view::npos);
    }
}

TEST_CASE("a page takes the place of an earlier one once it is complete, and what else is there stays") {
    const TemporaryDirectory home;
    publish_page(home.path);
    home.write("notes.txt", "mine");
    {
        PageFolder next(home.path);
        home.write("tapestry-2/part", "half");
        CHECK(next.begin() == home.path / "tapestry-3");
        CHECK(read_file(home.path / "index.html").find("tapestry-1/page.js") != std::string::npos);
        next.publish();
    }
    CHECK(names_in(home.path) == std::vector<std::string>{"index.html", "notes.txt", "tapestry-3"});
    CHECK(read_file(home.path / "index.html").find("tapestry-3/page.js") != std::string::npos);
}

TEST_CASE("a page that is not published leaves the earlier one as it was") {
    const TemporaryDirectory home;
    publish_page(home.path);
    {
        PageFolder next(home.path);
        (void)next.begin();
    }
    CHECK(names_in(home.path) == std::vector<std::string>{"index.html", "tapestry-1"});
    CHECK(fs::exists(home.path / "tapestry-1/page.js"));
}

TEST_CASE("a folder with other files is refused by its name, and nothing in it changes") {
    const TemporaryDirectory home;
    home.write("tax.pdf", "mine");
    CHECK_THROWS_WITH(PageFolder(home.path), doctest::Contains("tax.pdf"));
    CHECK_THROWS_WITH(PageFolder(home.path), doctest::Contains(home.path.c_str()));
    CHECK_THROWS_WITH(PageFolder(home.path / "tax.pdf"), doctest::Contains("it is no folder"));
    CHECK(names_in(home.path) == std::vector<std::string>{"tax.pdf"});

    const TemporaryDirectory site;
    site.write("index.html", "<!DOCTYPE html><title>Our museum</title>");
    CHECK_THROWS_WITH(PageFolder(site.path), doctest::Contains("index.html"));
}

TEST_CASE("the rest of a page that was interrupted is no hindrance") {
    const TemporaryDirectory home;
    home.write("tapestry-1/film.mp4", "half");
    home.write("index.html.new", "half");
    publish_page(home.path);
    CHECK(names_in(home.path) == std::vector<std::string>{"index.html", "tapestry-2"});
}

}  // namespace vitrine::analyzer
