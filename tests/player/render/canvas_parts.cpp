#include "tests/player/render/canvas_parts.hpp"

#include "player/scene/transition_frame.hpp"
#include "tests/player/render/drawn_wall.hpp"
#include "tests/player/scene/changing_wall.hpp"

#include <algorithm>
#include <cstdlib>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr int across = 640;
constexpr int down = 360;
constexpr int first_across = 288;  // px of the left screen

/// Brightness that goes up and down evenly. A graphics card weighs neighbours in steps of 1/256, so where two
/// of them are black and white its own rounding is more than one grey level.
int wave(int place) {
    return std::abs(place % 510 - 255);
}

/// Pictures with gradients, and films whose picture changes.
Still picture_at(SourceId source, int number) {
    const int shift = static_cast<int>(source) * 37 + number * 5;
    return still(320, 180, [&](int x, int y) {
        return Colour{wave(4 * x + shift), wave(9 * y + shift), wave(5 * (x + y) + 3 * shift)};
    });
}

/// A canvas on one screen, and its halves on two, in one GL context.
class Halves {
  public:
    void upload(int number) {
        for (SourceId source = 1; source < 60; ++source) {
            if (number > 0 && source % 3 != 0) continue;  // the others are photos
            const Still picture = picture_at(source, number);
            whole_.renderer.upload(source, picture.sample);
        }
    }

    void compare(const Frame& frame) {
        if (++result.frames % 8 == 0) upload(result.frames);
        const Picture whole = drawn(whole_.screen, {}, frame);
        const Picture left = drawn(left_, {.part = Box{{0, 0}, {first_across, down}}}, frame);
        const Picture right = drawn(right_, {.part = Box{{first_across, 0}, {across, down}}}, frame);
        for (int y = 0; y < down; ++y)
            for (int x = 0; x < across; ++x) {
                const Colour half = x < first_across ? at(left, x, y) : at(right, x - first_across, y);
                compare(at(whole, x, y), half);
            }
    }

    PartsDifference result;

  private:
    void compare(const Colour& one, const Colour& other) {
        int farthest = 0;
        for (std::size_t k = 0; k < one.size(); ++k)
            farthest = std::max(farthest, std::abs(one[k] - other[k]));
        result.channel = std::max(result.channel, farthest);
        if (farthest > 1) ++result.odd;
    }

    Picture drawn(OffscreenScreen& screen, const View& view, const Frame& frame) {
        whole_.renderer.aim(screen.width(), screen.height(), view);
        screen.begin_frame();
        whole_.renderer.draw(frame);
        screen.present(frame.time);
        return screen.picture();
    }

    std::shared_ptr<Egl> egl_ = std::make_shared<Egl>(Egl::surfaceless());
    DrawnWall whole_{across, down, {}, egl_};
    OffscreenScreen left_{{.width = first_across, .height = down}, egl_};
    OffscreenScreen right_{{.width = across - first_across, .height = down}, egl_};
};

}  // namespace

PartsDifference compare_parts(int frames, std::uint64_t seed) {
    Halves halves;
    halves.upload(0);
    constexpr int moments = 8;  // of a change
    for (; halves.result.frames < frames; ++seed) {
        ChangingWall wall({across, down}, 5 + seed % 5, seed);
        const auto change_to = [&](ChangingWall::Shots next) {
            const Transition made = transition(wall.canvas(), wall.shown(), next, {});
            for (int k = 0; k < moments && halves.result.frames < frames; ++k)
                halves.compare(transition_frame(made, made.duration * (2 * k + 1) / (2 * moments), {}, 0s));
            wall.show(std::move(next));
        };
        change_to(wall.turned());
        change_to(wall.with_one_more());
        int number = 0;
        wall.drag(2, [&](const TouchedHouse&, const Frame& frame) {
            if (++number % 3 == 0 && halves.result.frames < frames) halves.compare(frame);
        });
    }
    return halves.result;
}

}  // namespace vitrine::player
