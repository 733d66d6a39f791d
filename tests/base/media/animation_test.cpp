#include "base/media/animation_source.hpp"

#include "base/media/decode_chain.hpp"
#include "base/media/still_picture.hpp"
#include "base/media/vips_steps.hpp"
#include "base/state/media_error.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

constexpr int side = 32;  // px
constexpr std::array<std::array<double, 3>, 3> animation_colours{{{200, 0, 0}, {0, 200, 0}, {0, 0, 200}}};

VipsPtr<VipsImage> plain_picture(std::size_t colour, int width = side, int height = side) {
    const VipsPtr<VipsImage> black =
        step([&](auto** out) { return vips_black(out, width, height, "bands", 3, nullptr); });
    const std::array<double, 3> ones{1, 1, 1};
    const VipsPtr<VipsImage> lit = step([&](auto** out) {
        return vips_linear(black.get(), out, ones.data(), animation_colours[colour].data(), 3, nullptr);
    });
    const VipsPtr<VipsImage> bytes =
        step([&](auto** out) { return vips_cast_uchar(lit.get(), out, nullptr); });
    return step([&](auto** out) {
        return vips_copy(bytes.get(), out, "interpretation", VIPS_INTERPRETATION_sRGB, nullptr);
    });
}

/// Pictures one below the other, as libvips writes animations.
void save_animation(const std::string& file, int pictures) {
    init_vips();
    VipsPtr<VipsImage> all = plain_picture(0);
    for (std::size_t i = 1; i < static_cast<std::size_t>(pictures); ++i) {
        const VipsPtr<VipsImage> next = plain_picture(i);
        all = step([&](auto** out) {
            return vips_join(all.get(), next.get(), out, VIPS_DIRECTION_VERTICAL, nullptr);
        });
    }
    all = step([&](auto** out) { return vips_copy(all.get(), out, nullptr); });
    const std::array<int, 3> delays{50, 120, 300};  // ms
    vips_image_set_int(all.get(), VIPS_META_PAGE_HEIGHT, side);
    vips_image_set_array_int(all.get(), "delay", delays.data(), pictures);
    REQUIRE(vips_image_write_to_file(all.get(), file.c_str(), nullptr) == 0);
}

std::string big_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i)
        text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
}

/// The checksum of chunks that libvips does not see does not matter.
std::string chunk(const std::string& name, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size()), 4) + name + data + std::string(4, '\0');
}

std::string png_of(const VipsPtr<VipsImage>& picture) {
    void* bytes = nullptr;
    std::size_t size = 0;
    REQUIRE(vips_pngsave_buffer(picture.get(), &bytes, &size, "strip", TRUE, nullptr) == 0);
    std::string png(static_cast<const char*>(bytes), size);
    g_free(bytes);
    return png;
}

/// The data of a PNG's picture.
std::string data_of(const std::string& png) {
    std::string data;
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const auto byte = [&](std::size_t i) {
            return static_cast<std::uint32_t>(static_cast<unsigned char>(png[at + i]));
        };
        const std::size_t size = byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
        if (png.substr(at + 4, 4) == "IDAT") data += png.substr(at + 8, size);
        at += 12 + size;
    }
    return data;
}

struct Control {
    std::uint32_t sequence = 0, width = side, height = side, left = 0, top = 0, milliseconds = 0;
    std::uint8_t dispose = 0, blend = 0;

    std::string text() const {
        return big_endian(sequence, 4) + big_endian(width, 4) + big_endian(height, 4) + big_endian(left, 4) +
               big_endian(top, 4) + big_endian(milliseconds, 2) + big_endian(1000, 2) +
               static_cast<char>(dispose) + static_cast<char>(blend);
    }
};

/// A red picture; a green quarter of it, which is then restored; a blue quarter elsewhere.
std::string apng(std::uint32_t said = 3) {
    init_vips();
    const std::string first = png_of(plain_picture(0));
    const std::string green = data_of(png_of(plain_picture(1, side / 2, side / 2)));
    const std::string blue = data_of(png_of(plain_picture(2, side / 2, side / 2)));
    const Control second{
        .sequence = 1, .width = side / 2, .height = side / 2, .milliseconds = 120, .dispose = 2};
    const Control third{.sequence = 3,
                        .width = side / 2,
                        .height = side / 2,
                        .left = side / 2,
                        .top = side / 2,
                        .milliseconds = 300};
    return first.substr(0, 33) + chunk("acTL", big_endian(said, 4) + big_endian(0, 4)) +
           chunk("fcTL", Control{.milliseconds = 50}.text()) + chunk("IDAT", data_of(first)) +
           chunk("fcTL", second.text()) + chunk("fdAT", big_endian(2, 4) + green) +
           chunk("fcTL", third.text()) + chunk("fdAT", big_endian(4, 4) + blue) + chunk("IEND", "");
}

/// 0: red, 1: green, 2: blue.
int colour_at(const std::vector<std::byte>& picture, int x, int y) {
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x));
    int brightest = 0;
    for (int i = 1; i < 3; ++i)
        if (picture[at + static_cast<std::size_t>(i)] > picture[at + static_cast<std::size_t>(brightest)])
            brightest = i;
    return brightest;
}

void write_bytes(const std::string& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

std::string animation_refusal(const std::string& file) {
    try {
        open_animation(file, media_format(file));
    } catch (const MediaError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("a GIF, WebP or PNG with several pictures is an animation, with one it is a photo") {
    const TemporaryDirectory folder;
    const std::string at = folder.path.string() + "/";
    for (const char* name : {"a.gif", "a.webp"}) {
        save_animation(at + name, 3);
        CHECK(is_animation(media_format(at + name)));
        CHECK(kind_of(media_format(at + name)) == MediaKind::film);
        CHECK(load_still(at + name, 100, 100).full.height == side);
        save_animation(at + name, 1);
        CHECK(kind_of(media_format(at + name)) == MediaKind::photo);
    }
    write_bytes(at + "a.png", apng());
    CHECK(media_format(at + "a.png") == MediaFormat::animated_png);
    CHECK(still_format(MediaFormat::animated_png) == MediaFormat::png);
    write_bytes(at + "a.png", apng(1));
    CHECK(media_format(at + "a.png") == MediaFormat::png);
}

TEST_CASE("the pictures of a GIF and of a WebP come in their order, for as long as the file says") {
    const TemporaryDirectory folder;
    for (const char* name : {"/a.gif", "/a.webp"}) {
        const std::string file = folder.path.string() + name;
        save_animation(file, 3);
        const auto animation = open_animation(file, media_format(file));
        CHECK(animation->info().width == side);
        CHECK(animation->info().height == side);
        CHECK(animation->info().durations == std::vector<std::chrono::nanoseconds>{50ms, 120ms, 300ms});
        for (int colour = 0; colour < 3; ++colour)
            CHECK(colour_at(animation->next(), 5, 5) == colour);
    }
}

TEST_CASE("the pictures of an APNG are laid over one another, and taken away, as it says") {
    const TemporaryDirectory folder;
    const std::string file = folder.path.string() + "/a.png";
    write_bytes(file, apng());
    const auto animation = open_animation(file, media_format(file));
    CHECK(animation->info().durations == std::vector<std::chrono::nanoseconds>{50ms, 120ms, 300ms});
    CHECK(colour_at(animation->next(), 5, 5) == 0);
    const auto second = animation->next();
    CHECK(colour_at(second, 5, 5) == 1);
    CHECK(colour_at(second, 25, 25) == 0);
    const auto third = animation->next();
    CHECK(colour_at(third, 5, 5) == 0);
    CHECK(colour_at(third, 25, 25) == 2);
}

TEST_CASE("an animation plays like a film, and can be sought") {
    const TemporaryDirectory folder;
    const std::string file = folder.path.string() + "/a.png";
    write_bytes(file, apng());
    start_gstreamer();
    DecodeChain chain(file, make_bin("videoconvert ! appsink name=sink sync=false"));
    chain.preroll();
    gst_element_set_state(chain.pipeline(), GST_STATE_PLAYING);
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(chain.tail()), "sink"));
    const auto times = [&] {
        std::vector<std::uint64_t> times;
        while (const GstPtr<GstSample> sample = chain.pull(GST_APP_SINK(sink.get())))
            times.push_back(GST_BUFFER_PTS(gst_sample_get_buffer(sample.get())) / 1'000'000);
        return times;
    };
    CHECK(chain.duration() == 470ms);
    CHECK(times() == std::vector<std::uint64_t>{0, 50, 170});
    const auto flags = static_cast<GstSeekFlags>(GST_SEEK_FLAG_FLUSH | GST_SEEK_FLAG_ACCURATE);
    REQUIRE(gst_element_seek_simple(chain.pipeline(), GST_FORMAT_TIME, flags, 170'000'000));
    CHECK(times() == std::vector<std::uint64_t>{170});
}

TEST_CASE("an animation with too many or too large pictures is refused in one sentence") {
    const TemporaryDirectory folder;
    const std::string file = folder.path.string() + "/a.png";
    write_bytes(file, apng(20'000));
    CHECK(animation_refusal(file) ==
          "the animation is too long: 20000 pictures; up to 10000 of this height are played; "
          "H.264 in MP4 may be of any length");
    std::string large = apng();
    large.replace(16, 8, big_endian(9000, 4) + big_endian(9000, 4));
    write_bytes(file, large);
    CHECK(animation_refusal(file) ==
          "the animation is too large: 9000 x 9000 px; up to 16 megapixels are played");
    write_bytes(file, apng().substr(0, 150));
    CHECK(animation_refusal(file).starts_with("the copy is not complete"));
}

TEST_CASE("a duration of nothing is that of web browsers") {
    CHECK(picture_duration(0ms) == 100ms);
    CHECK(picture_duration(10ms) == 100ms);
    CHECK(picture_duration(20ms) == 20ms);
}
