#include "player/stage/stage.hpp"

#include "base/settings/settings.hpp"
#include "base/state/word_picture.hpp"
#include "player/display/offscreen_display.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/acts/followed_wall.hpp"
#include "player/scene/acts/led_show.hpp"
#include "player/scene/show.hpp"
#include "player/stage/output_canvas.hpp"
#include "player/stage/screen_painter.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <array>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Rgb = std::array<int, 3>;

constexpr Rgb red{220, 30, 30};
constexpr Rgb blue{30, 30, 220};
constexpr Rgb black{0, 0, 0};

void write_photo(const std::filesystem::path& path, const Rgb& colour) {
    Picture picture{.width = 160, .height = 90, .pixels = {}};
    for (int i = 0; i < picture.width * picture.height; ++i)
        for (const int channel : {colour[0], colour[1], colour[2], 255})
            picture.pixels.push_back(static_cast<std::byte>(channel));
    std::filesystem::create_directories(path.parent_path());
    save_png(picture, path);
}

MediaRecord record_of(const std::string& path) {
    const Polygon region = to_polygon(Box{{60, 25}, {100, 65}});
    MediaRecord record{.path = path, .state = MediaState::ready, .width = 160, .height = 90};
    record.shots = {Shot{.region = {.polygon = region}}};
    return record;
}

bool is_near(const Picture& picture, int x, int y, const Rgb& colour) {
    const std::size_t first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>(x)) *
                              4;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(std::to_integer<int>(picture.pixels[first + i]) - colour[i]) > 8) return false;
    return true;
}

Settings one_photo_at_a_time() {
    Settings settings;
    settings.layout.slots = 1;
    settings.layout.max_enlargement = 100;
    settings.show.order = ShotOrder::name;
    settings.show.motion = 0ms;
    return settings;
}

/// Counts what is drawn on a screen, and wants the last picture again when told to.
class CountingScreen final : public Screen {
  public:
    explicit CountingScreen(Screen& screen) : screen_(screen) {}

    const std::string& name() const override { return screen_.name(); }

    int width() const override { return screen_.width(); }

    int height() const override { return screen_.height(); }

    std::uint64_t flips() const override { return screen_.flips(); }

    std::optional<CardPicture> shown() override { return screen_.shown(); }

    bool is_ready() const override { return true; }

    bool wants_picture() const override { return wants; }

    void begin_frame() override { screen_.begin_frame(); }

    void present(std::chrono::nanoseconds time) override {
        screen_.present(time);
        ++pictures;
    }

    bool wants = false;
    int pictures = 0;

  private:
    Screen& screen_;  // outlives this
};

/// A red and a blue photo, in folders of their own, and one wall that takes turns with them.
struct Theatre {
    explicit Theatre(const std::vector<ScreenSize>& screens, Settings wanted = one_photo_at_a_time(),
                     const std::string& folder = "", std::shared_ptr<const OtherOutputs> others = {})
        : settings(std::move(wanted)), display({.screens = screens}, {}, 30) {
        write_photo(directory.path / "a/red.png", red);
        write_photo(directory.path / "b/blue.png", blue);
        StageOptions options{.number = others ? 0U : 3U,
                             .folder = folder,
                             .awaits_sources = true,
                             .others = std::move(others)};
        stage = std::make_unique<Stage>(settings, options, sources);
        const std::vector<MediaRecord> records{record_of("a/red.png"), record_of("b/blue.png")};
        stage->set_catalogue(records);
    }

    void show_all(std::chrono::nanoseconds now) {
        const auto screens = display.screens();
        stage->set_screens({screens.begin(), screens.end()}, now);
        stage->show(now, &renderer);
    }

    Picture picture(std::size_t screen) {
        return dynamic_cast<OffscreenScreen&>(*display.screens()[screen]).picture();
    }

    TemporaryDirectory directory;
    Settings settings;
    OffscreenDisplay display;
    Renderer renderer{1, 1};
    SourcePool sources{{.media = directory.path.string(), .store = {}}};
    std::unique_ptr<Stage> stage;
};

void play(Theatre& theatre, std::chrono::nanoseconds from, std::chrono::nanoseconds to) {
    for (auto now = from; now <= to; now += 200ms)
        theatre.show_all(now);
}

}  // namespace

TEST_CASE("every screen shows the wall, the one of another shape between black bars") {
    Theatre theatre({{320, 180}, {160, 160}, {160, 90}});

    play(theatre, 0s, 1s);

    for (const auto& [number, x, y] : {std::tuple{0, 160, 90}, {1, 80, 80}, {2, 80, 45}}) {
        const int screen = number;
        CAPTURE(screen);
        CHECK(is_near(theatre.picture(static_cast<std::size_t>(screen)), x, y, red));
    }
    CHECK(is_near(theatre.picture(1), 80, 30, black));
    CHECK(is_near(theatre.picture(1), 80, 130, black));
    CHECK_FALSE(is_near(theatre.picture(1), 80, 40, black));
}

TEST_CASE("margins stay black on every screen") {
    Settings settings = one_photo_at_a_time();
    settings.output.margins = "10%,0,20,0";
    Theatre theatre({{320, 180}}, settings);

    play(theatre, 0s, 1s);

    const Picture picture = theatre.picture(0);
    CHECK(is_near(picture, 31, 90, black));
    CHECK(is_near(picture, 300, 90, black));
    CHECK_FALSE(is_near(picture, 33, 90, black));
    CHECK_FALSE(is_near(picture, 299, 90, black));
}

TEST_CASE("a stage of a folder shows what is in it and nothing else") {
    Theatre theatre({{320, 180}}, one_photo_at_a_time(), "b");
    for (auto now = 0s; now <= 60s; now += 10s) {
        play(theatre, now, now + 2s);
        CHECK(is_near(theatre.picture(0), 160, 90, blue));
    }
}

TEST_CASE("a wall on which nothing is new is drawn once a second, and when a screen has lost it") {
    Theatre theatre({{320, 180}});
    CountingScreen screen(*theatre.display.screens()[0]);
    const auto shown_within = [&](std::chrono::nanoseconds from, std::chrono::nanoseconds to) {
        const int before = screen.pictures;
        for (auto now = from; now < to; now += 20ms) {
            theatre.stage->set_screens({&screen}, now);
            theatre.stage->show(now, &theatre.renderer);
        }
        return screen.pictures - before;
    };
    shown_within(0s, 2s);
    REQUIRE(is_near(theatre.picture(0), 160, 90, red));
    CHECK(shown_within(2s, 7s) == 5);
    screen.wants = true;
    CHECK(shown_within(7s, 8s) == 50);
    screen.wants = false;
    shown_within(18s, 20500ms);
    CHECK(is_near(theatre.picture(0), 160, 90, blue));
}

TEST_CASE("the idle picture is drawn ten times a second") {
    Theatre theatre({{320, 180}}, one_photo_at_a_time(), "nothing/here");
    CountingScreen screen(*theatre.display.screens()[0]);
    for (auto now = 0ms; now < 1s; now += 20ms) {
        theatre.stage->set_screens({&screen}, now);
        theatre.stage->show(now, &theatre.renderer);
    }
    CHECK(screen.pictures == 10);
}

TEST_CASE("while no screen shows a wall its time stands still") {
    Theatre theatre({{320, 180}});
    play(theatre, 0s, 5s);
    REQUIRE(is_near(theatre.picture(0), 160, 90, red));

    theatre.stage->set_screens({}, 5s);
    play(theatre, 1h, 1h + 10s);
    CHECK(is_near(theatre.picture(0), 160, 90, red));  // 15 of its 20 seconds

    play(theatre, 1h + 10s, 1h + 25s);
    CHECK(is_near(theatre.picture(0), 160, 90, blue));
}

TEST_CASE("a wall is laid out anew when its largest screen goes, and again when it comes back") {
    Theatre theatre({{320, 180}, {100, 160}});
    play(theatre, 0s, 1s);

    theatre.stage->set_screens({theatre.display.screens()[1]}, 1s);
    for (auto now = 1s; now <= 2s; now += 1s)
        theatre.stage->show(now, &theatre.renderer);
    CHECK_FALSE(is_near(theatre.picture(1), 50, 4, black));  // its own canvas: no bars

    play(theatre, 3s, 4s);
    CHECK(is_near(theatre.picture(1), 50, 4, black));
}

TEST_CASE("another renderer is given the pictures of what plays") {
    Theatre theatre({{320, 180}});
    play(theatre, 0s, 1s);

    theatre.stage->forget_uploads();
    Renderer another(1, 1);
    theatre.stage->show(2s, &another);

    CHECK(is_near(theatre.picture(0), 160, 90, red));
}

TEST_CASE("on a screen of another shape a wall is laid out anew once, in one motion") {
    constexpr auto refresh = 20ms;
    Settings settings = one_photo_at_a_time();
    settings.layout.slots = 2;
    settings.show.motion = 400ms;
    Theatre theatre({{320, 180}, {100, 160}}, settings);
    const auto show_on = [&](std::size_t screen, std::chrono::nanoseconds from, std::chrono::nanoseconds to) {
        std::vector<std::chrono::nanoseconds> moved;  // the times of frames that look different
        for (auto now = from; now < to; now += refresh) {
            const Frame before = theatre.stage->frame();
            theatre.stage->set_screens({theatre.display.screens()[screen]}, now);
            theatre.stage->show(now, &theatre.renderer);
            if (!looks_alike(theatre.stage->frame(), before)) moved.push_back(now);
        }
        return moved;
    };
    show_on(0, 0s, 3s);
    REQUIRE(show_on(0, 3s, 5s).empty());

    const auto moved = show_on(1, 5s, 10s);

    REQUIRE_FALSE(moved.empty());
    CHECK(moved.front() <= 5s + 2 * refresh);
    CHECK(moved.back() - moved.front() <= settings.show.motion + 2 * refresh);
    CHECK(moved.size() == static_cast<std::size_t>((moved.back() - moved.front()) / refresh) + 1);
    CHECK(theatre.stage->frame().canvas == Vec2{100, 160});
    CHECK(theatre.stage->frame().items.size() == 2);
}

TEST_CASE("the screens of a canvas show their parts of one wall, and nothing for the gap between them") {
    Settings settings = one_photo_at_a_time();
    settings.layout.slots = 2;
    settings.output.canvas = "offscreen-1 0,0; offscreen-2 180,0";
    Theatre parts({{160, 180}, {160, 180}}, settings);
    play(parts, 0s, 1s);
    CHECK(parts.stage->frame().canvas == Vec2{340, 180});

    for (const std::size_t number : {0U, 1U})
        for (const int x : {1, 80, 158})
            CHECK_FALSE(is_near(parts.picture(number), x, 90, black));
    for (const int finger : {0, 1}) {
        const Screen& touched = *parts.display.screens()[static_cast<std::size_t>(finger)];
        CHECK(parts.stage->canvas_point(touched, {0.5, 0.5}) == Vec2{80.0 + 180 * finger, 90});
    }
}

TEST_CASE("a box without a screen leads the wall on the screens of other boxes") {
    Settings settings = one_photo_at_a_time();
    settings.show.dwell = 2s;
    settings.wall = {.role = WallRole::lead, .box = "here"};
    settings.output.canvas = "there/DP-1 0,0";
    settings.show.qr = "https://example.org";
    const auto others = std::make_shared<OtherOutputs>();
    Theatre theatre({{160, 90}}, settings, "", others);
    Stage& stage = *theatre.stage;
    stage.set_screens({}, 0s);
    CHECK_FALSE(stage.is_seen());
    others->outputs = {{"there/DP-1", 320, 180, {}}};
    std::set<std::string> told;
    for (auto now = 0ms; now < 12s; now += 200ms) {
        stage.set_screens({}, now);
        REQUIRE(stage.is_seen());
        stage.show(now, nullptr);
        const LedNews news = stage.wall().led()->take_news();
        if (!news.act) continue;
        CHECK(news.act->canvas == Vec2{320, 180});
        CHECK(news.act->words.code == settings.show.qr);
        CHECK(news.act->words.captions == CaptionChoice::written);
        for (const PlacedShot& placed : last_wall(*news.act))
            told.insert(placed.shot.key.path);
    }
    CHECK(told == std::set<std::string>{"a/red.png", "b/blue.png"});
    play(theatre, 12s, 13s);  // now it has a screen, too
    CHECK_FALSE(is_near(theatre.picture(0), 80, 45, black));
}

TEST_CASE("a box that follows draws the words that the leader tells, not its own") {
    const TemporaryDirectory directory;
    Settings settings;
    settings.wall = {.role = WallRole::follow, .box = "there"};
    settings.state.directory = directory.path.string();
    settings.show.share_address = "its own";
    int width = 2;
    for (const char* const words : {"its own", "the leader's"}) {
        width *= 2;
        const std::filesystem::path file = word_picture(directory.path, words);
        std::filesystem::create_directories(file.parent_path());
        save_png({.width = width,
                  .height = 2,
                  .pixels = std::vector<std::byte>(static_cast<std::size_t>(width) * 8)},
                 file);
    }
    OffscreenDisplay display({.screens = {{160, 90}}}, {}, 30);
    Renderer renderer(1, 1);
    SourcePool sources({.media = {}, .store = {}});
    Stage stage(settings, {}, sources);
    stage.wall().followed()->set_clock(0s, true);
    stage.wall().followed()->take(
        {.name = {.run = 1, .generation = 1}, .canvas = {160, 90}, .words = {.share = "the leader's"}});
    const auto screens = display.screens();
    std::vector<WordItem> drawn;
    for (auto now = 0ms; now < 60s && drawn.empty(); now += 100ms) {
        stage.set_screens({screens.begin(), screens.end()}, now);
        stage.show(now, &renderer);
        drawn = stage.frame().words;
        std::this_thread::sleep_for(1ms);
    }
    REQUIRE(drawn.size() == 1);
    CHECK(drawn[0].picture->width == 8);
}

TEST_CASE("a screen that hangs beyond the canvas of a frame shows the idle picture, and never black") {
    Settings settings;
    settings.wall = {.role = WallRole::follow, .box = "there"};
    OffscreenDisplay display({.screens = {{160, 90}, {160, 90}, {160, 90}}}, {}, 30);
    Renderer renderer(1, 1);
    const SourcePool sources({.media = {}, .store = {}});
    ScreenPainter painter(settings, sources);
    const auto screens = display.screens();
    painter.set_screens({screens.begin(), screens.end()}, 0s);
    painter.show_parts({.canvas = {160, 90},
                        .parts = {{"there/offscreen-1", {.box = {{0, 0}, {160, 90}}}},
                                  {"there/offscreen-2", {.box = {{180, 0}, {340, 90}}}},
                                  {"there/offscreen-3", {}}}});
    int drawn = 0;
    std::uint64_t before = 0;
    for (auto now = 0ms; now < 1s; now += 20ms) {
        painter.paint({.canvas = {160, 90}, .is_fade = true, .time = now}, now, &renderer, false);
        const std::uint64_t flips = screens[1]->flips();
        if (std::exchange(before, flips) != flips) ++drawn;
    }
    const auto is_black = [&](std::size_t number) {
        const Picture picture = dynamic_cast<OffscreenScreen&>(*screens[number]).picture();
        return is_near(picture, 20, 20, black) && is_near(picture, 80, 45, black) &&
               is_near(picture, 140, 70, black);
    };
    CHECK(is_black(0));
    CHECK_FALSE(is_black(1));
    CHECK_FALSE(is_black(2));  // it was not there when the act was made
    CHECK(drawn == 10);        // the idle picture moves
}
