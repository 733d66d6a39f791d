#include "analyzer/store/clip_form.hpp"

#include <doctest/doctest.h>

#include <utility>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

std::pair<int, int> form(int width, int height, int side) {
    const auto found = clip_form({.kind = MediaKind::film, .width = width, .height = height}, side);
    return found ? std::pair(found->width, found->height) : std::pair(0, 0);
}

}  // namespace

TEST_CASE("a clip is no longer than asked for, no larger than its film, and has even sides") {
    CHECK(form(1280, 720, 640) == std::pair(640, 360));
    CHECK(form(720, 1280, 640) == std::pair(360, 640));
    CHECK(form(320, 180, 640) == std::pair(320, 180));
    CHECK(form(1999, 1125, 640) == std::pair(640, 360));
    CHECK(form(321, 181, 640) == std::pair(322, 182));
}

TEST_CASE("a film too small for the encoder has no clips") {
    CHECK_FALSE(clip_form({.kind = MediaKind::film, .width = 12, .height = 40}, 640));
    CHECK_FALSE(clip_form({.kind = MediaKind::film}, 640));
}

TEST_CASE("the more slots share the screen, the smaller the clips") {
    CHECK(clip_side_for(1) == 1920);
    CHECK(clip_side_for(4) == 1152);
    CHECK(clip_side_for(12) == 672);
    CHECK(clip_side_for(64) == 320);
    CHECK(clip_side_for(0) == 1920);
}

TEST_CASE("clips are as large as the screens that there are need them") {
    CHECK(clip_side_for(4, 1280) == 768);
    CHECK(clip_side_for(9, 1280) == 512);
    CHECK(clip_side_for(4, 3840) == 2304);
    CHECK(clip_side_for(1, 3840) == 3840);
    CHECK(clip_side_for(1, 160) == 320);
}
