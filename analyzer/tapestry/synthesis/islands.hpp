#pragma once

#include "analyzer/tapestry/synthesis/run_tasks.hpp"

#include <opencv2/core.hpp>

#include <functional>

namespace vitrine::analyzer {

/// Where a place of one picture may be found in another, px.
using PlaceGuess = std::function<cv::Point(cv::Point)>;

/// For each of two pictures a guess of where a place of it is in the other one.
struct PlaceGuesses {
    PlaceGuess to_fine;
    PlaceGuess to_coarse;
};

struct IslandRules {
    int reach = 48;           // px around the guess, within which the best place is looked for at first
    int most_way_back = 4;    // px by which there and back may miss the begin
    int most_bend = 2;        // px by which neighbours may move differently
    int least_area = 2812;    // px of an island, R; source: Video Tapestries 4.3, where it is not given
    double most_cost = 2500;  // mean squared difference a channel value
};

/// Regions of a picture that another one shows as well.
struct Islands {
    cv::Mat number;  // CV_32SC1 of the picture's size: the island's, from 1; 0: of none
    cv::Mat place;   // CV_32SC2: where it is in the other picture, px; meaningless outside islands
};

/// Patches are matched from the one picture to the other and back; those that come back to where they began
/// and move as their neighbours do are joined, and what is joined is an island where it is large enough.
///
/// @param coarse, fine  CV_8UC3, at least a patch wide and tall
/// @param guesses       where the search begins
/// Source: Video Tapestries 4.3, correspondences by Barnes et al. 2009 and coherent regions. Differs: matches
/// have to hold both ways.
Islands find_islands(const cv::Mat& coarse, const cv::Mat& fine, const PlaceGuesses& guesses,
                     const IslandRules& rules = {}, const RunTasks& run = run_in_order);

}  // namespace vitrine::analyzer
