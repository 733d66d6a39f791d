#include "analyzer/tapestry/weave/poster.hpp"

#include "analyzer/tapestry/weave/candidate_writer.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

namespace vitrine::analyzer {
namespace {

/// A film of fine texture: noise that is gone in smaller frames.
class FineSource : public FrameSource {
  public:
    /// @param side  px, longest side of the frames
    FineSource(cv::Size film, int side, int frames) : film_(film), side_(side), frames_(frames) {
        info_.kind = MediaKind::film;
        info_.width = film.width;
        info_.height = film.height;
        info_.duration = std::chrono::seconds(frames);
    }

    const MediaInfo& info() const override { return info_; }

    std::optional<FilmFrame> next() override {
        if (next_ == frames_) return std::nullopt;
        cv::Mat whole(film_, CV_8UC3);
        cv::RNG chance(static_cast<std::uint64_t>(next_) + 1);
        chance.fill(whole, cv::RNG::UNIFORM, 60, 200);
        cv::GaussianBlur(whole, whole, {}, 0.8);
        FilmFrame frame{.picture = whole, .time = std::chrono::seconds(next_++)};
        if (side_ < film_.width)
            cv::resize(whole, frame.picture, {side_, film_.height * side_ / film_.width}, 0, 0,
                       cv::INTER_AREA);
        return frame;
    }

  private:
    cv::Size film_;
    int side_;
    int frames_;
    int next_ = 0;
    MediaInfo info_;
};

const cv::Size film_size(240, 180);

struct DrawnPosters {
    TemporaryDirectory folder;
    Film kept;

    explicit DrawnPosters(int frames) {
        FineSource source(film_size, 120, frames);
        kept = gathered(source, folder.path, nullptr);
    }

    Poster poster(const Keyframes& level, int height) const {
        const SharpFrames size = poster_frames(*kept.candidates, height, level.size());
        CandidateWriter writer(nameless_file(folder.path), CandidateWriter::two_hours, size.brick_height);
        FineSource again(film_size, size.frame_size, 9);
        read_sharp_frames(again, *kept.candidates, level,
                          [&](const FilmFrame& frame) { writer.push(frame); });
        const cv::Rect active = active_in(*kept.candidates, writer.frame());
        const Film sharp = film_of(writer.finish(kept.candidates->film(), {}, active), nullptr);
        return drawn_poster(sharp, sharp_levels({level}).front(), height, run_in_order);
    }
};

/// The mean strength of edges.
double sharpness(const cv::Mat& picture) {
    cv::Mat edges;
    cv::Laplacian(picture, edges, CV_32F);
    cv::Scalar mean, spread;
    cv::meanStdDev(edges, mean, spread);
    return spread[0];
}

}  // namespace

TEST_CASE("a poster is as tall as asked, of frames as large as it needs or as the film is") {
    const DrawnPosters drawn(9);
    CHECK(poster_frames(*drawn.kept.candidates, 240, 4).brick_height == 160);
    CHECK(poster_frames(*drawn.kept.candidates, 241, 4).brick_height == 162);
    CHECK(poster_frames(*drawn.kept.candidates, 2000, 4).brick_height == 180);
    CHECK(poster_frames(*drawn.kept.candidates, 2000, 4).frame_size == 240);
    CHECK(poster_frames(*drawn.kept.candidates, 160, 1).brick_height == 160);

    for (const int height : {121, 122, 123}) {
        CAPTURE(height);
        const Poster poster = drawn.poster({1, 5}, height);
        CHECK(poster.picture.rows == height);
        CHECK(poster.enlargement == 1);
    }
}

TEST_CASE("a poster is woven of the film's frames, not of the small ones that were kept") {
    const DrawnPosters drawn(9);
    const Poster poster = drawn.poster({1, 5}, 225);
    CHECK(poster.picture.rows == 225);
    CHECK(poster.enlargement == 1);
    const Poster enlarged = drawn_poster(drawn.kept, {1, 5}, 225, run_in_order);
    CHECK(enlarged.picture.rows == 225);
    CHECK(enlarged.enlargement == doctest::Approx(1.5));
    MESSAGE("sharpness: ", sharpness(poster.picture), ", enlarged: ", sharpness(enlarged.picture));
    CHECK(sharpness(poster.picture) > 1.8 * sharpness(enlarged.picture));
}

TEST_CASE("a poster that is taller than its film's frames allow tells how much they are enlarged") {
    const DrawnPosters drawn(9);
    const Poster poster = drawn.poster({1, 5}, 405);
    CHECK(poster.picture.rows == 405);
    CHECK(poster.enlargement == doctest::Approx(1.5));  // bricks of 180 px make 270
    CHECK(poster.picture.cols == doctest::Approx(1.5 * 360).epsilon(0.01));
}

TEST_CASE("a single keyframe is a poster by itself, and is not enlarged where the film is as tall") {
    const DrawnPosters drawn(1);
    const Poster poster = drawn.poster({0}, 180);
    CHECK(poster.picture.size() == cv::Size(240, 180));
    CHECK(poster.enlargement == 1);
}

}  // namespace vitrine::analyzer
