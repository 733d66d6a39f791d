#include "player/playback/reader/picture_intake.hpp"

#include "base/state/media_error.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <memory>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int width = 16;
constexpr int height = 10;

/// An intake with memory for three pictures, and what it has given back.
struct Desk {
    explicit Desk(std::size_t count = 3) { add(count, width, height); }

    void add(std::size_t count, int wide, int high) {
        const SlotShape shape = slots_for(count, wide, high, PictureForm::bgra).value();
        const UniqueFd memory = new_slot_memory(shape);
        written = std::make_unique<PictureSlots>(memory, shape, PictureSlots::Use::writing);
        intake.add_memory(std::make_shared<PictureSlots>(memory, shape, PictureSlots::Use::reading));
    }

    std::vector<SlotNote> given_back;
    std::unique_ptr<PictureSlots> written;  // the newest memory, as the reader sees it
    PictureIntake intake{10s, [this](const SlotNote& slot) { given_back.push_back(slot); }};
};

PictureNote good() {
    return {.width = width,
            .height = height,
            .layout = static_cast<std::uint32_t>(PixelLayout::bgra),
            .stream_time = std::chrono::nanoseconds(1s).count(),
            .duration = std::chrono::nanoseconds(40ms).count(),
            .loop = 2};
}

}  // namespace

TEST_CASE("a picture in a slot is a sample of its bytes, and gives its slot back when it goes") {
    Desk desk;
    std::memset(desk.written->writable_slot(1).data(), 0x5a, desk.written->shape().bytes);
    PictureNote note = good();
    note.slot = 1;
    {
        const std::optional<LoopedSample> taken = desk.intake.take(note);
        REQUIRE(taken);
        CHECK(taken->loop == 2);
        CHECK(taken->duration == 40ms);
        CHECK(taken->sample.stream_time == 1s);
        CHECK(taken->sample.width == width);
        CHECK(taken->sample.stride >= std::size_t{4} * width);
        CHECK(taken->sample.pixels.front() == std::byte{0x5a});
        CHECK(desk.given_back.empty());
    }
    REQUIRE(desk.given_back.size() == 1);
    CHECK(desk.given_back.front().slot == 1);
    CHECK(desk.intake.take(note));
}

TEST_CASE("no number of a reader leads beyond its memory, nor to a slot that is in use") {
    Desk desk;
    const auto lies = [&](auto change) {
        PictureNote note = good();
        change(note);
        CHECK_THROWS_AS((void)desk.intake.take(note), MediaError);
    };
    constexpr auto least = std::numeric_limits<std::int32_t>::min();
    constexpr auto most = std::numeric_limits<std::int32_t>::max();
    lies([](PictureNote& note) { note.slot = 3; });
    lies([](PictureNote& note) { note.slot = ~0U; });
    lies([](PictureNote& note) { note.memory = 1; });
    lies([](PictureNote& note) { note.memory = ~0U; });
    for (const std::int32_t side : {least, -1, 0, most, 16'385, 4 * width}) {
        lies([&](PictureNote& note) { note.width = side, note.height = most; });
        lies([&](PictureNote& note) { note.width = most, note.height = side; });
        lies([&](PictureNote& note) { note.width = side, note.height = 4096; });
        lies([&](PictureNote& note) { note.width = 4096, note.height = side; });
    }
    lies([](PictureNote& note) { note.layout = 4; });
    lies([](PictureNote& note) { note.layout = ~0U; });
    lies([](PictureNote& note) { note.matrix = 3; });
    const std::optional<LoopedSample> held = desk.intake.take(good());
    CHECK(held);
    lies([](PictureNote&) {});  // the slot is in use
}

TEST_CASE("no time of a reader is so large that the sum of two is none") {
    Desk desk;
    constexpr auto least = std::numeric_limits<std::int64_t>::min();
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    const auto lies = [&](auto change) {
        PictureNote note = good();
        change(note);
        CHECK_THROWS_AS((void)desk.intake.take(note), MediaError);
    };
    for (const std::int64_t time : {least, least + 1, most - 1, most}) {
        lies([&](PictureNote& note) { note.stream_time = time; });
        lies([&](PictureNote& note) { note.duration = time; });
        lies([&](PictureNote& note) { note.spent = time; });
    }
    lies([](PictureNote& note) { note.duration = -1; });
    lies([](PictureNote& note) { note.spent = -1; });
    lies([](PictureNote& note) { note.loop = ~std::uint64_t{0}; });
    lies([](PictureNote& note) { note.loop = std::uint64_t{1} << 40U; });
}

TEST_CASE("pictures may lie in the newest memory and in the one before; older ones are passed over") {
    Desk desk;
    const std::optional<LoopedSample> first = desk.intake.take(good());
    desk.add(2, 2 * width, height);
    PictureNote note = good();
    note.slot = 1;
    CHECK(desk.intake.take(note));
    note.memory = 1;
    note.width = 2 * width;
    CHECK(desk.intake.take(note));
    desk.add(2, 4 * width, height);
    note = good();
    note.slot = 2;
    CHECK_FALSE(desk.intake.take(note));
    CHECK(first->sample.pixels.front() == std::byte{0});  // its memory is still there
}

TEST_CASE("the planes of a picture lie within its slot, whatever its size") {
    for (const PixelLayout layout :
         {PixelLayout::rgba, PixelLayout::bgra, PixelLayout::i420, PixelLayout::nv12}) {
        for (const int side : {1, 2, 3, 63, 64, 65, 255}) {
            std::vector<std::byte> slot(std::size_t{4} * 320 * 255);
            const std::optional<Sample> sample = sample_in(slot, side, 255 - side + 1, layout);
            REQUIRE(sample);
            for (const auto& bytes : {sample->pixels, sample->chroma[0].bytes, sample->chroma[1].bytes}) {
                if (bytes.empty()) continue;
                CHECK(bytes.data() >= slot.data());
                CHECK(bytes.data() + bytes.size() <= slot.data() + slot.size());
            }
        }
    }
}

TEST_CASE("a copied picture is the picture, and one that does not fit is not copied") {
    std::vector<std::byte> pixels(std::size_t{5} * 40);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<std::byte>(i);
    const Sample picture{
        .width = 8, .height = 5, .stride = 40, .pixels = pixels, .layout = PixelLayout::bgra};
    std::vector<std::byte> slot(4096);
    REQUIRE(copy_picture(picture, slot));
    const Sample copy = sample_in(slot, 8, 5, PixelLayout::bgra).value();
    for (std::size_t row = 0; row < 5; ++row)
        CHECK(std::memcmp(&copy.pixels[row * copy.stride], &pixels[row * 40], 32) == 0);
    CHECK_FALSE(copy_picture(picture, std::span(slot).first(200)));
    Sample cut = picture;
    cut.pixels = cut.pixels.first(150);
    CHECK_FALSE(copy_picture(cut, slot));
}
