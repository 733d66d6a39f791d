#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/sample.hpp"
#include "base/state/record.hpp"

#include <chrono>
#include <vector>

namespace vitrine::analyzer {

/// A frame of a shot for a sheet that explains the region.
struct ShownFrame {
    cv::Mat picture;  // BGR
    std::chrono::nanoseconds time{0};
    std::vector<Face> faces;  // px of the map
    std::vector<Box> lines;   // of text, px of the map
};

/// The evidence that led to the region of one shot, to explain it. Maps are in px of the map.
struct ShotEvidence {
    Shot shot;
    std::vector<ShownFrame> frames;  // first, middle and last sample; none where pictures were not kept
    SaliencyMap motion;              // S_M of the middle sample, empty where it has none
    SaliencyMap image;
    SaliencyMap face;
    SaliencyMap combined;
    SaliencyMap volume;  // S_c, in px of the shot's begin
    std::vector<Face> faces;
    SaliencyMap subject;   // found by the network, in px of the shot's begin; empty where it was not asked
    bool is_page = false;  // the subject is a page of text
    IRegion letter;        // the region in paper_mode(), to compare with; no corners where it is not wanted
    std::size_t samples = 0;
};

/// Finds the region of one shot from its samples, in source px, with its evidence.
///
/// @param samples   the shot's, in time order; motion measured across the shot's begin, and faces and lines
///                  of text found before it are left out
/// @param shot      begin, end, ends_with and picture; its region, which lies in the picture, and its look
/// are filled
/// @param map       the size of the samples' maps, for a shot without any
/// @param source    px of the upright picture
/// Source: Dynamic Media Assemblage 3.2 and 3.3.
ShotEvidence shot_region(std::vector<Sample> samples, Shot shot, cv::Size map, cv::Size source,
                         const AnalysisSettings& settings);

}  // namespace vitrine::analyzer
