#include "player/playback/shared_frame.hpp"

#include "player/playback/picture_scaler.hpp"
#include "tests/player/playback/shared_memory.hpp"

#include <doctest/doctest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int width = 64;
constexpr int height = 32;
constexpr gsize frame_bytes = width * height * 3 / 2;
const std::string plain = "video/x-raw,format=NV12,width=64,height=32,framerate=30/1,colorimetry=bt709";

// Memory of ours in the place of a decoder's, with `grey` in each byte.
int memory(gsize bytes, int grey = 0) {
    const int file = ::memfd_create("vitrine-test", MFD_CLOEXEC);
    REQUIRE(file >= 0);
    const std::vector<char> content(bytes, static_cast<char>(grey));
    REQUIRE(::write(file, content.data(), bytes) == static_cast<ssize_t>(bytes));
    return file;
}

GstPtr<GstSample> decoded(const std::string& caps, const std::vector<PlanePlace>& places = {}, int grey = 0,
                          gsize bytes = frame_bytes, GstVideoFormat format = GST_VIDEO_FORMAT_NV12) {
    return shared_sample(memory(bytes, grey), bytes, caps, format, width, height, places);
}

}  // namespace

TEST_CASE("planes in shared memory stay where they are, as their strides say or as is usual") {
    const auto usual = shared_frame(decoded(plain).get());
    REQUIRE(usual);
    CHECK(usual->layout == PixelLayout::nv12);
    CHECK(usual->width == width);
    CHECK(usual->height == height);
    CHECK(usual->colours == ColourCode{ColourCode::Matrix::bt709, false});
    CHECK(usual->pixels.empty());
    REQUIRE(usual->shared);
    CHECK(usual->shared->planes[0].file >= 0);
    CHECK(usual->shared->planes[0].file == usual->shared->planes[1].file);
    CHECK(usual->shared->planes[1].offset == width * height);
    CHECK_FALSE(usual->shared->modifier);

    const auto wide =
        shared_frame(decoded(plain, {{0, 128}, {gsize{128} * 40, 128}}, 0, gsize{128} * 60).get());
    REQUIRE(wide);
    CHECK(wide->shared->planes[0].stride == 128);
    CHECK(wide->shared->planes[1].offset == 128 * 40);
}

TEST_CASE("planes of three kinds are shared too, others and other memory are not") {
    const std::string head = "video/x-raw,width=64,height=32,framerate=30/1,format=";
    const auto three = shared_frame(decoded(head + "I420").get());
    REQUIRE(three);
    CHECK(three->layout == PixelLayout::i420);
    CHECK(three->shared->planes[2].offset == width * height * 5 / 4);
    CHECK_FALSE(shared_frame(decoded(head + "P010_10LE", {}, 0, 2 * frame_bytes).get()));
    CHECK_FALSE(shared_frame(decoded("video/x-h264").get()));

    const GstPtr<GstCaps> caps(gst_caps_from_string(plain.c_str()));
    GstBuffer* bytes = gst_buffer_new_allocate(nullptr, frame_bytes, nullptr);
    const GstPtr<GstSample> unshared(gst_sample_new(bytes, caps.get(), nullptr, nullptr));
    gst_buffer_unref(bytes);
    CHECK_FALSE(shared_frame(unshared.get()));
}

TEST_CASE("how the pixels lie is read from the caps where they say so") {
    const std::string head =
        "video/x-raw(memory:DMABuf),format=DMA_DRM,width=64,height=32,framerate=30/1,drm-format=";
    const auto tiled = shared_frame(decoded(head + "(string)NV12:0x0100000000000002").get());
    REQUIRE(tiled);
    CHECK(tiled->layout == PixelLayout::nv12);
    CHECK(tiled->shared->modifier == 0x0100000000000002ULL);
    CHECK(tiled->shared->planes[1].offset == width * height);
    const auto linear = shared_frame(decoded(head + "(string)YU12").get());
    REQUIRE(linear);
    CHECK(linear->layout == PixelLayout::i420);
    for (const char* other : {"AR24:0x0", "NV12:x", "NV12:0xzz", "P010", "NV12:"}) {
        CAPTURE(other);
        CHECK_FALSE(shared_frame(decoded(head + "(string)" + other).get()));
    }
}

TEST_CASE("shared planes that nobody can read there have bytes, and so have those that follow") {
    PictureScaler scaler(PictureForm::shared);
    const auto first = scaler.scaled(decoded(plain, {}, 77).get(), 300, 170, 5ms);
    REQUIRE(first);
    REQUIRE(first->shared);
    CHECK(first->stream_time == 5ms);

    const auto bytes = first->copied();

    REQUIRE(bytes);
    CHECK_FALSE(bytes->shared);
    REQUIRE(bytes->pixels.size() == width * height);
    CHECK(bytes->pixels.back() == std::byte{77});
    CHECK(bytes->chroma[0].bytes.front() == std::byte{77});
    const auto next = scaler.scaled(decoded(plain).get(), 300, 170, 0ms);
    REQUIRE(next);
    CHECK_FALSE(next->shared);
    CHECK_FALSE(next->pixels.empty());
}

TEST_CASE("HDR films are not shared, as only the processor changes their tones, nor films where planes are "
          "not wanted") {
    const std::string hdr = "video/x-raw,format=NV12,width=64,height=32,framerate=30/1,colorimetry=bt2100-pq";
    const auto toned = PictureScaler(PictureForm::shared).scaled(decoded(hdr).get(), width, height, 0ms);
    REQUIRE(toned);
    CHECK_FALSE(toned->shared);
    CHECK(toned->layout == PixelLayout::bgra);

    const auto planes = PictureScaler(PictureForm::planes).scaled(decoded(plain).get(), width, height, 0ms);
    REQUIRE(planes);
    CHECK_FALSE(planes->shared);
}
