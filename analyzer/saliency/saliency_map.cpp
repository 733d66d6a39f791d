#include "analyzer/saliency/saliency_map.hpp"

#include <algorithm>

namespace vitrine::analyzer {

SaliencyMap combined(const SaliencyMap& motion, const SaliencyMap& image, const SaliencyMap& face,
                     const SaliencyWeights& weights) {
    SaliencyMap sum;
    const auto add = [&sum](const SaliencyMap& map, double weight) {
        if (map.empty()) return;
        if (sum.empty()) sum = SaliencyMap::zeros(map.size(), CV_32FC1);
        cv::scaleAdd(map, weight, sum, sum);
    };
    add(motion, weights.motion);
    add(image, weights.image);
    add(face, weights.face);
    return sum;
}

cv::Size scaled_size(cv::Size size, double scale) {
    return {std::max(1, cvRound(size.width * scale)), std::max(1, cvRound(size.height * scale))};
}

}  // namespace vitrine::analyzer
