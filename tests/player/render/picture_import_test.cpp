#include "player/render/picture_import.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

using namespace vitrine;
using namespace vitrine::player;

namespace {

std::optional<EGLAttrib> value_of(const std::vector<EGLAttrib>& list, EGLAttrib name) {
    for (std::size_t i = 0; i + 1 < list.size(); i += 2)
        if (list[i] == name) return list[i + 1];
    return std::nullopt;
}

SharedPlanes planes() {
    return {.planes = {SharedPlanes::Plane{.file = 5, .offset = 0, .stride = 1920},
                       SharedPlanes::Plane{.file = 6, .offset = 64, .stride = 2048}},
            .modifier = {}};
}

}  // namespace

TEST_CASE("EGL is told where a plane lies and how many channels it has") {
    const auto list = import_attributes(planes(), {1, 2, 960, 540}, true);

    CHECK(value_of(list, EGL_WIDTH) == 960);
    CHECK(value_of(list, EGL_HEIGHT) == 540);
    CHECK(value_of(list, EGL_LINUX_DRM_FOURCC_EXT) == 0x38385247);  // GR88
    CHECK(value_of(list, EGL_DMA_BUF_PLANE0_FD_EXT) == 6);
    CHECK(value_of(list, EGL_DMA_BUF_PLANE0_OFFSET_EXT) == 64);
    CHECK(value_of(list, EGL_DMA_BUF_PLANE0_PITCH_EXT) == 2048);
    CHECK_FALSE(value_of(list, EGL_DMA_BUF_PLANE0_MODIFIER_LO_EXT));
    CHECK(list.back() == EGL_NONE);
    CHECK(value_of(import_attributes(planes(), {0, 1, 1920, 1080}, true), EGL_LINUX_DRM_FOURCC_EXT) ==
          0x20203852);  // R8
}

TEST_CASE("a modifier is named in halves, and where it cannot be named only rows are read") {
    SharedPlanes tiled = planes();
    tiled.modifier = 0x0100000000000002;
    const auto list = import_attributes(tiled, {0, 1, 1920, 1080}, true);
    CHECK(value_of(list, EGL_DMA_BUF_PLANE0_MODIFIER_LO_EXT) == 2);
    CHECK(value_of(list, EGL_DMA_BUF_PLANE0_MODIFIER_HI_EXT) == 0x01000000);
    CHECK_THROWS_AS(import_attributes(tiled, {0, 1, 1920, 1080}, false), std::runtime_error);

    tiled.modifier = 0;
    CHECK_FALSE(
        value_of(import_attributes(tiled, {0, 1, 1920, 1080}, false), EGL_DMA_BUF_PLANE0_MODIFIER_LO_EXT));
}
