// Runs in the rig's machine, whose card takes shared memory: a frame as a hardware decoder hands it over, in
// memory of the card, goes through the scaler and the renderer and has to look like one whose bytes were
// uploaded. Drawn once as a cell's part and once blurred as its filler. Says what it saw; ends with 1 where
// the two differ, or nothing was shared.
#include "player/display/egl.hpp"
#include "player/display/gl_device.hpp"
#include "player/playback/picture_scaler.hpp"
#include "tests/player/playback/shared_memory.hpp"
#include "tests/player/render/drawn_wall.hpp"

#include "base/system/error.hpp"
#include "base/system/handle.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gbm.h>
#include <sys/mman.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

using namespace vitrine;
using namespace vitrine::player;

namespace {

constexpr int width = 128;  // px
constexpr int height = 72;
constexpr int max_difference = 2;  // levels of a channel

// A picture of two halves in memory of the card, planes one after the other; its descriptor.
int draw(int card, std::uint32_t& stride, std::uint64_t& bytes) {
    std::uint32_t handle = 0;  // a buffer of 32 bits a pixel: this card knows no other
    std::uint64_t offset = 0;
    if (drmModeCreateDumbBuffer(card, width / 4, height * 3 / 2, 32, 0, &handle, &stride, &bytes) != 0)
        throw_errno("get memory of the card");
    if (drmModeMapDumbBuffer(card, handle, &offset) != 0) throw_errno("map memory of the card");
    void* const pixels =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, card, static_cast<off_t>(offset));
    if (pixels == MAP_FAILED) throw_errno("map memory of the card");
    auto* const to = static_cast<std::uint8_t*>(pixels);
    for (int y = 0; y < height * 3 / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const bool is_left = x < width / 2;
            const int light = is_left ? 60 + y : 180;
            const int difference = x % 2 == 0 ? (is_left ? 90 : 160) : (is_left ? 200 : 110);
            to[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)] =
                static_cast<std::uint8_t>(y < height ? light : difference);
        }
    int file = -1;
    if (drmPrimeHandleToFD(card, handle, DRM_CLOEXEC | DRM_RDWR, &file) != 0)
        throw_errno("share memory of the card");
    return file;
}

Picture drawn(const std::shared_ptr<Egl>& egl, GstSample* frame, PictureForm form) {
    DrawnWall wall(200, 100, {}, egl);
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    wall.add(2, filler(box(100, 0, 200, 100)), {100, 0});
    for (const SourceId source : {SourceId{1}, SourceId{2}}) {
        PictureScaler scaler(form);
        const auto sample = scaler.scaled(frame, width, height, {});
        if (!sample || sample->shared.has_value() != (form == PictureForm::shared))
            throw std::runtime_error("the frame is not handed over as it was asked for");
        if (const auto why = wall.renderer.upload(source, *sample)) throw std::runtime_error(*why);
    }
    return wall.shown();
}

int difference(const Picture& a, const Picture& b, int left, int right) {
    int largest = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = left; x < right; ++x)
            for (std::size_t i = 0; i < 3; ++i)
                largest = std::max(largest, std::abs(at(a, x, y)[i] - at(b, x, y)[i]));
    return largest;
}

int run(const char* path) {
    const UniqueFd card(::open(path, O_RDWR | O_CLOEXEC));
    if (!card.is_open()) throw_errno("open '{}'", path);
    const Handle<gbm_device, &gbm_device_destroy> device(gbm_create_device(card.get()));
    if (!device) throw_errno("make buffers on '{}'", path);
    const auto egl = std::make_shared<Egl>(Egl::on(*device));
    std::uint32_t stride = 0;
    std::uint64_t bytes = 0;
    const int file = draw(card.get(), stride, bytes);
    const int row = static_cast<int>(stride);
    const GstPtr<GstSample> frame = shared_sample(
        file, bytes, fmt::format("video/x-raw,format=NV12,width={},height={},framerate=30/1", width, height),
        GST_VIDEO_FORMAT_NV12, width, height, {{0, row}, {static_cast<gsize>(row) * height, row}});

    const Picture shared = drawn(egl, frame.get(), PictureForm::shared);
    const Picture uploaded = drawn(egl, frame.get(), PictureForm::planes);

    const int part = difference(shared, uploaded, 0, 100);
    const int blurred = difference(shared, uploaded, 100, 200);
    fmt::print("{}: shared and uploaded planes differ by {} where drawn sharp, by {} where blurred\n",
               gl_device(), part, blurred);
    const bool is_drawn = !is_near(at(shared, 20, 50), at(shared, 80, 50), 20);  // its halves
    return is_drawn && part <= max_difference && blurred <= 4 * max_difference ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
    try {
        return run(count > 1 ? words[1] : "/dev/dri/card0");
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
