#include "analyzer/tapestry/weave/film_weave.hpp"

#include "analyzer/tapestry/weave/woven_sheet.hpp"

#include "analyzer/tapestry/weave/level_files.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"
#include "analyzer/tapestry/weave/threads.hpp"
#include "base/media/still_picture.hpp"
#include "base/state/media_error.hpp"
#include "base/system/atomic_file.hpp"
#include "tests/analyzer/tapestry/weave/drawn_source.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <atomic>
#include <functional>
#include <stdexcept>
#include <utility>

namespace vitrine::analyzer {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const RetargetSettings quick{.quality = TileQuality::on_demand};

Tapestry woven(const TemporaryDirectory& folder, FrameSource& source, int max_levels) {
    const Film film = gathered(source, folder.path, nullptr);
    const auto levels =
        chosen_keyframes(*film.candidates, {.max_levels = max_levels, .is_uniform = true}, run_in_order);
    return PyramidWriter(folder.path, film, {.retarget = quick}, run_in_order)
        .write({.path = "drawn"}, {.folder = new_tile_folder(folder.path), .levels = levels});
}

/// Every tile is there, is a picture, and all together are as wide as the level.
void check_tiles(const std::filesystem::path& folder, const Tapestry& tapestry) {
    for (std::size_t level = 0; level < tapestry.levels.size(); ++level) {
        int width = 0;
        for (int tile = 0; tile < tapestry.tiles(level); ++tile) {
            const StillPicture picture =
                load_still((folder / tapestry.tile_name(level, tile)).string(), 4000, 4000);
            CHECK(picture.height == tapestry.height);
            width += picture.width;
        }
        CHECK(width == tapestry.levels[level].width);
    }
}

}  // namespace

TEST_CASE("a film is woven into levels of tiles, and an index that says what there is") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 64}, 301, false);
    const Tapestry tapestry = woven(folder, source, 2);
    const Tapestry read = read_tapestry(folder.path);

    CHECK(to_json(read) == to_json(tapestry));
    CHECK(read.is_complete);
    REQUIRE(read.levels.size() == 2);
    CHECK(read.levels[0].keyframes.size() == 24);
    CHECK(read.height == 150);
    CHECK(read.duration == milliseconds(30'100));
    check_tiles(folder.path, read);
}

TEST_CASE("a tapestry keeps the film's frames, two a second, and a picture of the digits") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 64}, 141, false);
    (void)woven(folder, source, 1);
    const Tapestry read = read_tapestry(folder.path);

    REQUIRE(read.kept.times.size() == 29);
    CHECK(read.kept.times[3] == milliseconds(1500));
    CHECK(read.kept.sheets() == 2);
    DrawnSource again({64, 64}, 141, false);
    const Film film = gathered(again, folder.path, nullptr);
    for (const int frame : {0, 5, 28}) {
        CAPTURE(frame);
        const StillPicture sheet =
            load_still((folder.path / read.sheet_name(frame / 16)).string(), 4000, 4000);
        CHECK(sheet.width == read.kept.width * 4);
        cv::Mat small;
        cv::resize(film.candidates->picture(frame), small, {read.kept.width, read.kept.height}, 0, 0,
                   cv::INTER_AREA);
        const int x = frame % 16 % 4 * read.kept.width + read.kept.width / 2;
        const int y = frame % 16 / 4 * read.kept.height + read.kept.height / 2;
        const auto at = static_cast<std::size_t>(4 * (y * sheet.width + x));
        const auto& wanted = small.at<cv::Vec3b>(read.kept.height / 2, read.kept.width / 2);
        for (std::size_t channel = 0; channel < 3; ++channel)
            CHECK(std::abs(std::to_integer<int>(sheet.pixels[at + channel]) -
                           wanted[static_cast<int>(2 - channel)]) < 24);
    }
    REQUIRE(read.digits.width > 0);
    const StillPicture digits = load_still((folder.path / read.digits_name()).string(), 4000, 4000);
    CHECK(digits.width == 11 * read.digits.width);
    for (int digit = 0; digit < 11; ++digit) {
        int bright = 0;
        for (int y = 0; y < digits.height; ++y)
            for (int x = digit * read.digits.width; x < (digit + 1) * read.digits.width; ++x)
                bright += std::to_integer<int>(
                              digits.pixels[static_cast<std::size_t>(4 * (y * digits.width + x))]) > 128;
        CHECK(bright > 10);
    }
}

TEST_CASE("a second weaving leaves only its own tiles") {
    const TemporaryDirectory folder;
    DrawnSource first({64, 48}, 20, false);
    DrawnSource second({64, 48}, 20, true);
    (void)woven(folder, first, 1);
    const Tapestry tapestry = woven(folder, second, 1);

    int entries = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path)) {
        ++entries;
        const std::string name = entry.path().filename().string();
        CHECK((name == "index.json" || name == tapestry.folder));
    }
    CHECK(entries == 2);
    check_tiles(folder.path, read_tapestry(folder.path));
}

TEST_CASE("films of one frame, of two seconds, black, very wide or very tall are woven") {
    struct Shape {
        cv::Size size;
        int frames;
        bool is_black;
    };

    for (const Shape& shape : {Shape{{64, 48}, 1, false}, Shape{{64, 48}, 20, true},
                               Shape{{300, 5}, 6, false}, Shape{{6, 300}, 11, false}}) {
        CAPTURE(shape.size.width);
        CAPTURE(shape.frames);
        const TemporaryDirectory folder;
        DrawnSource source(shape.size, shape.frames, shape.is_black);
        const Tapestry tapestry = woven(folder, source, 32);
        check_tiles(folder.path, tapestry);
        CHECK(tapestry.levels.back().keyframes.size() == static_cast<std::size_t>((shape.frames + 4) / 5));
    }
}

TEST_CASE("a film of three scenes has a keyframe of each, and no more than they tell") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 64}, 120, false);
    const Film film = gathered(source, folder.path, nullptr);
    const Keyframes first = chosen_keyframes(*film.candidates, {.max_levels = 1}, run_in_order)[0];
    CHECK(first.size() >= 3);
    CHECK(first.size() < film.candidates->signatures().size());
    for (int scene = 0; scene < 3; ++scene)
        CHECK(std::ranges::any_of(first, [&](int frame) { return frame / 8 == scene; }));
}

TEST_CASE("chosen moments are keyframes of each level, and there are none beside struck ones") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 64}, 120, false);
    const Film film = gathered(source, folder.path, nullptr);
    const auto levels_with = [&](const KeyframeChoice& chosen) {
        return chosen_keyframes(*film.candidates, {.chosen = chosen}, run_in_order);
    };
    const auto time_of = [&](int frame) {
        return film.candidates->signatures()[static_cast<std::size_t>(frame)].time;
    };
    const std::vector<Keyframes> usual = levels_with({});
    const Keyframes neighbours{2, 3, 4};  // too like each other to be chosen by what they show
    REQUIRE_FALSE(std::ranges::includes(usual[0], neighbours));
    KeyframeChoice wanted;
    for (const int frame : neighbours)
        wanted.keyframes.push_back(time_of(frame));
    for (const Keyframes& level : levels_with(wanted))
        CHECK(std::ranges::includes(level, neighbours));

    const KeyframeChoice struck{.struck = {time_of(usual[0].front())}};
    for (const Keyframes& level : levels_with(struck))
        for (const int frame : level)
            CHECK(std::chrono::abs(time_of(frame) - struck.struck[0]) > strike_reach);

    KeyframeChoice only = wanted;
    only.is_only = true;
    CHECK(levels_with(only)[0] == neighbours);
}

TEST_CASE("a film without a picture is an error") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 48}, 0, false);
    CHECK_THROWS_AS(gathered(source, folder.path, nullptr), MediaError);
}

TEST_CASE("the sheet shows the levels below each other") {
    const TemporaryDirectory folder;
    DrawnSource source({48, 64}, 301, false);
    const Film film = gathered(source, folder.path, nullptr);
    const auto levels =
        chosen_keyframes(*film.candidates, {.max_levels = 2, .is_uniform = true}, run_in_order);
    const cv::Mat sheet = drawn_weave(film, levels, quick, run_in_order);
    const Brickwork coarsest{.keyframes = 24, .brick = film.candidates->brick()};

    CHECK(sheet.size() == cv::Size(coarsest.width(), 150 + 60 + 150));
    CHECK(cv::mean(sheet.rowRange(0, 150))[1] < 240);
    CHECK(cv::mean(sheet.rowRange(155, 205))[1] > 240);
}

TEST_CASE("a weaving that was cut off leaves what is whole, and is gone on with to the same tapestry") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 48}, 46, false);
    const Film film = gathered(source, folder.path, nullptr);
    const WeavePlan plan{.folder = "tiles-1", .levels = {{0, 4}, {0, 2, 3, 4}, {0, 1, 2, 3, 4, 5}}};
    const auto weave = [&](const std::filesystem::path& into, const RunTasks& run) {
        return PyramidWriter(into, film, {.retarget = quick}, run).write({.path = "drawn", .bytes = 7}, plan);
    };
    int runs = 0;
    const auto counted = [&](int count, const std::function<void(int)>& task) {
        ++runs;
        run_in_order(count, task);
    };
    const Tapestry whole = weave(folder.path / "whole", counted);
    const int all = std::exchange(runs, 0);
    CHECK_THROWS_WITH(weave(folder.path / "cut",
                            [&](int count, const std::function<void(int)>& task) {
                                if (runs > all / 2) throw std::runtime_error("killed");
                                counted(count, task);
                            }),
                      "killed");

    const Tapestry part = read_tapestry(folder.path / "cut");
    REQUIRE(part.levels.size() < 3);
    REQUIRE(part.levels.size() > 0);
    CHECK_FALSE(part.is_complete);
    check_tiles(folder.path / "cut", part);
    const auto first = folder.path / "cut" / part.tile_name(0, 0);
    std::filesystem::last_write_time(first, {});
    runs = 0;
    CHECK(to_json(weave(folder.path / "cut", counted)) == to_json(whole));
    CHECK(runs < all);
    CHECK(std::filesystem::last_write_time(first) == std::filesystem::file_time_type{});
    for (std::size_t level = 0; level < 3; ++level)
        CHECK(read_file(folder.path / "cut" / whole.tile_name(level, 0)) ==
              read_file(folder.path / "whole" / whole.tile_name(level, 0)));
}

TEST_CASE("a tapestry that may take few bytes has its coarse levels only") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 48}, 46, false);
    const Film film = gathered(source, folder.path, nullptr);
    const WeavePlan plan{.folder = "tiles-1", .levels = {{0, 4}, {0, 2, 3, 4}, {0, 1, 2, 3, 4, 5}}};
    const auto levels = [&](std::uint64_t max_bytes) {
        return PyramidWriter(folder.path, film, {.retarget = quick, .max_bytes = max_bytes}, run_in_order)
            .write({}, plan)
            .levels.size();
    };
    CHECK(levels(1) == 1);
    CHECK(levels(1 << 20) == 3);
}

TEST_CASE("a level has the same files wherever its weaving is cut off") {
    const Brickwork brickwork{.keyframes = 60, .brick = {100, 8}};
    const std::vector<TileSpan> spans = tile_spans(brickwork.width(), brickwork.brick.height);
    const int overlap = tile_overlap(brickwork.brick.height);
    REQUIRE(spans.size() > 6);
    cv::Mat strip(12, brickwork.width(), CV_8UC3);
    cv::randu(strip, 0, 255);
    Tapestry tapestry{.folder = "tiles-1", .height = 12, .tile_width = 128, .brick_width = 100, .levels = {}};
    tapestry.levels.push_back({.width = brickwork.width(), .keyframes = {}});
    /// Hands over the first `until` tiles, as weave_level() does.
    const auto weave = [&](const std::filesystem::path& folder, std::size_t until) {
        LevelFiles files(folder, tapestry, 0, brickwork);
        const std::size_t from = files.done().tiles;
        if (from > 0) {
            const cv::Mat border = strip.colRange(spans[from].from, spans[from].from + overlap);
            CHECK(cv::norm(files.done().border, border, cv::NORM_INF) == 0);
        }
        for (std::size_t i = from; i < until; ++i) {
            const bool is_last = i + 1 == spans.size();
            const int to = is_last ? spans[i].to : spans[i].to - overlap;
            files.add(strip.colRange(spans[i].from, to),
                      {.tiles = i + 1, .border = strip.colRange(to, spans[i].to).clone()});
        }
        if (until < spans.size()) return from;
        files.finish();
        files.remove_note();
        return from;
    };
    const TemporaryDirectory whole;
    (void)weave(whole.path, spans.size());
    for (const std::size_t cut : {1, 4, 6}) {
        CAPTURE(cut);
        const TemporaryDirectory folder;
        (void)weave(folder.path, cut);
        CHECK(weave(folder.path, spans.size()) == cut / 4 * 4);
        int files = 0;
        for (int tile = 0; tile < tapestry.tiles(0); ++tile)
            CHECK(read_file(folder.path / tapestry.tile_name(0, tile)) ==
                  read_file(whole.path / tapestry.tile_name(0, tile)));
        for ([[maybe_unused]] const auto& file :
             std::filesystem::directory_iterator(folder.path / "tiles-1/0"))
            ++files;
        CHECK(files == tapestry.tiles(0));
    }
}

TEST_CASE("a picture that cannot be written is named") {
    CHECK_THROWS_WITH(write_png("/nowhere/at/all.png", cv::Mat(2, 2, CV_8UC3, cv::Scalar::all(1))),
                      doctest::Contains("/nowhere/at/all.png"));
}

TEST_CASE("tasks run once each on all threads, and what one throws comes out") {
    std::atomic<int> sum{0};
    threaded(4)(100, [&](int i) { sum += i; });
    CHECK(sum == 4950);
    CHECK_THROWS_WITH(threaded(3)(10,
                                  [](int i) {
                                      if (i == 7) throw std::runtime_error("seven");
                                  }),
                      "seven");
}

}  // namespace vitrine::analyzer
