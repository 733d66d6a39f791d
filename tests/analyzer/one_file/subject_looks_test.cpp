#include "analyzer/one_file/subject_looks.hpp"

#include "analyzer/one_file/subject_network.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace vitrine::analyzer {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t sample_count = 30;

/// A shot of six seconds on a floor.
/// @param begin, end  of the samples that show a ball, which moves
std::vector<Sample> ball_on_floor(std::size_t begin, std::size_t end) {
    std::vector<Sample> samples(sample_count);
    for (std::size_t i = 0; i < sample_count; ++i) {
        Sample& sample = samples[i];
        sample.time = sample.pair_time = milliseconds(200 * i);
        sample.image = SaliencyMap::zeros(90, 160, CV_32FC1);
        sample.motion = SaliencyMap::zeros(90, 160, CV_32FC1);
        cv::Mat picture(180, 320, CV_8UC3, cv::Scalar(90, 90, 90));
        if (i >= begin && i < end) {
            cv::circle(picture, {160, 90}, 40, cv::Scalar(30, 40, 200), cv::FILLED, cv::LINE_AA);
            cv::circle(sample.motion, {80, 45}, 20, 1, cv::FILLED);
        }
        keep_glance(sample, {picture, {}, 1});
    }
    return samples;
}

/// The samples at which the network has looked and which count.
std::vector<std::size_t> looks_at(std::vector<Sample> samples) {
    AnalysisSettings settings;
    settings.saliency_model = VITRINE_MODELS "/u2netp.onnx";
    SubjectLooks looks(settings, {.kind = MediaKind::film, .width = 1920, .height = 1080});
    looks.look({.begin = milliseconds(0), .end = milliseconds(200 * sample_count)}, samples);
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (!samples[i].subject.empty()) seen.push_back(i);
    return seen;
}

}  // namespace

TEST_CASE("the first and the last look are near the ends of a shot") {
    const std::vector<std::size_t> seen = looks_at(ball_on_floor(0, sample_count));
    REQUIRE(seen.size() >= 2);
    CHECK(seen.front() <= 2);
    CHECK(seen.back() >= sample_count - 3);
}

TEST_CASE("where nothing is to be seen, the network looks at what passes before or after") {
    const std::vector<std::size_t> seen = looks_at(ball_on_floor(11, 17));
    REQUIRE(seen.size() >= 2);
    CHECK(seen.front() == 11);
    CHECK(seen.back() == 16);
}

TEST_CASE("at shots for which no look is left the spare network looks") {
    AnalysisSettings settings;
    settings.saliency_model = VITRINE_MODELS "/u2netp.onnx";
    const auto looked = [&] {
        SubjectLooks looks(settings, {.kind = MediaKind::film, .width = 320, .height = 180});
        int count = 0;
        for (int shot = 0; shot < 5; ++shot) {
            std::vector<Sample> samples = ball_on_floor(0, sample_count);
            looks.look({.begin = milliseconds(200 * sample_count * shot),
                        .end = milliseconds(200 * sample_count * (shot + 1))},
                       samples);
            const bool is_seen =
                std::ranges::any_of(samples, [](const Sample& sample) { return !sample.subject.empty(); });
            count += is_seen ? 1 : 0;
        }
        return count;
    };
    CHECK(looked() < 5);
    settings.spare_model = VITRINE_MODELS "/student.onnx";
    CHECK(looked() == 5);
    settings.saliency_model = "/nowhere.onnx";
    CHECK(looked() == 5);
    settings.spare_model = "/nowhere.onnx";
    CHECK(looked() == 0);
}

}  // namespace vitrine::analyzer
