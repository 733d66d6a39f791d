#include "base/media/still_picture.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

using namespace vitrine;

// Alone in this file, and so in its process: other tests draw with libvips before init_vips() has been
// called.
TEST_CASE("libvips is without its modules: ImageMagick, PDF and slides of microscopes") {
    init_vips();
    std::ifstream maps("/proc/self/maps");
    const std::string loaded{std::istreambuf_iterator<char>(maps), {}};
    CHECK(loaded.find("libvips") != std::string::npos);
    for (const char* library : {"vips-modules", "libMagick", "libpoppler", "libopenslide"})
        CHECK(loaded.find(library) == std::string::npos);
}
