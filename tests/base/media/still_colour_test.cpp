// Photos that say what their colours mean: known sRGB in, written in another space, the same sRGB out.

#include "base/media/still_picture.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <vips/vips.h>

#include <array>
#include <cstdlib>

using namespace vitrine;

namespace {

using Rgb = std::array<int, 3>;

constexpr std::array<Rgb, 4> patches{{{200, 60, 40}, {60, 160, 80}, {60, 80, 170}, {220, 210, 190}}};

VipsImage* plain(const Rgb& colour) {
    VipsImage* black = nullptr;
    REQUIRE(vips_black(&black, 64, 48, "bands", 3, nullptr) == 0);
    const std::array<double, 3> scale{1, 1, 1};
    const std::array<double, 3> offset{double(colour[0]), double(colour[1]), double(colour[2])};
    VipsImage* lifted = nullptr;
    REQUIRE(vips_linear(black, &lifted, scale.data(), offset.data(), 3, "uchar", TRUE, nullptr) == 0);
    g_object_unref(black);
    VipsImage* result = nullptr;
    REQUIRE(vips_copy(lifted, &result, "interpretation", VIPS_INTERPRETATION_sRGB, nullptr) == 0);
    g_object_unref(lifted);
    return result;
}

/// Writes a photo of one colour in the space of a profile, which goes into the file.
void write(const std::string& path, const Rgb& colour, const char* profile) {
    REQUIRE(vips_init("test") == 0);
    VipsImage* image = plain(colour);
    VipsImage* other = nullptr;
    REQUIRE(vips_icc_transform(image, &other, profile, "input_profile", "srgb", "depth", 8, nullptr) == 0);
    g_object_unref(image);
    REQUIRE(vips_image_write_to_file(other, path.c_str(), nullptr) == 0);
    g_object_unref(other);
}

Rgb shown(const std::string& path) {
    const StillPicture picture = load_still(path, 32, 32);
    const std::size_t at =
        4 * (static_cast<std::size_t>(picture.height / 2) * static_cast<std::size_t>(picture.width) +
             static_cast<std::size_t>(picture.width / 2));
    return {std::to_integer<int>(picture.pixels[at]), std::to_integer<int>(picture.pixels[at + 1]),
            std::to_integer<int>(picture.pixels[at + 2])};
}

int distance(const Rgb& a, const Rgb& b) {
    int largest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

}  // namespace

TEST_CASE("a photograph in Display P3 has the colours that it was taken with") {
    const TemporaryDirectory folder;
    for (const char* name : {"wide.png", "wide.jpg[Q=100]", "wide.tif", "wide.webp[lossless]"}) {
        const std::string path = (folder.path / name).string();
        for (const Rgb& patch : patches) {
            CAPTURE(path);
            write(path, patch, "p3");
            CHECK(distance(shown(path.substr(0, path.find('['))), patch) <= 3);
        }
    }
}

TEST_CASE("a CMYK photograph has about the colours of its profile") {
    const TemporaryDirectory folder;
    const std::string path = (folder.path / "print.jpg").string();
    for (const Rgb& patch : {Rgb{180, 80, 70}, Rgb{90, 130, 100}, Rgb{220, 210, 190}}) {
        write(path + "[Q=100]", patch, "cmyk");
        CHECK(distance(shown(path), patch) <= 12);
    }
}
