// The leader's drawing of its part of a canvas and a follower's of its own are together what one screen would
// show.

#include "tests/player/render/drawn_wall.hpp"
#include "tests/player/scene/acts/shared_house.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int across = 1280;
constexpr int down = 720;
constexpr int first_across = 576;  // px of the leader's screen

int wave(int place) {
    return std::abs(place % 510 - 255);
}

/// A canvas as a whole by the leader's frame, its left part by the leader's, its right part by the
/// follower's.
class Parts {
  public:
    /// The farthest that a pixel's channel is off, levels.
    int difference(const TestBox& lead, const TestBox& follower) {
        upload(lead);
        upload(follower);
        const Picture whole = drawn(whole_.screen, {}, lead.last);
        const Picture left = drawn(left_, {.part = Box{{0, 0}, {first_across, down}}}, lead.last);
        const Picture right = drawn(right_, {.part = Box{{first_across, 0}, {across, down}}}, follower.last);
        int farthest = 0;
        for (int y = 0; y < down; ++y)
            for (int x = 0; x < across; ++x) {
                const Colour one = at(whole, x, y);
                const Colour other = x < first_across ? at(left, x, y) : at(right, x - first_across, y);
                for (std::size_t k = 0; k < one.size(); ++k)
                    farthest = std::max(farthest, std::abs(one[k] - other[k]));
            }
        return farthest;
    }

  private:
    /// Pictures with gradients that tell the file, the shot and the picture of the film.
    void upload(const TestBox& box) {
        for (const DrawItem& item : box.last.items) {
            const ShotRequest& request = box.playing.at(item.source);
            const auto film = request.kind == MediaKind::film ? item.local.count() / 40'000'000 : 0;
            const int shift = static_cast<int>(std::hash<std::string>()(request.path) % 200) +
                              static_cast<int>(request.shot.begin.count() / 1'000'000'000) * 31 +
                              static_cast<int>(film % 100) * 5;
            whole_.renderer.upload(
                item.source,
                still(640, 360, [&](int x, int y) {
                    return Colour{wave(2 * x + shift), wave(3 * y + shift), wave(x + y + 3 * shift)};
                }).sample);
        }
    }

    Picture drawn(OffscreenScreen& screen, const View& view, const Frame& frame) {
        whole_.renderer.aim(screen.width(), screen.height(), view);
        screen.begin_frame();
        whole_.renderer.draw(frame);
        screen.present({});
        return screen.picture();
    }

    std::shared_ptr<Egl> egl_ = std::make_shared<Egl>(Egl::surfaceless());
    DrawnWall whole_{across, down, {}, egl_};
    OffscreenScreen left_{{.width = first_across, .height = down}, egl_};
    OffscreenScreen right_{{.width = across - first_across, .height = down}, egl_};
};

}  // namespace

TEST_CASE("the leader's part and a follower's part are together the whole, in changes too") {
    SharedHouse house({.seed = 9, .followers = 1});
    house.run(5s);
    Parts parts;
    int compared = 0;
    int changing = 0;
    for (int k = 0; k < 2000 && compared < 16; ++k) {
        house.run(7ms);
        const TestBox& lead = house.boxes[0];
        const TestBox& follower = house.boxes[1];
        const bool is_changing = house.led().parts().change && house.led().parts().change->is_fading() &&
                                 lead.last.time > house.led().parts().change->began;
        const bool is_wanted = is_changing || (k % 40 == 0 && compared - changing < 8);  // half of them stand
        if (!is_wanted || lead.frames.back().content != follower.frames.back().content) continue;
        CHECK(parts.difference(lead, follower) <= 1);
        ++compared;
        if (is_changing) ++changing;
        house.run(60ms);
    }
    CHECK(compared == 16);
    CHECK(changing >= 8);
}
