#pragma once

#include "analyzer/saliency/drift.hpp"
#include "analyzer/saliency/i_region.hpp"
#include "analyzer/saliency/image_saliency.hpp"
#include "analyzer/saliency/motion_contrast.hpp"
#include "analyzer/saliency/saliency_map.hpp"

#include <string>

namespace vitrine::analyzer {

/// The settings that an operator or a comparison with the paper may change; the defaults are shipped.
struct AnalysisSettings {
    int frame_size = 320;        // px, longest side on which motion and contrast are measured
    int samples_per_second = 5;  // frames a second of a film that are searched
    int face_interval = 4;       // samples from one search for faces to the next
    SaliencyWeights weights{.motion = 0.5, .image = 0.5, .face = 0};  // `subject` regards faces by itself
    MotionMethod motion = MotionMethod::background;
    ImageSaliency image = ImageSaliency::subject;
    bool only_prominent_faces = true;  // faces far smaller than the tallest do not count
    bool has_bodies = true;            // S_F counts the body below a face
    DriftMode drift = DriftMode::smallest_area;
    RegionSettings region;
    std::string saliency_model;   // an ONNX file that finds subjects (subject_outline.hpp); "": not used
    bool is_student = false;      // that network is small: it looks at photos at once, and often at films
    std::string spare_model;      // the student's, for shots that a large network does not look at; "": none
    bool looks_at_photos = true;  // asks a large network about photos; films are asked about now and then
    std::string text_model;       // an ONNX file that finds lines of text (line_detector.hpp); "": not used
    int text_interval = 10;       // samples of a film from one search for lines to the next
    std::string face_model;       // YuNet's ONNX file; "": not used
    std::string face_cascade =
        "/usr/share/opencv4/haarcascades/haarcascade_frontalface_alt2.xml";  // "": not used
};

/// The settings that follow chapters 3.2 and 3.3 word by word, for comparison only: contrast to one voted pan
/// over its largest value, contrast to the mean colour, every face found and nothing below it, the line
/// through the half-mass boxes' centres, the hull. Where the paper leaves something open our way stays:
/// drifts are limited so that a common part is left, and the hull keeps to that part and to 12 corners.
inline AnalysisSettings paper_mode() {
    AnalysisSettings settings;
    settings.weights = {};
    settings.motion = MotionMethod::voted_pan;
    settings.image = ImageSaliency::frequency_tuned;
    settings.only_prominent_faces = false;
    settings.has_bodies = false;
    settings.drift = DriftMode::box_centres;
    settings.region.mode = RegionMode::hull;
    settings.region.mass = 0.5;
    settings.region.margin = 0;
    return settings;
}

}  // namespace vitrine::analyzer
