#pragma once

#include "analyzer/film/transition.hpp"
#include "base/state/record.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The true transitions of one film, in stream time.
struct Truth {
    std::string file;
    double fps = 25;
    std::vector<Transition> transitions;
    std::vector<Transition> ignored;  // ranges in which nothing is judged
    std::vector<Stretch> pictures;    // neither transition, black nor title; none in a film of one take
    bool is_one_take = false;         // all that is found is wrong
};

/// The truths in FOLDER/*/gt/*.json. @throws std::exception where one cannot be read
std::vector<Truth> read_truths(const std::filesystem::path& folder);

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

    Score& operator+=(const Score& other);
};

/// The names that a detector gives to the transitions it finds.
enum class Names {
    kinds,  // a cut reported within a dissolve is false among the cuts
    none    // only times: what lies in a gradual transition finds it and is no false cut
};

Score score_of(const Truth& truth, const std::vector<Transition>& found, Names names = Names::kinds);

}  // namespace vitrine::analyzer
