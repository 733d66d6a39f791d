#pragma once

#include "analyzer/faces/face_detector.hpp"
#include "analyzer/saliency/saliency_map.hpp"

#include <memory>
#include <span>
#include <string>

namespace vitrine::analyzer {

/// The way in which the saliency of a still picture is found.
enum class ImageSaliency {
    frequency_tuned,  // the paper's: contrast to the picture's mean colour
    barrier,          // not connected to the border, unlike the border, near the centre
    subject,          // likely inside the box around the subject
};

/// Nearness to the centre: 1 there, falling off by a Gaussian of a third of each side.
SaliencyMap centre_prior(cv::Size size);

/// Finds the saliency of one picture. A further way is a further class of this kind.
class ImageSaliencyStage {
  public:
    ImageSaliencyStage() = default;
    ImageSaliencyStage(const ImageSaliencyStage&) = delete;
    ImageSaliencyStage& operator=(const ImageSaliencyStage&) = delete;
    virtual ~ImageSaliencyStage() = default;

    /// @param bgr    CV_8UC3, not empty
    /// @param faces  px of bgr, as far as they are known; a stage need not use them
    /// @return       S_I of that size, in [0, 1]
    virtual SaliencyMap map(const cv::Mat& bgr, std::span<const Face> faces) = 0;
};

/// The stage that the settings ask for.
///
/// @param method  `frequency_tuned`: Dynamic Media Assemblage 3.2. `barrier` follows MB+ of Zhang et al.
/// 2015,
///                worked at 160 px, with the frequency-tuned map as a third cue; all 0 where the picture is
///                flat. `subject`: subject_windows.hpp
std::unique_ptr<ImageSaliencyStage> image_saliency_stage(ImageSaliency method);

}  // namespace vitrine::analyzer
