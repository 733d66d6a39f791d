#include "base/state/catalogue.hpp"
#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
namespace fs = std::filesystem;

TEST_CASE("what is stored is loaded, ordered by path, and gone once removed") {
    const TemporaryDirectory directory;
    const Catalogue catalogue(directory.path / "state" / "catalogue");
    CHECK(catalogue.load().empty());

    catalogue.store({.path = "b.jpg", .reason = "copy under way"});
    catalogue.store({.path = "a.jpg"});
    catalogue.store({.path = "b.jpg", .reason = "still copying"});

    const std::vector<MediaRecord> records = catalogue.load();
    REQUIRE(records.size() == 2);
    CHECK(records[0].path == "a.jpg");
    CHECK(records[1].reason == "still copying");
    CHECK(catalogue.find("b.jpg").has_value());

    catalogue.remove("b.jpg");
    catalogue.remove("never there");
    CHECK_FALSE(catalogue.find("b.jpg").has_value());
}

TEST_CASE("a record file that is garbage is named and hides no other") {
    const TemporaryDirectory directory;
    const Catalogue catalogue(directory.path);
    catalogue.store({.path = "good.jpg"});
    replace_file(directory.path / "0123456789abcdef.json", "{ not json");

    std::string complaint;
    const auto records =
        catalogue.load([&](const std::string& file, const std::string&) { complaint = file; });

    REQUIRE(records.size() == 1);
    CHECK(records[0].path == "good.jpg");
    CHECK(complaint.find("0123456789abcdef.json") != std::string::npos);
}
