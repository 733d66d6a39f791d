#include "player/stage/wall_picture.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

Frame frame(std::vector<SourceId> sources) {
    Frame frame;
    for (const SourceId source : sources)
        frame.items.push_back({.source = source});
    return frame;
}

Picture grey(int value) {
    return {.width = 64,
            .height = 36,
            .pixels = std::vector<std::byte>(64 * 36 * 4, static_cast<std::byte>(value))};
}

}  // namespace

TEST_CASE("a picture is due every half minute, and soon after other shots are on the wall") {
    WallPicture wall("/nowhere");
    CHECK_FALSE(wall.is_due(frame({1, 2}), 0s));
    CHECK(wall.is_due(frame({1, 2}), 3s));
    CHECK_FALSE(wall.is_due(frame({1, 2}), 32s));
    CHECK(wall.is_due(frame({1, 2}), 33s));
    CHECK_FALSE(wall.is_due(frame({1, 3}), 50s));
    CHECK(wall.is_due(frame({1, 3}), 52s));
    CHECK_FALSE(wall.is_due(frame({1, 4}), 53s));
    CHECK_FALSE(wall.is_due(frame({1, 4}), 59s));
    CHECK(wall.is_due(frame({1, 4}), 60s));
}

TEST_CASE("it is a JPEG that is there as a whole, and where it cannot be written nothing stops") {
    const TemporaryDirectory state;
    const std::filesystem::path file = state.path / "wall.jpg";
    {
        WallPicture wall(file);
        wall.write(grey(90));
    }
    CHECK(read_file(file).starts_with("\xff\xd8\xff"));
    CHECK_FALSE(std::filesystem::exists(unfinished(file)));
    WallPicture elsewhere(state.path / "none/wall.jpg");  // no reason to stop
    elsewhere.write(grey(90));
}
