#include "base/system/memory.hpp"

using namespace vitrine;
using namespace std::chrono_literals;

TEST_CASE("freed memory is returned once in five minutes") {
    int count = 0;
    FreedMemory memory([&count] { ++count; });
    memory.look(0s);
    memory.look(299s);
    CHECK(count == 0);
    memory.look(300s);
    memory.look(599s);
    CHECK(count == 1);
    memory.look(3600s);
    memory.look(3601s);
    CHECK(count == 2);
}
