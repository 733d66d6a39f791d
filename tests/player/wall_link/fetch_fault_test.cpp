// A box tells why it could not fetch files.

#include "player/wall_link/fetch_fault.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

TEST_CASE("the reason is the first line of the file, and goes with it") {
    const TemporaryDirectory folder;
    const auto file = folder.path / "fault";
    FetchFault fault(file);
    fault.look(0s);
    CHECK(fault.text().empty());
    folder.write("fault", "rsync: connection refused\nand more\n");
    fault.look(1s);
    CHECK_MESSAGE(fault.text().empty(), "it was looked at a moment ago");
    fault.look(2s);
    CHECK(fault.text() == "rsync: connection refused");
    folder.write("fault", std::string(1000, 'a'));
    fault.look(4s);
    CHECK(fault.text() == std::string(300, 'a'));
    std::filesystem::remove(file);
    fault.look(6s);
    CHECK(fault.text().empty());
}
