#include "player/stage/show_switch.hpp"

#include "base/state/tapestry.hpp"
#include "player/display/offscreen_screen.hpp"
#include "tests/player/render/flash_meter.hpp"
#include "tests/player/scene/scene_media.hpp"
#include "tests/player/scene/tapestry/drawn_tapestry.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int width = 64;  // px of the screen
constexpr int height = 36;
constexpr auto period = 40ms;

std::vector<std::byte> grey_pixels(int across, int down, int grey) {
    std::vector<std::byte> pixels;
    for (int i = 0; i < across * down; ++i)
        for (const int channel : {grey, grey, grey, 255})
            pixels.push_back(static_cast<std::byte>(channel));
    return pixels;
}

bool is_white(const std::string& path) {
    return (path.back() - '0') % 2 == 1;
}

/// Black and white photos in turns, and a tapestry of each in the other colour.
class BlackAndWhiteFilms {
  public:
    BlackAndWhiteFilms(int slots, std::chrono::milliseconds motion) {
        settings_.state.directory = directory_.path.string();
        settings_.layout.slots = slots;
        settings_.show.order = ShotOrder::name;
        settings_.show.motion = motion;
        for (const MediaRecord& record : photos(6)) {
            Tapestry tapestry = drawn_tapestry(1);
            tapestry.path = record.path;
            tapestry.bytes = record.bytes;
            tapestry.mtime_ns = record.mtime_ns;
            write(tapestry, is_white(record.path) ? 0 : 255);
        }
        files_.set(RecordList(photos(6)), {});
        shows_.emplace(settings_, 1, true);
        shows_->set_canvas({width, height});
        shows_->set_files(files_);
    }

    ShowSwitch& shows() { return *shows_; }

    const FlashMeter& meter() const { return meter_; }

    int opened() const { return opened_; }

    /// The largest difference between two frames one after the other, in the mean of their pixels, 0 to 1.
    double largest_step() const { return largest_step_; }

    /// Opens the tapestry of the first shot on the wall, if it may be opened.
    void open_tapestry() {
        const std::vector<SlotShot> standing = shows_->wall().standing();
        if (standing.empty() || shows_->tapestry() != nullptr) return;
        const RecordList::Record photo = files_.all().find(standing.front().key.path);
        if (shows_->open_tapestry(photo, 0, {}) == Opening::opened) ++opened_;
    }

    void close_tapestry() {
        if (shows_->tapestry() != nullptr)
            shows_->tapestry()->handle_gesture({.kind = Gesture::Kind::key, .key = Key::back});
    }

    /// Draws frames for a while. @param disturb  called before each frame
    void run(std::chrono::nanoseconds duration, const std::function<void(int frame)>& disturb) {
        for (int frame = 0; frame * period < duration; ++frame) {
            shows_->set_time(now_);
            disturb(frame);
            forget(shows_->leave_finished_tapestry());
            draw();
            now_ += period;
        }
    }

  private:
    void write(const Tapestry& tapestry, int grey) const {
        const auto directory = tapestry_folder(settings_.state.directory, tapestry.path);
        for (int tile = 0; tile < tapestry.tiles(0); ++tile) {
            Picture picture{
                .width = std::min(tapestry.tile_width, tapestry.levels[0].width - tile * tapestry.tile_width),
                .height = tapestry.height,
                .pixels = {}};
            picture.pixels = grey_pixels(picture.width, picture.height, grey);
            const auto file = directory / tapestry.tile_name(0, tile);
            std::filesystem::create_directories(file.parent_path());
            save_png(picture, file);
        }
        write_tapestry(directory, tapestry);
    }

    void draw() {
        WallStep step = shows_->step(&renderer_);
        for (const ShotRequest& request : step.requests) {
            renderer_.upload(request.source, is_white(request.path) ? white_ : black_);
            shows_->handle_source_event({.source = request.source, .failure = {}, .unstored = {}});
        }
        if (step.plan) shows_->wall().set_layout(side_by_side(*step.plan));
        forget(step.retired);
        shows_->fade(step.frame);
        screen_.begin_frame();
        renderer_.aim(width, height, letterboxed(width, height, {}, step.frame.canvas));
        renderer_.draw(step.frame);
        screen_.present(now_);
        const ReferenceImage image = image_of(screen_.picture());
        meter_.add(image, now_);
        double light = 0;
        for (const Rgb& pixel : image.pixels)
            light += pixel[1] / static_cast<double>(image.pixels.size());
        if (light_) largest_step_ = std::max(largest_step_, std::abs(light - *light_));
        light_ = light;
    }

    void forget(const std::vector<SourceId>& sources) {
        for (const SourceId source : sources)
            renderer_.forget(source);
    }

    static ReferenceImage image_of(const Picture& picture) {
        ReferenceImage image{.width = picture.width, .height = picture.height};
        for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
            Rgb colour{};
            for (std::size_t k = 0; k < 3; ++k)
                colour.at(k) = std::to_integer<int>(picture.pixels[i + k]) / 255.0;
            image.pixels.push_back(colour);
        }
        return image;
    }

    TemporaryDirectory directory_;
    Settings settings_;
    StageFiles files_{""};
    OffscreenScreen screen_{{.width = width, .height = height, .film = {}}};
    Renderer renderer_{width, height};
    std::optional<ShowSwitch> shows_;
    std::vector<std::byte> pixels_of_white_ = grey_pixels(2, 2, 255);
    std::vector<std::byte> pixels_of_black_ = grey_pixels(2, 2, 0);
    Sample white_{.width = 2, .height = 2, .stride = 8, .pixels = pixels_of_white_};
    Sample black_{.width = 2, .height = 2, .stride = 8, .pixels = pixels_of_black_};
    std::chrono::nanoseconds now_{0};
    FlashMeter meter_;
    int opened_ = 0;
    std::optional<double> light_;  // of the last frame
    double largest_step_ = 0;
};

/// Tries walls of one and of three shots, with changes of any length.
void try_switches(const std::function<void(BlackAndWhiteFilms& films, int frame)>& disturb) {
    for (const int slots : {1, 3})
        for (const auto motion : {0ms, 100ms, 300ms, 800ms}) {
            CAPTURE(slots);
            CAPTURE(motion.count());
            BlackAndWhiteFilms films(slots, motion);
            films.run(5s, [&](int frame) { disturb(films, frame); });
            CHECK(films.opened() >= 2);
            CHECK(films.meter().worst_share() < 0.25);
            CHECK(films.meter().most_changes() > 0);
        }
}

}  // namespace

TEST_CASE("tapestries that visitors open and leave again and again do not flash") {
    try_switches([](BlackAndWhiteFilms& films, int) {
        films.open_tapestry();
        films.close_tapestry();
    });
}

TEST_CASE("a tapestry fades in over the wall, and the wall over the tapestry") {
    BlackAndWhiteFilms films(1, 800ms);
    films.run(5s, [&](int frame) {
        if (frame == 50) films.open_tapestry();
        if (frame == 85) films.close_tapestry();
    });
    CHECK(films.opened() == 1);
    CHECK(films.shows().tapestry() == nullptr);
    CHECK(films.largest_step() < 0.035);
}

TEST_CASE("turns between two looks at a tapestry do not flash with it") {
    try_switches([](BlackAndWhiteFilms& films, int frame) {
        films.shows().wall().set_controls({.turns = static_cast<std::uint64_t>(frame)});
        films.open_tapestry();
        films.close_tapestry();
    });
}

TEST_CASE("turns that come just before a tapestry opens do not flash with it") {
    try_switches([](BlackAndWhiteFilms& films, int frame) {
        films.shows().wall().set_controls({.turns = static_cast<std::uint64_t>(frame)});
        if (frame % 7 == 0) films.open_tapestry();
        if (frame % 3 == 0) films.close_tapestry();
    });
}
