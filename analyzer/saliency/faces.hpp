#pragma once

#include "analyzer/saliency/face_detector.hpp"
#include "analyzer/saliency/saliency_map.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vitrine {

/// The better detector of those whose file is named; null where both names are empty.
///
/// @param model    YuNet's ONNX file, or ""
/// @param cascade  a Viola-Jones cascade in XML, used where there is no model, or ""
/// @throws std::runtime_error if the file to be used cannot be read
std::unique_ptr<FaceDetector> face_detector(const std::string& model, const std::string& cascade);

/// Face saliency: each face's Gaussian of half its width and height, the highest where several reach.
///
/// @param faces  in px of `size` times `scale`
/// @param scale  px of the searched picture per px of the map
/// @return       S_F of `size`; all 0 without faces
/// Source: Dynamic Media Assemblage 3.2, "a Gaussian attenuation function surrounding the detected faces".
SaliencyMap face_saliency(std::span<const Face> faces, cv::Size size, double scale);

/// The whole head of a face, with hair, chin and some neck: a box around eyes and mouth alone cuts heads off.
Box head_of(const Face& face);

}  // namespace vitrine
