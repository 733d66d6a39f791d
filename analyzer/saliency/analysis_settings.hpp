#pragma once

#include "analyzer/saliency/i_region.hpp"
#include "analyzer/saliency/image_saliency.hpp"
#include "analyzer/saliency/saliency_map.hpp"
#include "analyzer/saliency/salient_volume.hpp"

#include <string>

namespace vitrine {

/// What an operator or a comparison with the paper may turn; the defaults are what is shipped.
struct AnalysisSettings {
    int frame_size = 320;        // px, longest side on which motion and contrast are measured
    int samples_per_second = 8;  // frames a second of a film that are searched for what matters
    int face_interval = 4;       // every so many samples faces are looked for
    SaliencyWeights weights;
    ImageSaliency image = ImageSaliency::barrier;
    bool has_bodies = true;  // whether S_F counts the body below a face
    DriftMode drift = DriftMode::smallest_area;
    RegionSettings region;
    std::string face_model;  // YuNet's ONNX file; "": not used
    std::string face_cascade =
        "/usr/share/opencv4/haarcascades/haarcascade_frontalface_alt2.xml";  // "": not used
};

/// Chapter 3 to its letter as far as it goes: for comparison only.
inline AnalysisSettings papers_letter() {
    AnalysisSettings settings;
    settings.image = ImageSaliency::frequency_tuned;
    settings.has_bodies = false;
    settings.drift = DriftMode::box_centres;
    settings.region.mode = RegionMode::hull;
    settings.region.margin = 0;
    return settings;
}

}  // namespace vitrine
