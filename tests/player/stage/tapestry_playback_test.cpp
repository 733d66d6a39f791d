#include "player/stage/tapestry_playback.hpp"

#include "base/hints/keyframe_choice.hpp"
#include "base/settings/settings.hpp"
#include "base/state/keyframe_notes.hpp"
#include "base/state/wanted_tapestry.hpp"
#include "base/system/atomic_file.hpp"
#include "player/display/offscreen_display.hpp"
#include "player/display/offscreen_screen.hpp"
#include "player/playback/source_pool.hpp"
#include "player/stage/stage.hpp"
#include "tests/player/playback/numbered_film.hpp"
#include "tests/player/scene/tapestry/drawn_tapestry.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Rgb = std::array<int, 3>;

constexpr std::array<Rgb, 4> colours{{{200, 40, 40}, {40, 200, 40}, {40, 40, 200}, {200, 200, 40}}};

Picture plain(int width, int height, const Rgb& colour) {
    Picture picture{.width = width, .height = height, .pixels = {}};
    for (int i = 0; i < width * height; ++i)
        for (const int channel : {colour[0], colour[1], colour[2], 255})
            picture.pixels.push_back(static_cast<std::byte>(channel));
    return picture;
}

/// Each level of one colour.
void write_tiles(const std::filesystem::path& directory, const Tapestry& tapestry) {
    for (std::size_t level = 0; level < tapestry.levels.size(); ++level) {
        for (int tile = 0; tile < tapestry.tiles(level); ++tile) {
            const int width =
                std::min(tapestry.tile_width, tapestry.levels[level].width - tile * tapestry.tile_width);
            const auto file = directory / tapestry.tile_name(level, tile);
            std::filesystem::create_directories(file.parent_path());
            save_png(plain(width, tapestry.height, colours.at(level)), file);
        }
    }
    write_tapestry(directory, tapestry);
}

bool is_near(const Picture& picture, int x, int y, const Rgb& colour) {
    const std::size_t first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>(x)) *
                              4;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(std::to_integer<int>(picture.pixels[first + i]) - colour[i]) > 8) return false;
    return true;
}

MediaRecord grey_photo(const std::string& path = "grey.png") {
    MediaRecord record{.path = path, .state = MediaState::ready, .width = 160, .height = 90};
    record.shots = {Shot{.region = {.polygon = to_polygon(Box{{60, 25}, {100, 65}})}}};
    return record;
}

/// A wall of grey photos, one by default, of each of which there is a tapestry.
struct Theatre {
    explicit Theatre(const Settings& wanted = {}, const std::vector<std::string>& paths = {"grey.png"})
        : settings(wanted), display({.screens = {{320, 180}}}, {}, 30) {
        std::vector<MediaRecord> records;
        for (const std::string& path : paths) {
            std::filesystem::create_directories((directory.path / path).parent_path());
            save_png(plain(160, 90, {120, 120, 120}), directory.path / path);
            write_tiles(tapestry(path), drawn_tapestry());
            records.push_back(grey_photo(path));
        }
        settings.state.directory = directory.path.string();
        settings.layout.max_enlargement = 100;
        settings.input.idle = 20s;
        stage = std::make_unique<Stage>(
            settings, StageOptions{.number = 3, .folder = {}, .awaits_sources = true}, sources);
        stage->set_catalogue(records);
        const auto screens = display.screens();
        stage->set_screens({screens.begin(), screens.end()}, 0s);
    }

    std::filesystem::path tapestry(const std::string& path = "grey.png") const {
        return directory.path / "tapestry" / record_id(path);
    }

    void play(std::chrono::nanoseconds duration) {
        for (const auto end = now + duration; now < end; now += 100ms)
            stage->show(now, &renderer);
    }

    void tap(Vec2 at) {
        stage->handle_input(Contact{.kind = Contact::Kind::down, .at = at, .time = now});
        stage->handle_input(Contact{.kind = Contact::Kind::up, .at = at, .time = now + 50ms});
        now += 100ms;
    }

    /// Taps twice, and lets what that opens come.
    void tap_twice(Vec2 at, std::chrono::nanoseconds duration = 2s) {
        tap(at);
        tap(at);
        play(duration);
    }

    Picture picture() { return dynamic_cast<OffscreenScreen&>(*display.screens()[0]).picture(); }

    TemporaryDirectory directory;
    Settings settings;
    OffscreenDisplay display;
    Renderer renderer{1, 1};
    SourcePool sources{{.media = directory.path.string(), .store = {}}};
    std::unique_ptr<Stage> stage;
    std::chrono::nanoseconds now = 0s;
};

/// Stripes and a ramp, so that it shows where each column and row has gone.
Picture striped(int width, int height, int first, int level) {
    Picture picture{.width = width, .height = height, .pixels = {}};
    for (int y = 0; y < height; ++y)
        for (int x = first; x < first + width; ++x)
            for (const int value : {x * 255 / 2000, (x / 8 + level) % 2 * 120, y * 255 / height, 255})
                picture.pixels.push_back(static_cast<std::byte>(value));
    return picture;
}

/// Where a column's time is on another level.
double elsewhere(const Tapestry& tapestry, std::size_t level, double x, std::size_t other) {
    return tapestry.x_at(other, tapestry.time_at(level, x));
}

void write_zoom(const std::filesystem::path& directory, const Tapestry& tapestry, std::size_t level,
                bool is_to_finer) {
    const std::size_t other = is_to_finer ? level + 1 : level - 1;
    for (int tile = 0; tile < tapestry.tiles(level); ++tile) {
        const int left = tile * tapestry.tile_width;
        ZoomField field{.width = std::min(tapestry.tile_width, tapestry.levels[level].width - left),
                        .height = tapestry.height,
                        .places = {},
                        .growths = {}};
        for (int row = 0; row < ZoomField::rows; ++row) {
            for (int column = 0; column < field.columns(); ++column) {
                const Vec2 point = field.point(column, row);
                field.places.push_back({elsewhere(tapestry, level, left + point.x, other), point.y});
                field.growths.push_back(is_to_finer ? 2 : 0.5);
            }
        }
        replace_file(directory / tapestry.zoom_name(level, tile, is_to_finer), to_bytes(field));
    }
}

struct Projector {
    OffscreenScreen screen{{.width = 320, .height = 180, .film = {}}};
    Renderer renderer{320, 180};
};

/// A tapestry of striped tiles, with zoom fields between the first levels or without.
struct Cinema {
    Cinema(Projector& shown_by, SourceId first, bool has_zoom) : projector(shown_by) {
        Tapestry tapestry = drawn_tapestry(3);
        write_tiles(directory.path, tapestry);
        for (std::size_t level = 0; level < tapestry.levels.size(); ++level)
            for (int tile = 0; tile < tapestry.tiles(level); ++tile) {
                const int left = tile * tapestry.tile_width;
                save_png(striped(std::min(tapestry.tile_width, tapestry.levels[level].width - left),
                                 tapestry.height, left, static_cast<int>(level)),
                         directory.path / tapestry.tile_name(level, tile));
            }
        if (has_zoom) {
            write_zoom(directory.path, tapestry, 0, true);
            write_zoom(directory.path, tapestry, 1, false);
            tapestry.levels[1].has_zoom = true;
        }
        write_tapestry(directory.path, tapestry);
        playback.emplace(directory.path, Vec2{320, 180},
                         TapestryPlaybackOptions{.first_source = first, .awaits_tiles = true, .film = {}});
    }

    Picture picture(std::chrono::nanoseconds later = 16ms) {
        now += later;
        frame = playback->step(now, &projector.renderer).frame;
        projector.screen.begin_frame();
        projector.renderer.draw(frame);
        projector.screen.present(now);
        return projector.screen.picture();
    }

    /// So much nearer, about a place.
    void pinch(double levels) {
        const Tapestry& tapestry = playback->show().tapestry();
        const double ratio = 1.0 * tapestry.levels[1].width / tapestry.levels[0].width;
        playback->handle_gesture({.kind = Gesture::Kind::pinch,
                                  .at = {150, 140},
                                  .from = {150, 140},
                                  .factor = std::pow(ratio, levels)});
    }

    Projector& projector;  // outlives this
    TemporaryDirectory directory;
    std::optional<TapestryPlayback> playback;
    std::chrono::nanoseconds now = 0s;
    Frame frame;
};

/// The greatest difference of a channel on the tapestry, without the film's begin and end: there the edge of
/// the still one is smoothed.
int difference(const Picture& a, const Picture& b) {
    int largest = 0;
    for (std::size_t y = 112; y < 167; ++y)
        for (std::size_t i = (y * 320 + 90) * 4; i < (y * 320 + 230) * 4; ++i)
            largest = std::max(
                largest, std::abs(std::to_integer<int>(a.pixels[i]) - std::to_integer<int>(b.pixels[i])));
    return largest;
}

bool shows_zoom(const Frame& frame) {
    return std::ranges::any_of(frame.items, [](const DrawItem& item) { return item.zoom != nullptr; });
}

}  // namespace

TEST_CASE("a zoom begins and ends with the levels themselves, to the bit, and is near them beside") {
    Projector projector;
    Cinema zoomed(projector, 1, true);
    Cinema faded(projector, SourceId{1} << 45, false);
    const auto both = [&](double levels) {
        zoomed.pinch(levels);
        faded.pinch(levels);
        return std::pair(zoomed.picture(), faded.picture());
    };
    const Picture coarse = zoomed.picture();
    CHECK(difference(coarse, faded.picture()) == 0);

    const auto begun = both(1e-7);
    CHECK(shows_zoom(zoomed.frame));
    CHECK(difference(coarse, begun.first) <= 2);

    const auto between = both(0.5);
    CHECK(difference(between.first, between.second) > 20);

    const auto nearly = both(0.5 - 2e-7);
    CHECK(shows_zoom(zoomed.frame));
    for (Cinema* cinema : {&zoomed, &faded})
        cinema->playback->handle_gesture(
            {.kind = Gesture::Kind::pinch_end, .at = {150, 140}, .from = {150, 140}});
    zoomed.picture();
    faded.picture();
    const Picture fine = zoomed.picture(700ms);
    CHECK(zoomed.playback->show().view().level == 1);
    CHECK_FALSE(shows_zoom(zoomed.frame));
    CHECK(difference(fine, nearly.first) <= 2);
    CHECK(difference(fine, faded.picture(700ms)) == 0);
}

TEST_CASE("while one zooms, a point of a tile is where its two places say") {
    Projector projector;
    Cinema zoomed(projector, 1, true);
    zoomed.picture();
    zoomed.pinch(0.5);
    const Picture between = zoomed.picture();
    const TapestryShow& show = zoomed.playback->show();
    const TapestryPlace place = show.place();
    // Red is the column of both levels; half of it from each at growth 1/2 is as 1 to 2.
    const auto time = show.tapestry().time_at(0, 100);
    const int x = static_cast<int>(place.canvas_x(show.view(), time));
    const double coarse = 100 * 255.0 / 2000;
    const double fine = show.tapestry().x_at(1, time) * 255.0 / 2000;
    const double share = show.view().level;
    const double growth = 0.5;
    const double seen = share / ((1 - share) * growth + share);
    const std::size_t pixel = (std::size_t{140} * 320 + static_cast<std::size_t>(x)) * 4;
    CHECK(std::to_integer<int>(between.pixels[pixel]) ==
          doctest::Approx((1 - seen) * coarse + seen * fine).epsilon(0.12));
}

TEST_CASE("two taps on a film open its tapestry; the wheel goes through its levels, a key back to the wall") {
    Theatre theatre;
    theatre.play(2s);
    REQUIRE(is_near(theatre.picture(), 160, 90, {120, 120, 120}));

    theatre.tap_twice({160, 90});
    CHECK(is_near(theatre.picture(), 160, 140, colours[0]));
    CHECK_FALSE(is_near(theatre.picture(), 160, 60, {120, 120, 120}));

    for (const std::size_t level : {1U, 2U, 3U}) {
        theatre.stage->handle_input(Wheel{.notches = 1, .at = {160, 140}, .time = theatre.now});
        theatre.play(1s);
        CHECK(is_near(theatre.picture(), 160, 140, colours.at(level)));
    }
    theatre.stage->handle_input(Wheel{.notches = -1, .at = {160, 140}, .time = theatre.now});
    theatre.play(400ms);
    CHECK_FALSE(is_near(theatre.picture(), 160, 140, colours[3]));  // between both
    CHECK_FALSE(is_near(theatre.picture(), 160, 140, colours[2]));
    theatre.play(1s);
    CHECK(is_near(theatre.picture(), 160, 140, colours[2]));

    theatre.stage->handle_input(KeyPress{.key = Key::back, .time = theatre.now});
    theatre.play(2s);
    CHECK(is_near(theatre.picture(), 160, 90, {120, 120, 120}));
}

TEST_CASE("two taps open a film's tapestry on a panning wall, too") {
    Settings settings;
    settings.layout.mode = WallMode::pan;
    Theatre theatre(settings);
    theatre.play(2s);
    REQUIRE(is_near(theatre.picture(), 160, 90, {120, 120, 120}));
    theatre.tap_twice({160, 90});
    CHECK(is_near(theatre.picture(), 160, 140, colours[0]));
}

TEST_CASE("two taps on a folder open it; two more on a film in it open its tapestry, and Back leads to the "
          "folder") {
    Settings settings;
    settings.layout.folders = FolderMode::nested;
    Theatre theatre(settings, {"trip/one.png", "trip/two.png", "grey.png"});
    theatre.play(3s);
    const auto tap_twice_on_a_shot_of = [&](const std::string& folder) {
        for (double x = 10; x < 320; x += 10)
            for (double y = 10; y < 180; y += 10) {
                const auto seen = theatre.stage->wall().shot_at({x, y});
                if (!seen || !seen->key.path.starts_with(folder)) continue;
                return theatre.tap_twice({x, y}, 3s);
            }
        FAIL("there is no shot of ", folder);
    };
    const auto is_strip = [&] { return is_near(theatre.picture(), 160, 140, colours[0]); };
    tap_twice_on_a_shot_of("trip/");
    CHECK_FALSE(is_strip());
    CHECK(theatre.stage->wall().opened_folder() == "trip");
    tap_twice_on_a_shot_of("trip/");
    CHECK(is_strip());
    theatre.stage->handle_input(KeyPress{.key = Key::back, .time = theatre.now});
    theatre.play(3s);
    CHECK_FALSE(is_strip());
    CHECK(theatre.stage->wall().opened_folder() == "trip");
}

TEST_CASE("the tapestry of a film that has changed is not shown") {
    Theatre theatre;
    theatre.play(2s);
    MediaRecord changed = grey_photo();
    changed.mtime_ns = 5;
    theatre.stage->set_catalogue(std::vector<MediaRecord>{changed});
    theatre.play(3s);
    theatre.tap_twice({160, 90});
    CHECK(is_near(theatre.picture(), 160, 60, {120, 120, 120}));
}

TEST_CASE("a tapestry gives way to the wall when its film changes") {
    Theatre theatre;
    theatre.play(2s);
    theatre.tap_twice({160, 90});
    REQUIRE_FALSE(is_near(theatre.picture(), 160, 60, {120, 120, 120}));
    theatre.stage->set_catalogue(std::vector<MediaRecord>{grey_photo()});
    theatre.play(2s);
    CHECK_FALSE(is_near(theatre.picture(), 160, 60, {120, 120, 120}));
    MediaRecord changed = grey_photo();
    changed.bytes = 5;
    theatre.stage->set_catalogue(std::vector<MediaRecord>{changed});
    theatre.play(4s);
    CHECK(is_near(theatre.picture(), 160, 60, {120, 120, 120}));
}

TEST_CASE("the second of two taps opens a tapestry while the wall still answers the first one") {
    Theatre theatre;
    theatre.play(2s);
    for (int k = 0; k < 2; ++k) {
        theatre.tap({160, 90});
        theatre.play(100ms);  // in which the wall answers
    }
    theatre.play(1500ms);
    CHECK(is_near(theatre.picture(), 160, 140, colours[0]));
}

TEST_CASE(
    "two taps on a film that is as large as the screen open its tapestry; it is large no more after it") {
    Theatre theatre({}, {"a.png", "b.png", "c.png"});
    theatre.play(3s);
    const Vec2 at = bounding_box(theatre.stage->frame().items[1].cell->parts[0]).centre();
    theatre.tap(at);
    theatre.play(2s);
    CHECK(theatre.stage->frame().items.size() == 4);  // one is large above the wall
    theatre.tap(at);  // lets it return; the second tap makes it large once more
    theatre.play(200ms);
    theatre.tap(at);
    theatre.play(2s);
    REQUIRE(is_near(theatre.picture(), 160, 140, colours[0]));
    theatre.stage->handle_input(KeyPress{.key = Key::back, .time = theatre.now});
    theatre.play(3s);
    CHECK(theatre.stage->frame().items.size() == 3);
}

TEST_CASE("a tapestry that nobody touches gives way to the wall") {
    Theatre theatre;
    theatre.play(2s);
    theatre.tap({160, 90});
    theatre.tap({160, 90});
    theatre.play(15s);
    CHECK_FALSE(is_near(theatre.picture(), 160, 60, {120, 120, 120}));
    theatre.play(10s);
    CHECK(is_near(theatre.picture(), 160, 60, {120, 120, 120}));
}

TEST_CASE(
    "a tile that cannot be read is stood in for by the coarsest level; another renderer gets all anew") {
    Theatre theatre;
    std::filesystem::remove(theatre.tapestry() / drawn_tapestry().tile_name(1, 1));
    theatre.play(1s);
    theatre.tap({160, 90});
    theatre.tap({160, 90});
    theatre.stage->handle_input(KeyPress{.key = Key::nearer, .time = theatre.now});
    theatre.play(2s);
    const auto columns = [&](const Rgb& colour) {
        const Picture picture = theatre.picture();
        int count = 0;
        for (int x = 0; x < 320; ++x)
            count += is_near(picture, x, 140, colour) ? 1 : 0;
        return count;
    };
    const int coarse = columns(colours[0]);
    const int fine = columns(colours[1]);
    CHECK(coarse > 50);
    CHECK(fine > 50);

    theatre.stage->forget_uploads();
    Renderer another(1, 1);
    theatre.stage->show(theatre.now, &another);
    CHECK(columns(colours[0]) == coarse);
    CHECK(columns(colours[1]) == fine);
}

TEST_CASE("no frame waits for tiles, and none is given more than a few") {
    Theatre theatre;
    TapestryPlayback tapestry(theatre.tapestry(), {320, 180}, {.first_source = 1});
    std::size_t largest = 0;
    std::chrono::nanoseconds now = 0s;
    for (std::size_t before = 0; tapestry.show().strips().shown().tiles().size() < 4;
         now += 16ms) {  // ends at the test's timeout
        tapestry.step(now, &theatre.renderer);
        largest = std::max(largest, tapestry.show().strips().shown().tiles().size() - before);
        before = tapestry.show().strips().shown().tiles().size();
    }
    CHECK(largest <= TapestryPlayback::max_uploads);
}

TEST_CASE("a tapestry plays at once, and from the store as soon as the film's record is known") {
    Theatre theatre;
    TapestryPlayback tapestry(theatre.tapestry(), {320, 180}, {.first_source = 1});
    const WallStep first = tapestry.step(0s, &theatre.renderer);
    REQUIRE(first.requests.size() == 1);
    CHECK(first.requests[0].path == "film.mp4");
    CHECK_FALSE(first.requests[0].shot.stored);

    MediaRecord record{.path = "film.mp4", .state = MediaState::ready, .width = 160, .height = 90};
    record.shots = {Shot{.begin = 0s, .end = 60s, .stored = StoredShot{.file = "id/clip"}}};
    tapestry.set_catalogue(std::vector<MediaRecord>{record});
    tapestry.handle_gesture({.kind = Gesture::Kind::key, .key = Key::select});
    const WallStep next = tapestry.step(100ms, &theatre.renderer);
    REQUIRE(next.requests.size() == 1);
    CHECK(next.requests[0].shot.stored);
    CHECK_FALSE(tapestry.is_over());
    tapestry.set_catalogue(std::vector<MediaRecord>{});
    CHECK(tapestry.is_over());
}

TEST_CASE("at the film's end the last picture stands") {
    Theatre theatre;
    constexpr auto length = 4s;
    write_film(theatre.directory.path / "film.mp4",
               {.pictures = 120,
                .rate = 30,
                .chain = "x264enc bframes=0 key-int-max=30 ! video/x-h264,profile=high ! mp4mux"});
    Tapestry film = drawn_tapestry(1);
    film.duration = length;
    write_tiles(theatre.tapestry(), film);
    TapestryPlayback tapestry(theatre.tapestry(), {320, 180},
                              {.first_source = 1, .patience = 60s, .awaits_tiles = true});
    std::vector<int> seen;
    for (std::chrono::nanoseconds now{0}; now < length + 2s; now += 40ms) {
        const WallStep step = tapestry.step(now, &theatre.renderer);
        for (const ShotRequest& request : step.requests)
            theatre.sources.request(request);
        if (!step.requests.empty()) {
            theatre.sources.wait_until_ready(10s);
            for (const ShotRequest& request : step.requests)
                tapestry.source_ready(request.source);
        }
        theatre.sources.wait_for(step.frame, 10s);
        theatre.sources.advance(step.frame);
        for (const DrawItem& item : step.frame.items)
            if (const std::optional<Sample> sample = theatre.sources.sample(item.source))
                seen.push_back(number(*sample));
        std::this_thread::sleep_for(now > length ? 5ms : 0ms);  // its part begins anew behind the scenes
    }
    REQUIRE(seen.size() > 100);
    CHECK(std::ranges::is_sorted(seen));
    CHECK(seen.back() == 119);
}

TEST_CASE("a directory without a tapestry is named") {
    const TemporaryDirectory directory;
    CHECK_THROWS_WITH(TapestryPlayback(directory.path, {320, 180}, {}), doctest::Contains("index.json"));
}

namespace {

/// The film of drawn_tapestry().
RecordList::Record film_record() {
    MediaRecord record{.path = "film.mp4",
                       .kind = MediaKind::film,
                       .state = MediaState::ready,
                       .width = 160,
                       .height = 90,
                       .duration = 60s};
    record.shots = {Shot{.begin = 0s, .end = 60s}};
    return RecordList(std::vector<MediaRecord>{record}).find("film.mp4");
}

/// A visitor has opened a film that is not woven yet.
struct Opened {
    explicit Opened(const std::filesystem::path& wishes_in = {})
        : tapestry(directory.path / "tapestry", {320, 180},
                   {.first_source = 1,
                    .awaits_tiles = true,
                    .film = film_record(),
                    .first_seen = 30s,
                    .awaits_index = true,
                    .wishes_in = wishes_in}) {}

    WallStep play(std::chrono::nanoseconds duration) {
        WallStep last;
        for (const auto end = now + duration; now < end; now += 100ms)
            last = tapestry.step(now, &renderer);
        return last;
    }

    void write(const Tapestry& index) const { write_tiles(directory.path / "tapestry", index); }

    TemporaryDirectory directory;
    TapestryPlayback tapestry;
    Renderer renderer{1, 1};
    std::chrono::nanoseconds now = 0s;
};

}  // namespace

TEST_CASE("a film that is not woven plays at once, and its strip is taken over as soon as there is one") {
    Theatre theatre;  // a context to draw in
    Opened opened;
    const WallStep first = opened.tapestry.step(0s, &opened.renderer);
    REQUIRE(first.requests.size() == 1);
    CHECK(first.requests[0].path == "film.mp4");
    opened.play(3s);
    CHECK_FALSE(opened.tapestry.is_over());

    Tapestry plain = drawn_tapestry(1);
    plain.folder = "tiles-1-first";
    plain.is_complete = false;
    opened.write(plain);
    opened.play(600ms);
    CHECK(opened.tapestry.show().tapestry().folder == "tiles-1-first");
    const auto centre = opened.tapestry.show().view().centre;

    Tapestry better = drawn_tapestry(2);
    better.folder = "tiles-1";
    opened.write(better);
    opened.play(600ms);
    CHECK(opened.tapestry.show().tapestry().folder == "tiles-1");
    CHECK(opened.tapestry.show().tapestry().levels.size() == 2);
    CHECK(std::chrono::abs(opened.tapestry.show().view().centre - centre) < 5s);
    opened.play(20s);
    CHECK_FALSE(opened.tapestry.is_over());
}

TEST_CASE("a film whose tapestry does not come, or is another's, gives way to the wall") {
    Theatre theatre;
    Opened opened;
    Tapestry stale = drawn_tapestry(1);
    stale.bytes = 5;
    opened.write(stale);
    opened.play(TapestryPlayback::max_wait - 1s);
    CHECK_FALSE(opened.tapestry.is_over());
    opened.play(2s);
    CHECK(opened.tapestry.is_over());
}

TEST_CASE("the analyzer hears that a visitor waits, until the tapestry is complete or the visitor goes") {
    Theatre theatre;
    const auto wanted = [&] {
        return wanted_tapestry(theatre.directory.path, std::filesystem::file_time_type::clock::now());
    };
    {
        Opened opened(theatre.directory.path);
        CHECK(wanted() == "film.mp4");
        opened.write(drawn_tapestry(1));
        opened.play(600ms);
        CHECK(wanted().empty());
    }
    {
        const Opened opened(theatre.directory.path);
        CHECK(wanted() == "film.mp4");
    }
    CHECK(wanted().empty());
    const TapestryPlayback complete(theatre.tapestry(), {320, 180},
                                    {.film = film_record(), .wishes_in = theatre.directory.path});
    CHECK(wanted().empty());
}

TEST_CASE(
    "a tap of a technician is noted for the analyzer, who hears that somebody waits; others' taps are not") {
    Theatre theatre;
    const auto& state = theatre.directory.path;
    Tapestry film = drawn_tapestry(1);
    film.path = "film.mp4";
    write_tapestry(theatre.tapestry(), film);
    const auto tap = [&](bool is_edited) {
        TapestryPlayback tapestry(
            theatre.tapestry(), {320, 180},
            {.awaits_tiles = true, .film = film_record(), .wishes_in = state, .edits_keyframes = is_edited});
        tapestry.step(100ms, &theatre.renderer);
        tapestry.handle_gesture({.kind = Gesture::Kind::tap, .at = {160, 120}, .from = {160, 120}});
        tapestry.step(200ms, &theatre.renderer);
        return wanted_tapestry(state, std::filesystem::file_time_type::clock::now());
    };
    CHECK(tap(false).empty());
    CHECK(read_keyframe_notes(state).empty());
    CHECK(tap(true) == "film.mp4");
    REQUIRE(read_keyframe_notes(state).contains("film.mp4"));
    CHECK(read_keyframe_choice(read_keyframe_notes(state).at("film.mp4"), "").choice.struck.size() == 1);
    CHECK(tap(true) == "film.mp4");  // the same picture: it is no longer struck
    CHECK(read_keyframe_notes(state).empty());
}
