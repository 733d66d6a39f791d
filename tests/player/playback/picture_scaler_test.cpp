#include "player/playback/picture_scaler.hpp"

#include "base/media/gst_ptr.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Pixel = std::array<int, 3>;

/// One frame of a plain colour, grey where it is HDR.
GstPtr<GstSample> frame(const std::string& format, int width, int height, Pixel colour,
                        const std::string& colorimetry = "bt601") {
    start_gstreamer();
    const std::string words = fmt::format(
        "videotestsrc num-buffers=1 pattern=solid-color foreground-color=0xff{:02x}{:02x}{:02x} ! "
        "video/x-raw,format={},width={},height={},colorimetry={} ! appsink name=sink",
        colour[0], colour[1], colour[2], format, width, height, colorimetry);
    const GstPtr<GstElement> pipeline(gst_parse_launch(words.c_str(), nullptr));
    REQUIRE(pipeline);
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(pipeline.get()), "sink"));
    GstPtr<GstSample> sample(gst_app_sink_pull_sample(GST_APP_SINK(sink.get())));
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    REQUIRE(sample);
    return sample;
}

Pixel pixel(const Sample& sample, int x, int y) {
    const std::size_t place = static_cast<std::size_t>(y) * sample.stride + static_cast<std::size_t>(x) * 4;
    const auto channel = [&](std::size_t i) { return std::to_integer<int>(sample.pixels[place + i]); };
    CHECK(channel(3) == 255);
    return {channel(2), channel(1), channel(0)};
}

bool is_near(Pixel a, Pixel b, int tolerance) {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(a[i] - b[i]) > tolerance) return false;
    return true;
}

}  // namespace

TEST_CASE("a frame of any format becomes BGRA of the size asked for, in its colours to the last pixel") {
    constexpr Pixel orange{200, 120, 40};
    for (const char* format : {"I420", "NV12", "Y42B", "Y444", "I420_10LE", "RGBx"}) {
        for (const char* colorimetry : {"bt601", "bt709"}) {
            const bool is_rgb = std::string(format) == "RGBx";
            CAPTURE(std::string(format));
            CAPTURE(std::string(colorimetry));
            const auto decoded = frame(format, 320, 180, orange, is_rgb ? "sRGB" : colorimetry);
            PictureScaler scaler(PictureForm::bgra);
            for (const auto& [width, height] : {std::pair{320, 180}, {160, 90}, {117, 71}, {401, 203}}) {
                const auto picture = scaler.scaled(decoded.get(), width, height, 7ms);
                REQUIRE(picture);
                CHECK(picture->layout == PixelLayout::bgra);
                CHECK(picture->width == width);
                CHECK(picture->height == height);
                CHECK(picture->stream_time == 7ms);
                CHECK(is_near(pixel(*picture, 0, 0), orange, 5));
                CHECK(is_near(pixel(*picture, width - 1, height - 1), orange, 5));
            }
        }
    }
}

TEST_CASE("a graphics card is lent the decoder's own planes, with what they mean") {
    for (const char* format : {"I420", "NV12"}) {
        const auto decoded = frame(format, 320, 180, {200, 120, 40}, "bt709");
        PictureScaler scaler(PictureForm::planes);
        const auto picture = scaler.scaled(decoded.get(), 300, 170, 0ms);
        REQUIRE(picture);
        const bool is_nv12 = std::string(format) == "NV12";
        CHECK(picture->layout == (is_nv12 ? PixelLayout::nv12 : PixelLayout::i420));
        CHECK(picture->width == 320);
        CHECK(picture->height == 180);
        CHECK(picture->colours == ColourCode{ColourCode::Matrix::bt709, false});
        CHECK(picture->pixels.size() >= 320 * 180);
        CHECK(picture->chroma[0].bytes.size() >= (is_nv12 ? 320 : 160) * 90);
        CHECK(picture->chroma[1].bytes.empty() == is_nv12);
    }
}

TEST_CASE("planes much larger than they are shown are made smaller before they are uploaded") {
    const auto decoded = frame("NV12", 640, 360, {200, 120, 40});
    PictureScaler scaler(PictureForm::planes);
    const auto picture = scaler.scaled(decoded.get(), 161, 91, 0ms);
    REQUIRE(picture);
    CHECK(picture->layout == PixelLayout::i420);
    CHECK(picture->width == 161);
    CHECK(picture->height == 91);
    const int last = std::to_integer<int>(picture->chroma[1].bytes[45 * picture->chroma[1].stride + 80]);
    CHECK(std::abs(last - 169) < 4);  // Cr of orange: 128 + 112 * (200 - 134.8) / 255 / 0.701
}

TEST_CASE("HDR films are as bright as a usual screen shows them, others untouched, whatever the form") {
    struct Film {
        const char* colorimetry;
        int grey;      // code of each one's paper white
        int expected;  // tone_map_test.cpp
    };

    for (const PictureForm form : {PictureForm::bgra, PictureForm::planes}) {
        for (const Film& film :
             {Film{"bt2100-pq", 148, 191}, Film{"bt2100-hlg", 191, 191}, Film{"bt709", 148, 148}}) {
            CAPTURE(film.colorimetry);
            const auto decoded =
                frame("I420_10LE", 96, 64, {film.grey, film.grey, film.grey}, film.colorimetry);
            const auto picture = PictureScaler(form).scaled(decoded.get(), 48, 32, 0ms);
            REQUIRE(picture);
            CHECK(is_near(pixel(*picture, 20, 20), {film.expected, film.expected, film.expected}, 6));
        }
    }
}

TEST_CASE("the memory of a picture nobody holds any more is used for the next") {
    const auto decoded = frame("I420", 320, 180, {200, 120, 40});
    PictureScaler scaler(PictureForm::bgra);
    auto first = scaler.scaled(decoded.get(), 160, 90, 0ms);
    const auto second = scaler.scaled(decoded.get(), 160, 90, 0ms);
    const std::byte* const place = first->pixels.data();
    CHECK(second->pixels.data() != place);
    first.reset();
    const auto third = scaler.scaled(decoded.get(), 160, 90, 0ms);
    CHECK(third->pixels.data() == place);
}

TEST_CASE("a picture outlives who made it") {
    const auto decoded = frame("I420", 320, 180, {200, 120, 40});
    std::optional<Sample> picture = PictureScaler(PictureForm::bgra).scaled(decoded.get(), 160, 90, 0ms);
    CHECK(is_near(pixel(*picture, 80, 45), {200, 120, 40}, 5));
}
