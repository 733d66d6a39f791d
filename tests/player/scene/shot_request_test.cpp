#include "player/scene/shot_request.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

ShotRequest wanted(int width, int height) {
    ShotRequest request{.source = 3,
                        .path = "a/film.mkv",
                        .kind = MediaKind::film,
                        .shot = {.begin = 7s, .end = 9s, .region = {.polygon = {}, .drift = {5, 0}}},
                        .width = width,
                        .height = height};
    request.shot.stored = {.file = "0123456789abcdef/7-9.mp4", .width = 640, .height = 360};
    return request;
}

}  // namespace

TEST_CASE("a shot that is not in the store, or has lost its place there, has no stored request") {
    ShotRequest request = wanted(320, 180);
    request.shot.stored->is_dropped = true;
    CHECK_FALSE(stored_request(request));
    request.shot.stored.reset();
    CHECK_FALSE(stored_request(request));
}

TEST_CASE("a clip is the same shot in its own file and time") {
    const std::optional<ShotRequest> from = stored_request(wanted(320, 180));
    REQUIRE(from);
    CHECK(from->source == 3);
    CHECK(from->path == "0123456789abcdef/7-9.mp4");
    CHECK(from->shot.begin == 0s);
    CHECK(from->shot.end == 2s);
    CHECK(from->shot.region.drift == Vec2{5, 0});
    CHECK(from->width == 320);
    CHECK(from->height == 180);
}

TEST_CASE("a copy of a film keeps the film's time") {
    ShotRequest request = wanted(320, 180);
    request.shot.stored->begin = 7s;
    CHECK(stored_request(request)->shot.begin == 7s);
    CHECK(stored_request(request)->shot.end == 9s);
}

TEST_CASE("no more pixels are asked for than the store has") {
    const std::optional<ShotRequest> from = stored_request(wanted(1280, 720));
    CHECK(from->width == 640);
    CHECK(from->height == 360);
}
