#include "analyzer/saliency/image_saliency.hpp"

#include "analyzer/saliency/barrier_distance.hpp"
#include "analyzer/saliency/frequency_tuned.hpp"
#include "analyzer/saliency/subject_windows.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {
namespace {

constexpr double working_side = 160;  // px, longest side
constexpr double flat = 15;           // Lab units, summed over channels: a smaller barrier does not stand out
constexpr double barrier_share = 0.5;
constexpr double border_share = 0.3;
constexpr double tuned_share = 0.2;
constexpr double centre_sigma = 0.33;  // share of each side
constexpr double sigmoid_slope = 10;   // MB+
constexpr double smoothing = 0.02;     // share of the longest side

/// Scales a map so that its maximum is 1; by no more than 1 / `min_maximum`.
void normalise(cv::Mat& map, double min_maximum) {
    double highest = 0;
    cv::minMaxLoc(map, nullptr, &highest);
    map /= std::max(highest, min_maximum);
}

/// Drives a map to 0 and 1 about its middle.
void sharpen(cv::Mat& map) {
    map.forEach<float>([](float& value, const int*) {
        value = static_cast<float>(1 / (1 + std::exp(-sigmoid_slope * (static_cast<double>(value) - 0.5))));
    });
}

SaliencyMap barrier_saliency(const cv::Mat& bgr) {
    const double scale = std::min(1.0, working_side / std::max(bgr.cols, bgr.rows));
    cv::Mat small;
    cv::resize(bgr, small, scaled_size(bgr.size(), scale), 0, 0, cv::INTER_AREA);
    const cv::Mat colours = lab(small);
    cv::Mat smooth;
    cv::GaussianBlur(colours, smooth, {0, 0},
                     std::max(0.5, smoothing * std::max(small.cols, small.rows) / 3));
    cv::Mat barrier = barrier_distance(smooth);
    double strongest = 0;
    cv::minMaxLoc(barrier, nullptr, &strongest);
    if (strongest < flat) return SaliencyMap::zeros(bgr.size(), CV_32FC1);
    normalise(barrier, flat);
    cv::Mat map = barrier * barrier_share + border_contrast(smooth) * border_share +
                  frequency_tuned(smooth) * tuned_share;
    map = map.mul(centre_prior(map.size()));
    normalise(map, 1e-6);
    sharpen(map);
    SaliencyMap result;
    cv::resize(map, result, bgr.size(), 0, 0, cv::INTER_LINEAR);
    return result;
}

class FrequencyTunedStage : public ImageSaliencyStage {
  public:
    SaliencyMap map(const cv::Mat& bgr, std::span<const Face> /*faces*/) override {
        return frequency_tuned(lab(bgr));
    }
};

class BarrierStage : public ImageSaliencyStage {
  public:
    SaliencyMap map(const cv::Mat& bgr, std::span<const Face> /*faces*/) override {
        return barrier_saliency(bgr);
    }
};

class SubjectStage : public ImageSaliencyStage {
  public:
    SaliencyMap map(const cv::Mat& bgr, std::span<const Face> faces) override {
        return subject_likelihood(bgr, faces);
    }
};

}  // namespace

SaliencyMap centre_prior(cv::Size size) {
    const auto bell = [](int count) {
        cv::Mat values(count, 1, CV_32FC1);
        for (int i = 0; i < count; ++i) {
            const double z = ((i + 0.5) / count - 0.5) / centre_sigma;
            values.at<float>(i) = static_cast<float>(std::exp(-z * z / 2));
        }
        return values;
    };
    return bell(size.height) * bell(size.width).t();
}

std::unique_ptr<ImageSaliencyStage> image_saliency_stage(ImageSaliency method) {
    switch (method) {
    case ImageSaliency::frequency_tuned:
        return std::make_unique<FrequencyTunedStage>();
    case ImageSaliency::barrier:
        return std::make_unique<BarrierStage>();
    case ImageSaliency::subject:
        break;
    }
    return std::make_unique<SubjectStage>();
}

}  // namespace vitrine::analyzer
