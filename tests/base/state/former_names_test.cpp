#include "base/state/former_names.hpp"

#include "base/state/catalogue.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine;

namespace {

constexpr const char* former = "0123456789abcdef";

/// The record that version 0.1 wrote, with its tapestry and its thumbnail.
void leave_film(const TemporaryDirectory& state, const std::string& path) {
    Catalogue(state.path / "catalogue").store({.path = path, .state = MediaState::ready});
    std::filesystem::rename(state.path / "catalogue" / (record_id(path) + ".json"),
                            state.path / "catalogue" / (std::string(former) + ".json"));
    state.write(std::string("tapestry/") + former + "/index.json", "tiles");
    state.write(std::string("thumbnails/") + former + "/thumbnail.jpg", "picture");
}

}  // namespace

TEST_CASE("records, tapestries and thumbnails of version 0.1 are found by their names of today") {
    const TemporaryDirectory state;
    leave_film(state, "a.mp4");
    const std::string id = record_id("a.mp4");

    rename_former(state.path);

    CHECK(Catalogue(state.path / "catalogue").find("a.mp4").has_value());
    CHECK(std::filesystem::exists(state.path / "tapestry" / id / "index.json"));
    CHECK(std::filesystem::exists(state.path / "thumbnails" / id / "thumbnail.jpg"));
    CHECK(Catalogue(state.path / "catalogue").load().size() == 1);
}

TEST_CASE("a record that has its name of today wins over one of version 0.1") {
    const TemporaryDirectory state;
    leave_film(state, "a.mp4");
    Catalogue(state.path / "catalogue").store({.path = "a.mp4", .state = MediaState::failed});

    rename_former(state.path);

    const auto records = Catalogue(state.path / "catalogue").load();
    REQUIRE(records.size() == 1);
    CHECK(records[0].state == MediaState::failed);
}

TEST_CASE("a record of version 0.1 that cannot be read stays where it is") {
    const TemporaryDirectory state;
    std::string damaged_name = "catalogue/";  // one line of sums alarms g++ 12 without reason
    damaged_name.append(former).append(".json");
    const auto damaged = state.write(damaged_name, "{ not json");
    rename_former(state.path);
    CHECK(std::filesystem::exists(damaged));
}
