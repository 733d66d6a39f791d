#include "player/control/cec_standby.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// A search path of one test.
struct SearchPath {
    explicit SearchPath(const std::string& path) { ::setenv("PATH", path.c_str(), 1); }

    SearchPath(const SearchPath&) = delete;
    SearchPath& operator=(const SearchPath&) = delete;

    ~SearchPath() { ::setenv("PATH", before.c_str(), 1); }

    std::string before = std::getenv("PATH");
};

}  // namespace

TEST_CASE("a television set is asked over CEC, where the tool is installed") {
    const TemporaryDirectory house;
    const auto tool =
        house.write("cec-ctl", "#!/bin/sh\necho \"$@\" > " + (house.path / "said").string() + "\n");
    std::filesystem::permissions(tool, std::filesystem::perms::owner_all);
    const SearchPath path(house.path.string() + ":/bin:/usr/bin");
    CecStandby cec;
    cec.ask(false);
    std::string said;
    for (int i = 0; i < 500 && said.empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (std::filesystem::exists(house.path / "said")) said = read_file(house.path / "said");
    }
    CHECK(said == "--playback --to=0 --standby\n");
}

TEST_CASE("without the tool nothing happens") {
    const SearchPath path("/nonexistent");
    CecStandby cec;
    cec.ask(true);
    cec.look();
}
