#pragma once

#include <opencv2/core.hpp>

namespace vitrine::analyzer {

/// The attention that each place of a picture draws: CV_32FC1, of the size of the picture or of the analysis,
/// each value in [0, 1] unless said otherwise (an accumulated map counts up).
using SaliencyMap = cv::Mat;

/// w_M, w_I and w_F of eq. 3.2.
struct SaliencyWeights {
    double motion = 1.0 / 3;
    double image = 1.0 / 3;
    double face = 1.0 / 3;
};

/// S = w_M S_M + w_I S_I + w_F S_F.
///
/// @param motion, image, face  maps of one size in [0, 1]; an empty one counts 0
/// @return  a map of that size in [0, sum of weights]; empty where all three are
/// Source: Dynamic Media Assemblage 3.2, eq. 3.2.
SaliencyMap combined(const SaliencyMap& motion, const SaliencyMap& image, const SaliencyMap& face,
                     const SaliencyWeights& weights);

/// A size times a scale, at least 1 x 1 px.
cv::Size scaled_size(cv::Size size, double scale);

}  // namespace vitrine::analyzer
