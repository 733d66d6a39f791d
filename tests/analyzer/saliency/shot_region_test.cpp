#include "analyzer/saliency/movers.hpp"
#include "analyzer/saliency/sample_store.hpp"
#include "analyzer/saliency/shot_region.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <array>

using namespace vitrine;
using namespace vitrine::analyzer;
using std::chrono::milliseconds;
using std::chrono::seconds;

namespace {

/// A subject of radius 7 about `at`, px of the map.
Sample sample_with_disc(milliseconds time, Vec2 at) {
    Sample sample{.time = time, .pair_time = time, .faces_time = time};
    sample.image = SaliencyMap::zeros(90, 160, CV_32FC1);
    cv::circle(sample.image, cv::Point2d(at.x, at.y), 7, 1, cv::FILLED);
    return sample;
}

/// Finds a tall face and one a third as tall.
class TwoFaces : public FaceDetector {
  public:
    std::vector<Face> detect(const cv::Mat&) override {
        return {{.box = {{20, 20}, {80, 80}}, .score = 1}, {.box = {{120, 20}, {140, 40}}, .score = 1}};
    }
};

}  // namespace

TEST_CASE("to the paper's letter no stage of ours is left and no face is dropped") {
    const AnalysisSettings letter = paper_mode();
    CHECK(letter.motion == MotionMethod::voted_pan);
    CHECK(letter.image == ImageSaliency::frequency_tuned);
    CHECK(letter.drift == DriftMode::box_centres);
    CHECK(letter.region.mode == RegionMode::hull);
    CHECK(letter.region.mass == 0.5);
    CHECK_FALSE(letter.has_bodies);
    TwoFaces detector;
    const cv::Mat frame = cv::Mat::zeros(90, 160, CV_8UC3);
    CHECK(find_faces(detector, frame, letter.only_prominent_faces).size() == 2);
    CHECK(find_faces(detector, frame, AnalysisSettings{}.only_prominent_faces).size() == 1);
}

TEST_CASE("the finer picture of a frame adds small faces, no large ones and none twice") {
    /// Finds, in a picture of 640 px, the face that is known, one as small and the large one of a dog.
    class Finer : public FaceDetector {
      public:
        std::vector<Face> detect(const cv::Mat&) override {
            return {{.box = {{100, 100}, {140, 150}}, .score = 1},
                    {.box = {{400, 100}, {440, 150}}, .score = 1},
                    {.box = {{100, 50}, {400, 350}}, .score = 1}};
        }
    };

    Finer detector;
    std::vector<Face> faces{{.box = {{25, 25}, {35, 37}}, .score = 0.8}};
    add_small_faces(faces, detector, cv::Mat::zeros(360, 640, CV_8UC3), true);
    REQUIRE(faces.size() == 2);
    CHECK(faces[0].score == 0.8);
    CHECK(faces[1].box.min == Vec2{100, 25});
}

TEST_CASE("motion is measured in the way the settings say") {
    // Given a still texture that is zoomed by 3 %.
    cv::Mat before(180, 320, CV_8UC3);
    cv::RNG random(5);
    random.fill(before, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(before, before, {0, 0}, 2.5);
    cv::normalize(before, before, 0, 255, cv::NORM_MINMAX);
    cv::Mat after;
    cv::warpAffine(before, after, cv::getRotationMatrix2D({160, 90}, 0, 1.03), before.size(),
                   cv::INTER_LINEAR, cv::BORDER_REFLECT);
    const Sample letter = sample_of({after, before, 0.04}, paper_mode());
    const Sample ours = sample_of({after, before, 0.04}, {});
    CHECK(cv::mean(letter.motion)[0] > 2 * cv::mean(ours.motion)[0]);
}

TEST_CASE("the region holds a moving disc at every time of the shot") {
    // Given a disc that moves 25 px of the map a second, and a picture of four times the map.
    std::vector<Sample> samples;
    for (int i = 0; i < 16; ++i)
        samples.push_back(sample_with_disc(milliseconds(125 * i), {50 + 25 * i / 8.0, 45}));
    const ShotEvidence found =
        shot_region(samples, {.begin = seconds(0), .end = seconds(2)}, {160, 90}, {640, 360}, {});
    const IRegion& region = found.shot.region;
    CHECK(region.drift.x == doctest::Approx(100).epsilon(0.05));
    for (int i = 0; i < 16; ++i) {
        const double t = i / 8.0;
        const Vec2 centre{4 * (50.5 + 25 * t), 4 * 45.5};
        const Polygon now = transformed(region.polygon, 1, region.drift * t);
        for (const Vec2 edge : {Vec2{28, 0}, Vec2{-28, 0}, Vec2{0, 28}, Vec2{0, -28}}) {
            CHECK(is_inside_convex(now, centre + edge, 4));
        }
    }
}

TEST_CASE("a subject that runs through the picture is held wherever it is") {
    // Given a salient disc that stays, and a small one that crosses the picture in the first of four seconds.
    std::vector<Sample> samples;
    const auto runner = [](int i) { return Vec2{10 + 20.0 * i, 70}; };
    for (int i = 0; i < 32; ++i) {
        samples.push_back(sample_with_disc(milliseconds(125 * i), {80, 35}));
        samples.back().motion = SaliencyMap::zeros(90, 160, CV_32FC1);
        if (i < 8) cv::circle(samples.back().motion, cv::Point2d(runner(i).x, runner(i).y), 7, 1, cv::FILLED);
    }
    const Polygon region =
        shot_region(samples, {.begin = seconds(0), .end = seconds(4)}, {160, 90}, {160, 90}, {})
            .shot.region.polygon;
    for (int i = 0; i < 8; ++i)
        CHECK(is_inside_convex(region, runner(i), 1));
}

TEST_CASE("what crosses the picture faster than a region can follow is held wherever it is") {
    // Given an empty road on which a car passes from below to above, in 3 of 6 seconds.
    std::vector<Sample> samples;
    const auto place = [](int i) { return 45 - 5.0 * (i - 24); };
    const auto is_seen = [&](int i) { return place(i) > -18 && place(i) < 108; };
    for (int i = 0; i < 48; ++i) {
        samples.push_back(sample_with_disc(milliseconds(125 * i), {80, 45}));
        Sample& sample = samples.back();
        sample.image *= 0.3;
        sample.motion = SaliencyMap::zeros(90, 160, CV_32FC1);
        if (!is_seen(i)) continue;
        for (SaliencyMap* map : {&sample.image, &sample.motion})
            cv::circle(*map, cv::Point2d(70, place(i)), 18, 1, cv::FILLED);
        sample.subject_motion = {0, -40};
    }
    const IRegion region =
        shot_region(samples, {.begin = seconds(0), .end = seconds(6)}, {160, 90}, {160, 90}, {}).shot.region;
    CHECK(region.drift == Vec2{});
    for (int i = 0; i < 48; ++i) {
        CAPTURE(i);
        if (is_seen(i)) CHECK(is_inside_convex(region.polygon, {70, std::clamp(place(i), 4.0, 86.0)}, 1));
    }
    const Shot letter =
        shot_region(samples, {.begin = seconds(0), .end = seconds(6)}, {160, 90}, {160, 90}, paper_mode())
            .shot;
    CHECK(letter.region.drift != Vec2{});  // the paper follows the boxes, wherever that leads
}

TEST_CASE("what overtakes the camera is held wherever it is") {
    // Given a camera that pans over bright discs for 3 seconds, and a small one that runs ahead of it.
    std::vector<Sample> samples;
    const auto runner = [](int i) { return Vec2{12 + 5.6 * i, 75}; };
    for (int i = 0; i < 24; ++i) {
        const double panned = 2.5 * i;
        samples.push_back(sample_with_disc(milliseconds(125 * i), {105 - panned, 40}));
        Sample& sample = samples.back();
        for (const double x : {85.0, 125.0})
            cv::circle(sample.image, cv::Point2d(x - panned, 40), 14, 1, cv::FILLED);
        sample.motion = SaliencyMap::zeros(90, 160, CV_32FC1);
        cv::circle(sample.motion, cv::Point2d(runner(i).x, runner(i).y), 6, 1, cv::FILLED);
        sample.global_motion = {-20, 0};
        sample.subject_motion = {-20, 0};  // of most that is salient
    }
    const IRegion region =
        shot_region(samples, {.begin = seconds(0), .end = seconds(3)}, {160, 90}, {160, 90}, {}).shot.region;
    CHECK(region.drift == Vec2{});
    for (int i = 0; i < 24; ++i) {
        CAPTURE(i);
        CHECK(is_inside_convex(region.polygon, runner(i), 1));
    }
}

TEST_CASE("one flash of motion holds nothing; of many things that move the region holds all") {
    std::vector<Sample> samples;
    for (int i = 0; i < 8; ++i) {
        samples.push_back(sample_with_disc(milliseconds(125 * i), {80, 45}));
        samples.back().motion = SaliencyMap::zeros(90, 160, CV_32FC1);
    }
    cv::circle(samples[3].motion, {20, 20}, 6, 1, cv::FILLED);
    CHECK(movers(samples, seconds(0), {}).empty());
    const std::array<cv::Point, 4> places{cv::Point(12, 12), cv::Point(148, 12), cv::Point(12, 78),
                                          cv::Point(148, 78)};
    for (Sample& sample : samples)
        for (const cv::Point place : places)
            cv::circle(sample.motion, place, 8, 1, cv::FILLED);
    const Polygon region =
        shot_region(samples, {.begin = seconds(0), .end = seconds(1)}, {160, 90}, {160, 90}, {})
            .shot.region.polygon;
    for (const cv::Point place : places)
        CHECK(is_inside_convex(region, {static_cast<double>(place.x), static_cast<double>(place.y)}, 1));
}

TEST_CASE("motion measured across the shot's begin does not count") {
    Sample sample = sample_with_disc(milliseconds(1000), {80, 45});
    sample.pair_time = milliseconds(960);
    sample.motion = SaliencyMap(90, 160, CV_32FC1, cv::Scalar(1));
    const ShotEvidence found =
        shot_region({sample}, {.begin = seconds(1), .end = seconds(2)}, {160, 90}, {160, 90}, {});
    CHECK(found.motion.empty());
}

TEST_CASE("a shot without samples gets the middle of the picture") {
    const ShotEvidence found =
        shot_region({}, {.begin = seconds(1), .end = seconds(2)}, {160, 90}, {320, 180}, {});
    CHECK(is_inside_convex(found.shot.region.polygon, {160, 90}));
    CHECK(area(found.shot.region.polygon) > 0.08 * 320 * 180);
}

TEST_CASE("two hours of one shot keep at most 256 samples, evenly spread") {
    SampleStore store;
    const int count = 2 * 3600 * 8;
    for (int i = 0; i < count; ++i) {
        store.push({.time = milliseconds(125) * i});
        REQUIRE(store.size() <= SampleStore::recent + SampleStore::max_settled);
    }
    const std::vector<Sample> kept = store.pop_samples(seconds(0), milliseconds(125) * count);
    CHECK(kept.size() > 128);
    const auto step = kept[1].time - kept[0].time;
    for (std::size_t i = 1; i < kept.size() - SampleStore::recent; ++i)
        CHECK(kept[i].time - kept[i - 1].time == step);
}

TEST_CASE("samples of a transition go to neither shot, later ones stay") {
    SampleStore store;
    for (int i = 0; i < 10; ++i)
        store.push({.time = milliseconds(100) * i});
    CHECK(store.pop_samples(milliseconds(0), milliseconds(300)).size() == 3);
    CHECK(store.pop_samples(milliseconds(500), milliseconds(900)).size() == 4);
    CHECK(store.size() == 1);
}

TEST_CASE("a line of text beside the subject stays whole; in a film where it is seen twice") {
    const Box line{{100, 70}, {150, 78}};
    const auto held = [&](const IRegion& region) {
        return is_inside_convex(region.polygon, line.min * 4 + Vec2{1, 1}) &&
               is_inside_convex(region.polygon, line.max * 4 - Vec2{1, 1});
    };
    const auto region_of = [](const std::vector<Sample>& samples) {
        return shot_region(samples, {.begin = seconds(0), .end = seconds(2)}, {160, 90}, {640, 360}, {})
            .shot.region;
    };
    std::vector<Sample> samples;
    for (int i = 0; i < 12; ++i) {
        samples.push_back(sample_with_disc(milliseconds(160 * i), {30, 30}));
        samples.back().lines_time = milliseconds(i < 6 ? 0 : 960);
    }
    CHECK_FALSE(held(region_of(samples)));
    for (int i = 6; i < 12; ++i)
        samples[static_cast<std::size_t>(i)].lines = {line};
    CHECK_FALSE(held(region_of(samples)));  // one search of two: a detector errs now and then
    for (Sample& sample : samples)
        sample.lines = {line};
    CHECK(held(region_of(samples)));
}

TEST_CASE("the region of a photo of a page is the page, wherever the network looks") {
    Sample photo = sample_with_disc(milliseconds(0), {130, 20});
    photo.subject = photo.image.clone();
    photo.lines = {{{20, 30}, {90, 40}}, {{20, 44}, {84, 52}}, {{22, 56}, {80, 66}}};
    const ShotEvidence found = shot_region({photo}, {}, {160, 90}, {640, 360}, {});
    CHECK(found.is_page);
    CHECK(found.shot.certainty == 1);
    CHECK(is_inside_convex(found.shot.region.polygon, Vec2{20, 30} * 4 + Vec2{1, 1}));
    CHECK(is_inside_convex(found.shot.region.polygon, Vec2{90, 40} * 4 - Vec2{1, 1}));
    CHECK_FALSE(is_inside_convex(found.shot.region.polygon, Vec2{130, 20} * 4));
    photo.faces = {{.box = {{124, 12}, {136, 26}}}};  // somebody stands before a board
    const ShotEvidence person = shot_region({photo}, {}, {160, 90}, {640, 360}, {});
    CHECK_FALSE(person.is_page);
    for (const Vec2 place : {Vec2{130, 20}, Vec2{22, 32}, Vec2{78, 64}})
        CHECK(is_inside_convex(person.shot.region.polygon, place * 4));
}

TEST_CASE("what the network saw in one sample of a film bounds the region of the shot") {
    std::vector<Sample> samples;
    for (int i = 0; i < 10; ++i) {
        samples.push_back(sample_with_disc(milliseconds(i * 200), {120, 45}));
        cv::circle(samples.back().image, cv::Point(30, 45), 12, 1, cv::FILLED);  // contrast and no thing
    }
    const Shot shot{.begin = seconds(0), .end = seconds(2)};
    const ShotEvidence plain = shot_region(samples, shot, {160, 90}, {640, 360}, {});
    CHECK_FALSE(plain.shot.certainty);
    CHECK(is_inside_convex(plain.shot.region.polygon, Vec2{30, 45} * 4));
    samples[5].subject = SaliencyMap::zeros(90, 160, CV_32FC1);
    cv::circle(samples[5].subject, cv::Point(120, 45), 10, 1, cv::FILLED);
    const ShotEvidence seen = shot_region(samples, shot, {160, 90}, {640, 360}, {});
    REQUIRE(seen.shot.certainty);
    CHECK(*seen.shot.certainty > 0.9);
    CHECK(is_inside_convex(seen.shot.region.polygon, Vec2{120, 45} * 4));
    CHECK_FALSE(is_inside_convex(seen.shot.region.polygon, Vec2{30, 45} * 4));
    CHECK_FALSE(seen.subject.empty());
    // When most of what moves is elsewhere, the network's outline is not enough.
    for (Sample& sample : samples) {
        sample.motion = SaliencyMap::zeros(90, 160, CV_32FC1);
        for (int x = 20; x < 100; x += 10)
            sample.motion(cv::Rect(x, 70, 3, 6)).setTo(1);
    }
    const ShotEvidence doubted = shot_region(samples, shot, {160, 90}, {640, 360}, {});
    CHECK(*doubted.shot.certainty < 0.5);
    CHECK(is_inside_convex(doubted.shot.region.polygon, Vec2{30, 45} * 4));
}
