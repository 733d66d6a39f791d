#include "player/scene/wall_sources.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// A photo of 640 x 360 px at this scale.
PlacedShot placed_photo(SourceId source, double scale = 1) {
    return {.shot = {.source = source, .key = {"p" + std::to_string(source), 0}, .picture = {640, 360}},
            .placement = {.scale = scale, .offset = {}}};
}

}  // namespace

TEST_CASE("a source is asked for in the size that is shown, with no more pixels than there are") {
    WallSources sources;
    const std::vector<ShotRequest> requests =
        sources.request(std::vector{placed_photo(1, 0.5), placed_photo(2, 3), placed_photo(3, 0.0001)});
    REQUIRE(requests.size() == 3);
    CHECK(requests[0].path == "p1");
    CHECK(requests[0].width == 320);
    CHECK(requests[0].height == 180);
    CHECK(requests[1].width == 640);
    CHECK(requests[1].height == 360);
    CHECK(requests[2].width == 1);
    CHECK(requests[2].height == 1);
}

TEST_CASE("a source is pending until it is ready or has failed") {
    const std::vector<PlacedShot> wall{placed_photo(1), placed_photo(2), placed_photo(3)};
    WallSources sources;
    sources.request(wall);
    CHECK(sources.pending(wall) == std::vector<SourceId>{1, 2, 3});
    CHECK_FALSE(sources.is_ready(wall[0]));
    CHECK_FALSE(sources.has_failed(wall[0]));

    sources.set_ready(1);
    sources.set_failed(3);
    CHECK(sources.pending(wall) == std::vector<SourceId>{2});
    CHECK(sources.is_ready(wall[0]));
    CHECK_FALSE(sources.is_ready(wall[2]));
    CHECK(sources.has_failed(wall[2]));
}

TEST_CASE("another size of a source does not make it pending again") {
    WallSources sources;
    sources.request(std::vector{placed_photo(1, 0.5)});
    sources.set_ready(1);
    const std::vector<PlacedShot> larger{placed_photo(1, 1)};
    CHECK(sources.request(larger).front().width == 640);
    CHECK(sources.is_ready(larger[0]));
    CHECK(sources.pending(larger).empty());
}

TEST_CASE("a source that the wall has lost is retired once") {
    WallSources sources;
    sources.request(std::vector{placed_photo(1), placed_photo(2), placed_photo(3)});
    CHECK(sources.retire_all_but({2, 9}) == std::vector<SourceId>{1, 3});
    CHECK(sources.retire_all_but({2}).empty());
    CHECK(sources.retire_all_but({}) == std::vector<SourceId>{2});
}

TEST_CASE("late news of a retired source say nothing about the next one of that number") {
    const std::vector<PlacedShot> wall{placed_photo(1)};
    WallSources sources;
    sources.request(wall);
    sources.retire_all_but({});
    sources.set_ready(1);
    sources.set_failed(7);  // never asked for
    CHECK(sources.retire_all_but({}).empty());
    sources.request(wall);
    CHECK(sources.pending(wall) == std::vector<SourceId>{1});
}
