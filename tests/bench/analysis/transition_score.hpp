#pragma once

#include "analyzer/video/transition.hpp"

#include <string>
#include <vector>

namespace vitrine {

/// What one film's transitions truly are, in stream time.
struct Truth {
    std::string file;
    double fps = 25;
    std::vector<Transition> transitions;
    std::vector<Transition> ignored;  // ranges in which nothing is judged
};

/// The truth files of a media folder. @throws std::exception where one cannot be read
std::vector<Truth> read_truths(const std::string& folder);

struct Tally {
    int found = 0;
    int missed = 0;
    int false_alarms = 0;

    Tally& operator+=(const Tally& other);
    double f1() const;
};

struct Score {
    Tally cuts;     // +-1 frame; a cut at the very end of a found fade (to or from black) is found as well
    Tally gradual;  // by overlap, +-2 frames
    Tally all;      // whatever the kind
    std::vector<std::string> mistakes;
};

Score score_of(const Truth& truth, const std::vector<Transition>& found);

}  // namespace vitrine
