#include "player/scene/change_pace.hpp"
#include "player/scene/wall.hpp"
#include "tests/player/render/drawn_wall.hpp"
#include "tests/player/render/flash_meter.hpp"
#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <memory>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int width = 32;  // px of the screen
constexpr int height = 18;
constexpr Vec2 wide{640, 360};

/// A wall of black and of white pictures on a screen. The first of two files is black, the next white.
class BlackAndWhite {
  public:
    BlackAndWhite(int slots, std::chrono::nanoseconds motion)
        : settings_{.slots = {.count = slots, .order = ShotOrder::name}, .transition = {.duration = motion}} {
        make_wall();
    }

    Wall& wall() { return *wall_; }

    std::chrono::nanoseconds now() const { return now_; }

    /// Makes the wall anew, like the player when settings have changed.
    void make_wall() {
        settings_.slots.last_source += 10'000;
        wall_ = std::make_unique<Wall>(wide, settings_);
        wall_->set_catalogue(photos(40));
    }

    /// Draws frames for a while. @param disturb  called before each frame
    void run(std::chrono::nanoseconds duration, const std::function<void(int frame)>& disturb) {
        for (int frame = 0; frame * period < duration; ++frame) {
            disturb(frame);
            draw();
        }
    }

    const FlashMeter& meter() const { return meter_; }

  private:
    static constexpr auto period = 40ms;

    void draw() {
        const WallStep step = wall_->step(now_);
        for (const ShotRequest& request : step.requests) {
            paint(request);
            wall_->source_ready(request.source);
        }
        if (step.plan) wall_->set_layout(side_by_side(*step.plan));
        ReferenceCompositor screen(width, height, letterboxed(width, height, {}, step.frame.canvas));
        for (const auto& [source, is_white] : is_white_)
            screen.add(source, is_white ? white_.sample : black_.sample, false);
        meter_.add(screen.drawn(step.frame), now_);
        for (const SourceId source : step.retired)
            is_white_.erase(source);
        now_ += period;
    }

    void paint(const ShotRequest& request) {
        is_white_[request.source] = (request.path.back() - '0') % 2 == 1;
    }

    WallSettings settings_;
    std::unique_ptr<Wall> wall_;
    std::map<SourceId, bool> is_white_;
    Still black_ = still(2, 2, [](int, int) { return Colour{0, 0, 0}; });
    Still white_ = still(2, 2, [](int, int) { return Colour{255, 255, 255}; });
    std::chrono::nanoseconds now_{0};
    FlashMeter meter_;
};

/// Tries walls of one and of three shots, with changes of any length.
void try_walls(const std::function<void(BlackAndWhite& wall, int frame)>& disturb) {
    for (const int slots : {1, 3})
        for (const auto motion : {0ms, 100ms, 300ms, 800ms}) {
            CAPTURE(slots);
            CAPTURE(motion.count());
            BlackAndWhite wall(slots, motion);
            wall.run(4s, [&](int frame) { disturb(wall, frame); });
            CHECK(wall.meter().worst_share() < 0.25);
            CHECK(wall.meter().most_changes() > 0);  // something has changed at all
        }
}

}  // namespace

TEST_CASE("a flash is a pair of opposite changes, and the meter counts more than two in a second") {
    for (const auto period : {120ms, 300ms}) {
        FlashMeter meter;
        for (auto now = 0ms; now < 3s; now += 20ms) {
            const double grey = static_cast<double>(now / period % 2);
            meter.add({.width = 1, .height = 1, .pixels = {Rgb{grey, grey, grey}}}, now);
        }
        CHECK((meter.worst_share() > 0) == (period < 250ms));
    }
}

TEST_CASE("turns that are asked for again and again do not flash") {
    try_walls([](BlackAndWhite& wall, int frame) {
        wall.wall().set_controls({.turns = static_cast<std::uint64_t>(frame)});
    });
}

TEST_CASE("files that are replaced again and again do not flash") {
    try_walls([](BlackAndWhite& wall, int frame) {
        auto records = photos(40);
        records.erase(records.begin(), records.begin() + frame % 2);
        wall.wall().set_catalogue(records);
    });
}

TEST_CASE("files that all go and come back do not flash") {
    try_walls([](BlackAndWhite& wall, int frame) {
        wall.wall().set_catalogue(frame / 3 % 2 == 0 ? std::vector{photo("p1"), photo("p3"), photo("p5")}
                                                     : std::vector<MediaRecord>{});
    });
}

TEST_CASE("panels of another shape that come and go do not flash") {
    try_walls([](BlackAndWhite& wall, int frame) {
        wall.wall().set_canvas(frame / 2 % 2 == 0 ? wide : Vec2{360, 640});
        wall.wall().set_controls({.turns = static_cast<std::uint64_t>(frame)});
    });
}

TEST_CASE("pictures that visitors throw out one after another do not flash") {
    try_walls([](BlackAndWhite& wall, int frame) {
        const double x = frame % 3 * 213 + 106.0;
        wall.wall().handle_gesture(
            {.kind = Gesture::Kind::flick, .at = {x, 180}, .from = {x, 180}, .velocity = {0, 9000}});
    });
}

TEST_CASE("pictures that visitors touch again and again do not flash") {
    try_walls([](BlackAndWhite& wall, int frame) {
        const double x = frame % 3 * 213 + 106.0;
        wall.wall().handle_gesture({.kind = Gesture::Kind::tap, .at = {x, 180}, .from = {x, 180}});
        wall.wall().set_controls({.turns = static_cast<std::uint64_t>(frame)});
    });
}

TEST_CASE("settings that are read again and again do not flash") {
    ChangePace pace(flash_spacing);
    try_walls([&](BlackAndWhite& wall, int frame) {
        if (frame == 0) pace = ChangePace(flash_spacing);
        if (!pace.is_free(wall.now())) return;
        pace.note_change(wall.now());
        wall.make_wall();
    });
}
