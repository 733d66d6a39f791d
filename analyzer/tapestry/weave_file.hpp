#pragma once

#include "base/settings/settings.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// The options of one weaving.
struct WeaveRequest {
    std::filesystem::path file;
    std::filesystem::path directory;  // for the pyramid; empty: none
    std::filesystem::path sheet;      // a PNG; empty: none
    std::filesystem::path zoom;       // a PNG of the zoom between the two coarsest levels; empty: none
    std::filesystem::path html;       // a folder for a page that any browser shows; empty: none
    std::filesystem::path poster;     // a PNG of the coarsest level; empty: none
    int poster_height = 2000;         // px
    int levels = 32;
    std::filesystem::path times;      // a file of times in seconds, one a line; empty: none
    std::filesystem::path keyframes;  // a choice of keyframes, see base/hints/keyframe_choice; empty: none
    bool is_uniform = false;
    bool resumes = false;         // an interrupted weaving of the pyramid goes on
    std::uint64_t max_bytes = 0;  // for the pyramid, approximately; 0: any
    int threads = 0;              // 0: one a core
    bool is_alone = false;  // this process does nothing else: it enters the sandbox of a reader for good

    /// The first result that is asked for; empty where none is.
    const std::filesystem::path& result() const {
        for (const std::filesystem::path* one : {&directory, &html, &sheet, &zoom})
            if (!one->empty()) return *one;
        return poster;
    }
};

/// Weaves the tapestry of one film: into a folder, as a page for browsers, as sheets, as a poster.
/// @return the levels made, in words for the log; with a poster its size, and how much it is enlarged
/// @throws std::exception that names the file
std::string weave_file(const WeaveRequest& request, const Settings& settings);

}  // namespace vitrine::analyzer
