#pragma once

#include "base/settings/settings.hpp"

#include <filesystem>
#include <string>

namespace vitrine {

/// What is asked of one weaving.
struct WeaveRequest {
    std::filesystem::path file;
    std::filesystem::path directory;  // for the pyramid; empty: none
    std::filesystem::path sheet;      // a PNG; empty: none
    int levels = 32;
    std::filesystem::path times;  // a file of times in seconds, one a line; empty: none
    bool is_uniform = false;
};

/// Weaves the tapestry of one film, into a folder or as a sheet.
/// @return what was made, for the log
/// @throws std::exception that names the file
std::string weave_file(const WeaveRequest& request, const Settings& settings);

}  // namespace vitrine
