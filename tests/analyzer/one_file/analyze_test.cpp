#include "analyzer/one_file/analyze.hpp"
#include "base/state/media_error.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

using namespace vitrine;
using namespace vitrine::analyzer;
using std::chrono::milliseconds;

namespace {

/// A film drawn frame by frame, 25 a second.
class DrawnFilm : public FrameSource {
  public:
    using Draw = std::function<cv::Mat(int)>;

    DrawnFilm(MediaKind kind, int count, Draw draw) : count_(count), draw_(std::move(draw)) {
        info_ = {.kind = kind, .width = 640, .height = 360, .duration = milliseconds(40) * count};
        if (kind == MediaKind::photo) info_.duration = milliseconds(0);
    }

    const MediaInfo& info() const override { return info_; }

    std::optional<FilmFrame> next() override {
        if (next_ == count_) return std::nullopt;
        const int i = next_++;
        return FilmFrame{.picture = draw_(i), .time = milliseconds(40) * i, .finer = {}};
    }

  private:
    MediaInfo info_;
    int count_;
    Draw draw_;
    int next_ = 0;
};

cv::Mat plain(const cv::Scalar& colour) {
    return cv::Mat(180, 320, CV_8UC3, colour);
}

cv::Mat with_disc(const cv::Scalar& background, cv::Point at) {
    cv::Mat picture = plain(background);
    cv::circle(picture, at, 22, cv::Scalar(40, 60, 240), cv::FILLED, cv::LINE_AA);
    return picture;
}

AnalysisSettings without_faces() {
    AnalysisSettings settings;
    settings.face_cascade.clear();
    return settings;
}

/// The disc and, far from it, a line of letters.
cv::Mat with_words(const cv::Scalar& background, cv::Point disc, cv::Rect& words) {
    cv::Mat picture = with_disc(background, disc);
    const cv::Mat before = picture.clone();
    cv::putText(picture, "Gate 17", {204, 160}, cv::FONT_HERSHEY_SIMPLEX, 0.8, cv::Scalar(250, 250, 250), 2,
                cv::LINE_AA);
    cv::Mat changed;
    cv::absdiff(before, picture, changed);
    cv::cvtColor(changed, changed, cv::COLOR_BGR2GRAY);
    words = cv::boundingRect(changed > 16);
    return picture;
}

/// Says if a region in a picture of twice the size holds a rectangle.
bool holds(const Polygon& region, const cv::Rect& part) {
    for (const cv::Point corner : {part.tl(), part.br(), {part.x, part.br().y}, {part.br().x, part.y}})
        if (!is_inside_convex(region, Vec2{2.0 * corner.x, 2.0 * corner.y}, 2)) return false;
    return true;
}

cv::Mat red_disc() {
    cv::Mat picture = with_disc({190, 200, 190}, {230, 110});
    cv::circle(picture, {230, 110}, 40, cv::Scalar(30, 40, 200), cv::FILLED, cv::LINE_AA);
    return picture;
}

}  // namespace

TEST_CASE("the words in a film lie whole in its region, and in a photo that the network looks at") {
    cv::Rect words;
    const auto draw = [&words](int i) { return with_words({60, 90, 40}, {60 + i / 2, 50}, words); };
    AnalysisSettings settings = without_faces();
    DrawnFilm plain_film(MediaKind::film, 75, draw);
    CHECK_FALSE(holds(analyze(plain_film, settings).shots.at(0).region.polygon, words));
    settings.text_model = VITRINE_MODELS "/text_detection.onnx";
    DrawnFilm film(MediaKind::film, 75, draw);
    CHECK(holds(analyze(film, settings).shots.at(0).region.polygon, words));
    settings.saliency_model = VITRINE_MODELS "/u2netp.onnx";
    DrawnFilm photo(MediaKind::photo, 1, draw);
    CHECK(holds(analyze(photo, settings).shots.at(0).region.polygon, words));
}

TEST_CASE(
    "the network looks at a film now and then; where it cannot be read the film keeps its plain regions") {
    const auto draw = [](int) { return red_disc(); };
    AnalysisSettings settings = without_faces();
    DrawnFilm plain_film(MediaKind::film, 75, draw);
    const MediaRecord before = analyze(plain_film, settings);
    CHECK_FALSE(before.shots.at(0).certainty);
    settings.saliency_model = VITRINE_MODELS "/u2netp.onnx";
    settings.looks_at_photos = false;
    DrawnFilm film(MediaKind::film, 75, draw);
    const MediaRecord seen = analyze(film, settings);
    REQUIRE(seen.shots.at(0).certainty);
    CHECK(*seen.shots.at(0).certainty > 0.5);
    CHECK(holds(seen.shots.at(0).region.polygon, {204, 84, 52, 52}));
    DrawnFilm photo(MediaKind::photo, 1, draw);
    CHECK_FALSE(analyze(photo, settings).shots.at(0).certainty);
    settings.saliency_model = "/nowhere.onnx";
    DrawnFilm unseen(MediaKind::film, 75, draw);
    CHECK(analyze(unseen, settings).shots == before.shots);
}

TEST_CASE("the student looks at films and photos at once; a photo that it cannot look at is plain") {
    const auto draw = [](int) { return red_disc(); };
    AnalysisSettings settings = without_faces();
    DrawnFilm plain_photo(MediaKind::photo, 1, draw);
    const MediaRecord plain = analyze(plain_photo, settings);
    settings.is_student = true;
    settings.looks_at_photos = false;
    settings.saliency_model = VITRINE_MODELS "/student.onnx";
    for (const MediaKind kind : {MediaKind::film, MediaKind::photo}) {
        DrawnFilm media(kind, kind == MediaKind::film ? 75 : 1, draw);
        const Shot shot = analyze(media, settings).shots.at(0);
        REQUIRE(shot.certainty);
        CHECK(*shot.certainty > 0.5);
        CHECK(holds(shot.region.polygon, {204, 84, 52, 52}));
        CHECK(area(shot.region.polygon) < 0.8 * area(plain.shots.at(0).region.polygon));
    }
    for (const char* model : {"/nowhere.onnx", VITRINE_MODELS "/face_detection_yunet.onnx"}) {
        settings.saliency_model = model;
        DrawnFilm photo(MediaKind::photo, 1, draw);
        CHECK(analyze(photo, settings).shots == plain.shots);
    }
}

TEST_CASE("a photo has one shot without time, around its subject") {
    DrawnFilm photo(MediaKind::photo, 1, [](int) { return with_disc({200, 190, 180}, {220, 60}); });
    const MediaRecord record = analyze(photo, without_faces());
    CHECK(record.kind == MediaKind::photo);
    CHECK(record.state == MediaState::ready);
    CHECK(record.duration.count() == 0);
    REQUIRE(record.shots.size() == 1);
    CHECK(record.shots[0].duration().count() == 0);
    CHECK(record.shots[0].region.drift == Vec2{});
    for (const Vec2 edge : {Vec2{398, 120}, Vec2{482, 120}, Vec2{440, 78}, Vec2{440, 162}}) {
        CHECK(is_inside_convex(record.shots[0].region.polygon, edge, 6));
    }
}

TEST_CASE("a shot is told as soon as it is over, while most of the film is still to come") {
    int drawn = 0;
    DrawnFilm film(MediaKind::film, 400, [&drawn](int i) {
        drawn = i + 1;
        return with_disc(i < 50 ? cv::Scalar(30, 40, 160) : cv::Scalar(160, 140, 30), {100 + i / 4, 90});
    });
    std::vector<MediaRecord> parts;
    std::vector<int> drawn_at;
    const MediaRecord record = analyze(film, without_faces(), {}, [&](const MediaRecord& part) {
        parts.push_back(part);
        drawn_at.push_back(drawn);
    });
    REQUIRE(record.shots.size() == 2);
    REQUIRE(parts.size() == 2);
    CHECK(record.is_complete);
    CHECK_FALSE(parts[0].is_complete);
    CHECK(parts[0].shots == std::vector{record.shots[0]});
    CHECK(parts[1].shots == std::vector{record.shots[1]});
    CHECK(parts[0].duration == milliseconds(16'000));
    CHECK(drawn_at[0] < 200);
}

TEST_CASE("a cut makes two shots, each around its own subject") {
    DrawnFilm film(MediaKind::film, 50, [](int i) {
        return i < 25 ? with_disc({200, 190, 180}, {80, 90}) : with_disc({20, 90, 20}, {240, 90});
    });
    std::size_t seen = 0;
    const MediaRecord record = analyze(film, without_faces(), [&seen](const ShotEvidence& e) {
        ++seen;
        CHECK(e.frames.size() == 3);
    });
    REQUIRE(record.shots.size() == 2);
    CHECK(seen == 2);
    CHECK(record.duration == milliseconds(2000));
    CHECK(record.shots[0].end == milliseconds(1000));
    CHECK(centroid(record.shots[0].region.polygon).x < 280);
    CHECK(centroid(record.shots[1].region.polygon).x > 360);
}

TEST_CASE("a film of one frame, of two and of nothing but black has a shot with a region") {
    for (const int count : {1, 2, 30}) {
        DrawnFilm film(MediaKind::film, count, [](int) { return plain({0, 0, 0}); });
        const MediaRecord record = analyze(film, without_faces());
        CHECK(record.duration == milliseconds(40) * count);
        REQUIRE(!record.shots.empty());
        CHECK(area(record.shots[0].region.polygon) > 0.08 * 640 * 360);
    }
}

TEST_CASE(
    "black and grey stretches are no shots, and the record tells of them; a title is one, with all words") {
    DrawnFilm film(MediaKind::film, 200, [](int i) {
        if (i < 40 || i >= 160) return with_disc({200, 120, 60}, {80 + i, 90});
        if (i < 80) return plain({0, 0, 0});
        if (i < 120) return plain({128, 128, 128});
        cv::Mat title = plain({20, 20, 20});
        cv::putText(title, "the credits of it", {20, 90}, cv::FONT_HERSHEY_SIMPLEX, 1, {230, 230, 230}, 2);
        return title;
    });
    const MediaRecord record = analyze(film, without_faces());
    REQUIRE(record.shots.size() == 3);
    CHECK(record.shots[0].end == milliseconds(1600));
    CHECK_FALSE(record.shots[0].is_title);
    CHECK(record.shots[1].begin == milliseconds(4800));
    CHECK(record.shots[1].is_title);
    for (const Vec2 end_of_words : {Vec2{44, 170}, Vec2{580, 170}})
        CHECK(is_inside_convex(record.shots[1].region.polygon, end_of_words, 6));
    CHECK(record.between == std::vector{Stretch{milliseconds(1600), milliseconds(4800), StretchKind::plain}});
}

TEST_CASE("a long take is split, no cut, and its empty seconds are no shot") {
    DrawnFilm film(MediaKind::film, 500, [](int i) {
        const int x = i < 150 ? 40 + i : i < 350 ? 190 : 540 - i;
        return with_disc({200, 120, 60}, {x, 90});
    });
    const MediaRecord record = analyze(film, without_faces());
    REQUIRE(record.shots.size() == 2);
    CHECK(record.shots[0].ends_with == ShotEnd::split);
    CHECK(record.shots[1].ends_with == ShotEnd::end);
    CHECK(record.shots[0].end < milliseconds(7500));
    CHECK(record.shots[1].begin > milliseconds(12500));
    CHECK(record.between ==
          std::vector{Stretch{record.shots[0].end, record.shots[1].begin, StretchKind::empty}});
}

TEST_CASE("a source without any frame is an error in the operator's words") {
    DrawnFilm film(MediaKind::film, 0, [](int) { return cv::Mat(); });
    CHECK_THROWS_AS(analyze(film, without_faces()), MediaError);
}

TEST_CASE("every region lies in the part of the picture that its whole shot shows") {
    DrawnFilm film(MediaKind::film, 50, [](int i) { return with_disc({200, 190, 180}, {40 + 4 * i, 90}); });
    const MediaRecord record = analyze(film, without_faces());
    for (const Shot& shot : record.shots) {
        const Polygon allowed = to_polygon(core(record, shot));
        for (const Vec2 p : shot.region.polygon)
            CHECK(is_inside_convex(allowed, p, 1e-3));
    }
}

TEST_CASE("the region of a letterboxed film lies in its picture, and its subject is no other for the bars") {
    const auto disc = [](int i) { return with_disc({200, 190, 180}, {60 + i, 70}); };
    const auto letterboxed = [&](int i) {
        cv::Mat picture = disc(i);
        picture.rowRange(0, 24) = cv::Scalar::all(2);
        picture.rowRange(156, 180) = cv::Scalar::all(2);
        return picture;
    };
    DrawnFilm with(MediaKind::film, 50, letterboxed);
    const MediaRecord record = analyze(with, without_faces());
    REQUIRE(record.shots.size() == 1);
    REQUIRE(record.shots[0].picture);
    CHECK(record.shots[0].picture->min.y >= 48);
    CHECK(record.shots[0].picture->min.y <= 52);
    CHECK(record.shots[0].picture->max.y <= 312);
    const Box box = bounding_box(record.shots[0].region.polygon);
    CHECK(box.min.y >= record.shots[0].picture->min.y - 0.01);
    CHECK(box.max.y <= record.shots[0].picture->max.y + 0.01);
    CHECK(box.area() < 0.5 * record.shots[0].picture->area());

    DrawnFilm without(MediaKind::film, 50, disc);
    CHECK_FALSE(analyze(without, without_faces()).shots.at(0).picture);
}
