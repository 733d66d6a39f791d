#pragma once

#include "analyzer/tapestry/synthesis/run_tasks.hpp"

#include <opencv2/core.hpp>

#include <functional>

namespace vitrine::analyzer {

/// Guesses the place in the other picture that shows a place of this one, px.
using PlaceGuess = std::function<cv::Point(cv::Point)>;

/// The guesses between two pictures, both ways.
struct PlaceGuesses {
    PlaceGuess to_fine;
    PlaceGuess to_coarse;
};

struct IslandRules {
    int reach = 48;          // px around the guess that the first sweep searches
    int max_way_back = 4;    // px by which the way there and back may miss its begin
    int max_bend = 2;        // px by which the motions of neighbours may differ
    int min_area = 2812;     // px of an island: R of Video Tapestries 4.3, which gives no value
    double max_cost = 2500;  // mean squared difference a channel value
};

/// Regions of a picture that another one shows as well.
struct Islands {
    cv::Mat number;  // CV_32SC1 of the picture's size: the island's number, from 1; 0: no island
    cv::Mat place;   // CV_32SC2: the pixel's place in the other picture, px; meaningless outside islands
};

/// Matches the patches of one picture with those of the other, and back. Patches that come back to their
/// begin and move as their neighbours do are joined. A joined region that is large enough is an island.
///
/// @param coarse, fine  CV_8UC3, at least a patch wide and tall
/// @param guesses       the places where the search begins
/// Source: Video Tapestries 4.3, correspondences by Barnes et al. 2009 and coherent regions. Differs: matches
/// have to hold both ways.
Islands find_islands(const cv::Mat& coarse, const cv::Mat& fine, const PlaceGuesses& guesses,
                     const IslandRules& rules = {}, const RunTasks& run = run_in_order);

}  // namespace vitrine::analyzer
