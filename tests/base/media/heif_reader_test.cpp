#include "base/media/still_picture.hpp"
#include "base/state/media_error.hpp"
#include "base/system/handle.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <libheif/heif.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace vitrine;

namespace {

struct TempFile {
    std::string path =
        std::filesystem::temp_directory_path() / fmt::format("vitrine-heif-{}.avif", ::getpid());

    TempFile() = default;
    TempFile(const TempFile&) = delete;
    TempFile& operator=(const TempFile&) = delete;

    ~TempFile() { std::filesystem::remove(path); }
};

using Pixel = std::array<int, 3>;

constexpr Pixel red{220, 30, 30};
constexpr Pixel green{30, 180, 40};
constexpr Pixel blue{30, 40, 220};
constexpr Pixel yellow{230, 220, 40};
constexpr int width = 96;  // px, as stored
constexpr int height = 64;

using Image = Handle<heif_image, &heif_image_release>;

// Four coloured quarters: upper left red, upper right green, lower left blue, lower right yellow.
Image quarters(int alpha) {
    heif_image* out = nullptr;
    const int bands = alpha < 0 ? 3 : 4;
    const auto chroma = alpha < 0 ? heif_chroma_interleaved_RGB : heif_chroma_interleaved_RGBA;
    REQUIRE(heif_image_create(width, height, heif_colorspace_RGB, chroma, &out).code == 0);
    Image image(out);
    REQUIRE(heif_image_add_plane(out, heif_channel_interleaved, width, height, 8 * bands).code == 0);
    int stride = 0;
    std::uint8_t* plane = heif_image_get_plane(out, heif_channel_interleaved, &stride);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Pixel& colour =
                y < height / 2 ? (x < width / 2 ? red : green) : (x < width / 2 ? blue : yellow);
            for (int i = 0; i < bands; ++i)
                plane[y * stride + x * bands + i] =
                    static_cast<std::uint8_t>(i < 3 ? colour[static_cast<std::size_t>(i)] : alpha);
        }
    return image;
}

void write(const std::string& path, heif_orientation orientation, int alpha = -1) {
    const Handle<heif_context, &heif_context_free> context(heif_context_alloc());
    heif_encoder* found = nullptr;
    REQUIRE(heif_context_get_encoder_for_format(context.get(), heif_compression_AV1, &found).code == 0);
    const Handle<heif_encoder, &heif_encoder_release> encoder(found);
    const Handle<heif_encoding_options, &heif_encoding_options_free> options(heif_encoding_options_alloc());
    options->image_orientation = orientation;
    REQUIRE(
        heif_context_encode_image(context.get(), quarters(alpha).get(), found, options.get(), nullptr).code ==
        0);
    REQUIRE(heif_context_write_to_file(context.get(), path.c_str()).code == 0);
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

// Says the turn before the size, as some writers do: of an item's properties the last comes first.
void say_turn_first(const std::string& path) {
    std::string bytes = bytes_of(path);
    const std::size_t count = bytes.find("ipma") + 14;
    const auto properties = bytes.begin() + static_cast<std::ptrdiff_t>(count) + 1;
    std::rotate(properties, properties + bytes[count] - 1, properties + bytes[count]);
    write_bytes(path, bytes);
}

bool is_near(const StillPicture& picture, double x, double y, const Pixel& colour) {
    const auto column = static_cast<std::size_t>(x * picture.width);
    const auto row = static_cast<std::size_t>(y * picture.height);
    const std::size_t at = 4 * (row * static_cast<std::size_t>(picture.width) + column);
    constexpr int tolerance = 30;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(std::to_integer<int>(picture.pixels[at + i]) - colour[i]) > tolerance) return false;
    return picture.pixels[at + 3] == std::byte{255};
}

bool has_quarters(const StillPicture& picture, const std::array<Pixel, 4>& colours) {
    return is_near(picture, 0.25, 0.25, colours[0]) && is_near(picture, 0.75, 0.25, colours[1]) &&
           is_near(picture, 0.25, 0.75, colours[2]) && is_near(picture, 0.75, 0.75, colours[3]);
}

MediaState state_of(const std::string& path) {
    try {
        load_still(path, 100, 100);
    } catch (const MediaError& error) {
        return error.state();
    }
    return MediaState::ready;
}

}  // namespace

TEST_CASE("a HEIF photo of any orientation stands upright, whether it says its turn or its size first") {
    // what the stored quarters become by each turn that EXIF knows, upper left to lower right
    constexpr std::array<std::array<Pixel, 4>, 8> upright{{{red, green, blue, yellow},
                                                           {green, red, yellow, blue},
                                                           {yellow, blue, green, red},
                                                           {blue, yellow, red, green},
                                                           {red, blue, green, yellow},
                                                           {blue, red, yellow, green},
                                                           {yellow, green, blue, red},
                                                           {green, yellow, red, blue}}};
    const TempFile file;
    for (int orientation = 1; orientation <= 8; ++orientation) {
        for (const bool turn_first : {false, true}) {
            CAPTURE(orientation);
            CAPTURE(turn_first);
            write(file.path, static_cast<heif_orientation>(orientation));
            if (turn_first) say_turn_first(file.path);
            const StillPicture picture = load_still(file.path, 48, 48);
            CHECK(picture.full.width == (orientation < 5 ? width : height));
            CHECK(picture.full.height == (orientation < 5 ? height : width));
            CHECK(picture.width == (orientation < 5 ? 48 : 32));
            CHECK(has_quarters(picture, upright[static_cast<std::size_t>(orientation - 1)]));
        }
    }
}

TEST_CASE("the background shows through a HEIF photo that is transparent") {
    const TempFile file;
    write(file.path, heif_orientation_normal, 0);
    const Pixel behind{10, 200, 90};
    CHECK(has_quarters(load_still(file.path, 48, 48, {.red = 10, .green = 200, .blue = 90}),
                       {behind, behind, behind, behind}));
}

TEST_CASE("a HEIF photo cut short is waited for, a broken one is not") {
    const TempFile file;
    write(file.path, heif_orientation_normal);
    const std::string whole = bytes_of(file.path);
    for (const double share : {0.5, 0.9}) {
        write_bytes(file.path, whole.substr(0, static_cast<std::size_t>(share * double(whole.size()))));
        CHECK(state_of(file.path) == MediaState::waiting);
    }
    std::string broken = whole;
    broken.replace(broken.find("pitm") + 8, 2, "\x7f\x7f");  // a main picture that is not there
    write_bytes(file.path, broken);
    CHECK(state_of(file.path) != MediaState::waiting);
    broken = whole;
    broken.replace(broken.find("mdat") + 4, 8, 8, '\xff');
    write_bytes(file.path, broken);
    CHECK(state_of(file.path) == MediaState::failed);
}

TEST_CASE("a HEIF photo that claims to be huge is refused by its header") {
    const TempFile file;
    write(file.path, heif_orientation_normal);
    std::string bytes = bytes_of(file.path);
    bytes.replace(bytes.find("ispe") + 8, 8, std::string("\0\0\x75\x30\0\0\x75\x30", 8));
    write_bytes(file.path, bytes);
    CHECK(state_of(file.path) == MediaState::unsupported);
}
