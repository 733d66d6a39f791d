#include "analyzer/weave/film_weave.hpp"

#include "analyzer/weave/picture_file.hpp"
#include "analyzer/weave/threads.hpp"
#include "base/catalogue/media_error.hpp"
#include "base/media/still_picture.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <atomic>
#include <stdexcept>

namespace vitrine {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// A ball that crosses one scene after another; or nothing at all.
class DrawnSource : public FrameSource {
  public:
    DrawnSource(cv::Size size, int frames, bool is_black)
        : size_(size), frames_(frames), is_black_(is_black) {
        info_.kind = MediaKind::video;
        info_.width = size.width;
        info_.height = size.height;
        info_.duration = milliseconds(100) * frames;
    }

    const MediaInfo& info() const override { return info_; }

    std::optional<VideoFrame> next() override {
        if (next_ == frames_) return std::nullopt;
        VideoFrame frame{.picture = cv::Mat(size_, CV_8UC3, cv::Scalar::all(0)),
                         .time = milliseconds(100) * next_};
        if (!is_black_) {
            const int scene = next_ / 40;
            frame.picture.setTo(cv::Scalar(scene * 70 % 256, 120, 60));
            cv::circle(frame.picture, {next_ * 7 % size_.width, size_.height / 2}, size_.height / 5,
                       cv::Scalar(20, 220, 240), cv::FILLED);
        }
        ++next_;
        return frame;
    }

  private:
    cv::Size size_;
    int frames_;
    bool is_black_;
    int next_ = 0;
    MediaInfo info_;
};

const RetargetSettings quick{.quality = TileQuality::on_demand};

Tapestry woven(const TemporaryDirectory& folder, FrameSource& source, int most_levels) {
    const Film film = gathered(source, folder.path, nullptr);
    const auto levels = chosen_keyframes(*film.candidates, {.most_levels = most_levels}, run_in_order);
    return write_pyramid(folder.path, {.path = "drawn"}, film, levels, quick, run_in_order);
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
    DrawnSource source({64, 64}, 141, false);
    const Tapestry tapestry = woven(folder, source, 2);
    const Tapestry read = read_tapestry(folder.path);

    CHECK(to_json(read) == to_json(tapestry));
    CHECK(read.is_complete);
    REQUIRE(read.levels.size() == 2);
    CHECK(read.levels[0].keyframes.size() == 24);
    CHECK(read.height == 150);
    CHECK(read.duration == milliseconds(14'100));
    check_tiles(folder.path, read);
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
        chosen_keyframes(*film.candidates, {.most_levels = 2, .is_uniform = true}, run_in_order);
    const cv::Mat sheet = drawn_weave(film, levels, quick, run_in_order);
    const Brickwork coarsest{.keyframes = 24, .brick = film.candidates->brick()};

    CHECK(sheet.size() == cv::Size(coarsest.width(), 150 + 60 + 150));
    CHECK(cv::mean(sheet.rowRange(0, 150))[1] < 240);
    CHECK(cv::mean(sheet.rowRange(155, 205))[1] > 240);
}

TEST_CASE("a film beyond two hours keeps fewer frames a second, and no more memory") {
    const TemporaryDirectory folder;
    Candidates candidates({4, 4}, folder.path, nullptr);
    const cv::Mat picture(4, 4, CV_8UC3, cv::Scalar::all(9));
    for (int i = 0; i < 40'000; ++i)
        candidates.push({.picture = picture, .time = milliseconds(500) * i});
    const auto& frames = candidates.signatures();

    CHECK(frames.size() > 7000);
    CHECK(frames.size() <= 14'400);
    bool is_even = true;
    for (std::size_t i = 1; i < frames.size(); ++i)
        is_even &= frames[i].time - frames[i - 1].time == milliseconds(2000);
    CHECK(is_even);
    CHECK(cv::norm(candidates.keyframe(static_cast<int>(frames.size()) - 1).picture, picture, cv::NORM_INF) ==
          0);
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

}  // namespace vitrine
