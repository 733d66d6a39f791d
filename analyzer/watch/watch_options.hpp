#pragma once

#include "analyzer/one_file/analysis_outputs.hpp"
#include "analyzer/store/store.hpp"
#include "analyzer/store/store_place.hpp"
#include "analyzer/watch/analyses.hpp"
#include "analyzer/watch/schedule.hpp"
#include "base/settings/choices.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// All that the daemon needs to know.
struct WatchOptions {
    std::filesystem::path root;       // the media folder
    std::filesystem::path catalogue;  // the directory of records
    std::filesystem::path store;
    std::filesystem::path state;               // hints.json, status.json, thumbnails/, words/ and wall.jpg
    std::vector<std::string> thumbnail_child;  // makes a thumbnail; the file is appended. Empty: none is made
    std::vector<std::string> words_child;      // sets words; they are appended. Empty: none are set
    CaptionChoice captions = CaptionChoice::none;  // those that are set
    std::string status_folder;                     // in the media folder, for its operators; empty: none
    StoreBounds bounds{.max_bytes = 0, .min_free_bytes = usual_free_bytes};
    AnalysisCommand analysis;
    AnalysisOutputs outputs;          // each analysis writes these
    std::vector<std::string> weave;   // the command that weaves a tapestry; see WeaveOptions
    std::vector<std::string> refine;  // the command that finds a region by the network; see RefineOptions
    StoreBounds tapestries{.max_bytes = 0, .min_free_bytes = usual_free_bytes};
    Pace pace;
    std::chrono::milliseconds rescan{60'000};
    bool is_once = false;  // ends the loop as soon as the catalogue is up to date and all films are woven
    bool weaves = true;    // false: tapestries are left to a later run
};

}  // namespace vitrine::analyzer
